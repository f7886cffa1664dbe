// Pixels with more boundaries than slots: what the slots hold joins their lists. Each run of as many
// boundaries as there are slots is put in order, in the registers of AirlightSortedSlots.glsl, for
// AirlightSortFS.glsl to merge.

layout(std430, binding = AIRLIGHT_BINDING_BOUNDARIES) buffer AirlightNodes
{
  uint nodes[];
};

// Puts a run of the list in order. Returns what follows it.
uint sortRun(uint node)
{
  airlightClearKeys();
  uint next = node;
  for (int i = 0; i < AIRLIGHT_SLOTS && next != 0u; i++)
  {
    airlightInsertFar(airlightInsertNear(nodes[AIRLIGHT_NODE_WORDS * next]));
    next = nodes[AIRLIGHT_NODE_WORDS * next + 2u];
  }
  for (uint at = node; at != next; at = nodes[AIRLIGHT_NODE_WORDS * at + 2u])
  {
    nodes[AIRLIGHT_NODE_WORDS * at] = airlightNextKey();
  }
  return next;
}

// Puts what the slots hold in order, before `next` and from `index` on.
void sortSlots(uint first, uint index, uint next)
{
  airlightClearKeys();
  for (int i = 0; i < AIRLIGHT_SLOTS; i++)
  {
    airlightInsertFar(airlightInsertNear(slots[airlightSlot(first, uint(i))]));
  }
  for (uint i = 0u; i < uint(AIRLIGHT_SLOTS); i++)
  {
    uint word = AIRLIGHT_NODE_WORDS * (index + i);
    nodes[word] = airlightNextKey();
    nodes[word + 2u] = i + 1u < uint(AIRLIGHT_SLOTS) ? index + i + 1u : next;
  }
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint count = heads[airlightCountIndex(pixel)];
  if (count <= uint(AIRLIGHT_SLOTS))
  {
    return;
  }
  atomicMax(heads[1], count);
  uint index = atomicAdd(heads[0], uint(AIRLIGHT_SLOTS)) + 1u;
  if (index + uint(AIRLIGHT_SLOTS) > uint(nodes.length()) / AIRLIGHT_NODE_WORDS)
  {
    return;
  }
  uint head = heads[airlightHeadIndex(pixel)];
  for (uint node = head; node != 0u;)
  {
    node = sortRun(node);
  }
  sortSlots(airlightFirstSlot(pixel), index, head);
  heads[airlightHeadIndex(pixel)] = index;
}
