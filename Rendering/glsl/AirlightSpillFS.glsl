// Pixels with more boundaries than slots: what the slots hold joins their lists.

layout(std430, binding = 1) writeonly buffer AirlightNodes
{
  uint nodes[];
};

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint first = airlightFirstSlot(pixel);
  int count = int(heads[airlightCountIndex(pixel)]) > AIRLIGHT_SLOTS ? AIRLIGHT_SLOTS : 0;
  uint next = heads[airlightHeadIndex(pixel)];
  for (int i = 0; i < count; i++)
  {
    uint key = slots[first + uint(64 * i)];
    uint index = atomicAdd(heads[0], 1u) + 1u;
    nodes[AIRLIGHT_NODE_WORDS * index] = floatBitsToUint(airlightKeyDistance(key));
    nodes[AIRLIGHT_NODE_WORDS * index + 1u] = uint(airlightKeyWeight(key));
    nodes[AIRLIGHT_NODE_WORDS * index + 2u] = next;
    next = index;
  }
  if (count > 0)
  {
    heads[airlightHeadIndex(pixel)] = next;
  }
}
