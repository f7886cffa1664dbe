// Where the boundaries of a pixel lie: in slots of its own, as many as AIRLIGHT_SLOTS, in the order in
// which they were drawn. The slots of eight by eight pixels lie together, the first ones of all first.
// What has no slot goes into a list (AirlightPlanesFS.glsl).
//
// A slot holds one number, by which boundaries are sorted: the bits of the distance, on the unit of
// airlightDirection() or in parallel projection as it is; they grow with it. The last two are replaced
// by the weight: 2, 1, -1, -2 as 0 to 3. So boundaries at one distance come as entries before exits,
// and volumes that touch stay joined.

layout(std430, binding = 7) buffer AirlightSlots
{
  uint slots[];
};

// The pixel's first slot. Each further one is 64 words on.
uint airlightFirstSlot(ivec2 pixel)
{
  ivec2 p = ivec2(pixel.x, pixel.y - places.x);
  int tile = (p.y >> 3) * places.y + (p.x >> 3);
  return uint(64 * AIRLIGHT_SLOTS * tile + 8 * (p.y & 7) + (p.x & 7));
}

uint airlightKey(float t, int weight)
{
  uint code = uint(weight > 0 ? 2 - weight : 1 - weight);
  return ((floatBitsToUint(max(t, 0.0)) + 2u) & ~3u) | code;
}

float airlightKeyDistance(uint key)
{
  return uintBitsToFloat(key & ~3u);
}

int airlightKeyWeight(uint key)
{
  int code = int(key & 3u);
  return code < 2 ? 2 - code : 1 - code;
}
