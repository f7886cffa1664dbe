// The boundaries in a pixel's slots, in order of distance.

const uint AIRLIGHT_NO_KEY = 0xffffffffu;

// Compilers keep it in registers: all its indices are known to them.
uint slotKeys[AIRLIGHT_SLOTS];
int slotCount;  // of boundaries that are left
int slotsTotal; // sum of all weights

void airlightInsertKey(uint key)
{
  for (int i = 0; i < AIRLIGHT_SLOTS; i++)
  {
    uint less = min(slotKeys[i], key);
    key = max(slotKeys[i], key);
    slotKeys[i] = less;
  }
}

// False where there are more boundaries than slots.
bool airlightReadSlots(ivec2 pixel)
{
  for (int i = 0; i < AIRLIGHT_SLOTS; i++)
  {
    slotKeys[i] = AIRLIGHT_NO_KEY;
  }
  slotsTotal = 0;
  slotCount = int(heads[airlightCountIndex(pixel)]);
  if (slotCount > AIRLIGHT_SLOTS)
  {
    return false;
  }
  uint first = airlightFirstSlot(pixel);
  for (int i = 0; i < slotCount; i++)
  {
    uint key = slots[first + uint(64 * i)];
    slotsTotal += airlightKeyWeight(key);
    airlightInsertKey(key);
  }
  return true;
}

// The nearest one; AIRLIGHT_NO_KEY where none is left.
uint airlightNextKey()
{
  uint key = slotKeys[0];
  for (int i = 0; i + 1 < AIRLIGHT_SLOTS; i++)
  {
    slotKeys[i] = slotKeys[i + 1];
  }
  slotKeys[AIRLIGHT_SLOTS - 1] = AIRLIGHT_NO_KEY;
  slotCount--;
  return key;
}
