// The boundaries in a pixel's slots, in order of distance.

const uint AIRLIGHT_NO_KEY = 0xffffffffu;

// Sixteen of them, the nearest first: AIRLIGHT_SLOTS. Not an array, which some drivers do not keep in
// registers.
uvec4 slotKeysA;
uvec4 slotKeysB;
uvec4 slotKeysC;
uvec4 slotKeysD;
int slotCount;  // of boundaries that are left
int slotsTotal; // sum of all weights

// Keys that do not decrease, and another one: `key` becomes what is left over.
void airlightInsertKey(inout uvec4 keys, inout uint key)
{
  uvec4 less;
  less.x = min(keys.x, key);
  key = max(keys.x, key);
  less.y = min(keys.y, key);
  key = max(keys.y, key);
  less.z = min(keys.z, key);
  key = max(keys.z, key);
  less.w = min(keys.w, key);
  key = max(keys.w, key);
  keys = less;
}

// False where there are more boundaries than slots. What lies beyond `end`, on the unit of
// airlightDirection(), is left out.
bool airlightReadSlots(ivec2 pixel, float end)
{
  slotKeysA = uvec4(AIRLIGHT_NO_KEY);
  slotKeysB = slotKeysA;
  slotKeysC = slotKeysA;
  slotKeysD = slotKeysA;
  slotsTotal = 0;
  slotCount = 0;
  int count = int(heads[airlightCountIndex(pixel)]);
  if (count > AIRLIGHT_SLOTS)
  {
    return false;
  }
  uint first = airlightFirstSlot(pixel);
  for (int i = 0; i < count; i++)
  {
    uint key = slots[first + uint(64 * i)];
    bool before = airlightKeyDistance(key) < end;
    slotsTotal += before ? airlightKeyWeight(key) : 0;
    slotCount += before ? 1 : 0;
    key = before ? key : AIRLIGHT_NO_KEY;
    airlightInsertKey(slotKeysA, key);
    airlightInsertKey(slotKeysB, key);
    airlightInsertKey(slotKeysC, key);
    airlightInsertKey(slotKeysD, key);
  }
  return true;
}

// The nearest one; AIRLIGHT_NO_KEY where none is left.
uint airlightNextKey()
{
  uint key = slotKeysA.x;
  slotKeysA = uvec4(slotKeysA.yzw, slotKeysB.x);
  slotKeysB = uvec4(slotKeysB.yzw, slotKeysC.x);
  slotKeysC = uvec4(slotKeysC.yzw, slotKeysD.x);
  slotKeysD = uvec4(slotKeysD.yzw, AIRLIGHT_NO_KEY);
  slotCount--;
  return key;
}
