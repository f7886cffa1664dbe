// The boundaries of a pixel's list, which AirlightSortFS.glsl put in order, read as those in slots
// are (AirlightSortedKBuffer.glsl).

const uint AIRLIGHT_NO_BOUNDARY = 0xffffffffu;

layout(std430, binding = AIRLIGHT_BINDING_BOUNDARIES) readonly buffer AirlightNodes
{
  uint nodes[];
};

uint listNode;
int packedLeft;  // boundaries before the end
int packedWeights; // sum of their weights

// False where there is no list.
bool airlightOpenPacked(ivec2 pixel, float end)
{
  packedWeights = 0;
  packedLeft = 0;
  listNode = listHeads[airlightHeadIndex(pixel)];
  for (uint node = listNode; node != 0u; node = nodes[AIRLIGHT_NODE_WORDS * node + 2u])
  {
    uint boundary = nodes[AIRLIGHT_NODE_WORDS * node];
    if (!(airlightPackedDistance(boundary) < end))
    {
      break;
    }
    packedWeights += airlightPackedWeight(boundary);
    packedLeft++;
  }
  return listNode != 0u;
}

uint airlightNextPacked()
{
  uint boundary = listNode != 0u ? nodes[AIRLIGHT_NODE_WORDS * listNode] : AIRLIGHT_NO_BOUNDARY;
  listNode = listNode != 0u ? nodes[AIRLIGHT_NODE_WORDS * listNode + 2u] : 0u;
  packedLeft--;
  return boundary;
}
