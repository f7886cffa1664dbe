// The boundaries of a pixel's list, which AirlightSortFS.glsl put in order, read as those in slots are
// (AirlightSortedSlots.glsl).

const uint AIRLIGHT_NO_KEY = 0xffffffffu;

layout(std430, binding = AIRLIGHT_BINDING_BOUNDARIES) readonly buffer AirlightNodes
{
  uint nodes[];
};

uint listNode;
int keysLeft;  // boundaries before the end
int keysTotal; // sum of their weights

// False where there is no list.
bool airlightOpenKeys(ivec2 pixel, float end)
{
  keysTotal = 0;
  keysLeft = 0;
  listNode = heads[airlightHeadIndex(pixel)];
  for (uint node = listNode; node != 0u; node = nodes[AIRLIGHT_NODE_WORDS * node + 2u])
  {
    uint key = nodes[AIRLIGHT_NODE_WORDS * node];
    if (!(airlightKeyDistance(key) < end))
    {
      break;
    }
    keysTotal += airlightKeyWeight(key);
    keysLeft++;
  }
  return listNode != 0u;
}

uint airlightNextKey()
{
  uint key = listNode != 0u ? nodes[AIRLIGHT_NODE_WORDS * listNode] : AIRLIGHT_NO_KEY;
  listNode = listNode != 0u ? nodes[AIRLIGHT_NODE_WORDS * listNode + 2u] : 0u;
  keysLeft--;
  return key;
}
