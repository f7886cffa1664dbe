// Where the boundaries of a pixel lie: in slots of its own, as many as AIRLIGHT_K_BUFFER_SIZE, in
// the order in which they were drawn. Those of a row of pixels lie together, the first slots of all
// first: most pixels have few boundaries, and memory is fast where what is read lies in a row. What
// has no slot goes into a list (AirlightPlanesFS.glsl).
//
// A slot holds one number, by which boundaries are sorted: the bits of the distance, on the unit of
// airlightDirection() or in parallel projection as it is; they grow with it. The last two are
// replaced by the weight: 2, 1, -1, -2 as 0 to 3. So boundaries at one distance come as entries
// before exits, and volumes that touch stay joined.

layout(std430, binding = AIRLIGHT_BINDING_K_BUFFER) buffer AirlightKBuffer
{
  uint kBuffer[];
};

// The pixel's first slot.
uint airlightKBufferStart(ivec2 pixel)
{
  return uint((pixel.y - listLayout.x) * AIRLIGHT_K_BUFFER_SIZE * listLayout.y + pixel.x);
}

// The k-th from there on.
uint airlightKBufferIndex(uint first, uint k)
{
  return first + k * uint(listLayout.y);
}

uint airlightPackBoundary(float t, int weight)
{
  uint code = uint(weight > 0 ? 2 - weight : 1 - weight);
  return ((floatBitsToUint(max(t, 0.0)) + 2u) & ~3u) | code;
}

float airlightPackedDistance(uint boundary)
{
  return uintBitsToFloat(boundary & ~3u);
}

int airlightPackedWeight(uint boundary)
{
  int code = int(boundary & 3u);
  return code < 2 ? 2 - code : 1 - code;
}
