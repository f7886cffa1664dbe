// The boundaries in a pixel's slots, in order of distance.

const uint AIRLIGHT_NO_KEY = 0xffffffffu;

// The nearest first, 16 or 32 of them: AIRLIGHT_SLOTS. Not an array, which some drivers do not keep in
// registers.
uvec4 slotKeysA;
uvec4 slotKeysB;
uvec4 slotKeysC;
uvec4 slotKeysD;
#if AIRLIGHT_SLOTS > 16
uvec4 slotKeysE;
uvec4 slotKeysF;
uvec4 slotKeysG;
uvec4 slotKeysH;
#endif
int keysLeft;  // of boundaries that are left
int keysTotal; // sum of all weights

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

void airlightClearKeys()
{
  slotKeysA = uvec4(AIRLIGHT_NO_KEY);
  slotKeysB = slotKeysA;
  slotKeysC = slotKeysA;
  slotKeysD = slotKeysA;
#if AIRLIGHT_SLOTS > 16
  slotKeysE = slotKeysA;
  slotKeysF = slotKeysA;
  slotKeysG = slotKeysA;
  slotKeysH = slotKeysA;
#endif
}

// Puts a key among the nearest 16; returns what is left over.
uint airlightInsertNear(uint key)
{
  airlightInsertKey(slotKeysA, key);
  airlightInsertKey(slotKeysB, key);
  airlightInsertKey(slotKeysC, key);
  airlightInsertKey(slotKeysD, key);
  return key;
}

// Puts it among the others.
void airlightInsertFar(uint key)
{
#if AIRLIGHT_SLOTS > 16
  airlightInsertKey(slotKeysE, key);
  airlightInsertKey(slotKeysF, key);
  airlightInsertKey(slotKeysG, key);
  airlightInsertKey(slotKeysH, key);
#endif
}

// What a slot holds; AIRLIGHT_NO_KEY if that lies beyond `end`.
uint airlightReadSlot(uint slot, float end)
{
  uint key = slots[slot];
  bool before = airlightKeyDistance(key) < end;
  keysTotal += before ? airlightKeyWeight(key) : 0;
  keysLeft += before ? 1 : 0;
  return before ? key : AIRLIGHT_NO_KEY;
}

// False where there are more boundaries than slots. What lies beyond `end`, on the unit of
// airlightDirection(), is left out.
bool airlightOpenKeys(ivec2 pixel, float end)
{
  airlightClearKeys();
  keysTotal = 0;
  keysLeft = 0;
  int all = int(heads[airlightCountIndex(pixel)]);
  // Without min(count, 16): compilers unroll loops whose greatest length they see, and software renderers
  // run through all of an unrolled one for every pixel.
  int count = all * int(all <= AIRLIGHT_SLOTS);
  uint first = airlightFirstSlot(pixel);
#if AIRLIGHT_SLOTS > 16
  int near = min(count, 16);
#else
  int near = count;
#endif
  for (int i = 0; i < near; i++)
  {
    airlightInsertNear(airlightReadSlot(airlightSlot(first, uint(i)), end));
  }
#if AIRLIGHT_SLOTS > 16
  for (int i = near; i < count; i++)
  {
    airlightInsertFar(airlightInsertNear(airlightReadSlot(airlightSlot(first, uint(i)), end)));
  }
#endif
  return all <= AIRLIGHT_SLOTS;
}

// The nearest one; AIRLIGHT_NO_KEY where none is left.
uint airlightNextKey()
{
  uint key = slotKeysA.x;
  slotKeysA = uvec4(slotKeysA.yzw, slotKeysB.x);
  slotKeysB = uvec4(slotKeysB.yzw, slotKeysC.x);
  slotKeysC = uvec4(slotKeysC.yzw, slotKeysD.x);
#if AIRLIGHT_SLOTS > 16
  slotKeysD = uvec4(slotKeysD.yzw, slotKeysE.x);
  slotKeysE = uvec4(slotKeysE.yzw, slotKeysF.x);
  slotKeysF = uvec4(slotKeysF.yzw, slotKeysG.x);
  slotKeysG = uvec4(slotKeysG.yzw, slotKeysH.x);
  slotKeysH = uvec4(slotKeysH.yzw, AIRLIGHT_NO_KEY);
#else
  slotKeysD = uvec4(slotKeysD.yzw, AIRLIGHT_NO_KEY);
#endif
  keysLeft--;
  return key;
}
