// Pixels with more boundaries than slots: what the slots hold joins their lists. Each run of as
// many boundaries as there are slots is put in order, in the registers of
// AirlightSortedKBuffer.glsl, for AirlightSortFS.glsl to merge.

// Puts a run of the list in order. Returns what follows it.
uint sortRun(uint node)
{
  airlightClearSorted();
  uint next = node;
  for (int i = 0; i < AIRLIGHT_K_BUFFER_SIZE && next != 0u; i++)
  {
    airlightInsertFar(airlightInsertNear(nodes[AIRLIGHT_NODE_WORDS * next]));
    next = airlightNextNode(next);
  }
  for (uint at = node; at != next; at = airlightNextNode(at))
  {
    nodes[AIRLIGHT_NODE_WORDS * at] = airlightTakeNearest();
  }
  return next;
}

// Puts what the slots hold in order, before `next` and from `index` on.
void sortSlots(uint first, uint index, uint next)
{
  airlightClearSorted();
  for (int i = 0; i < AIRLIGHT_K_BUFFER_SIZE; i++)
  {
    airlightInsertFar(airlightInsertNear(kBuffer[airlightKBufferIndex(first, uint(i))]));
  }
  for (uint i = 0u; i < uint(AIRLIGHT_K_BUFFER_SIZE); i++)
  {
    uint word = AIRLIGHT_NODE_WORDS * (index + i);
    nodes[word] = airlightTakeNearest();
    bool last = i + 1u == uint(AIRLIGHT_K_BUFFER_SIZE);
    nodes[word + AIRLIGHT_NODE_NEXT] = last ? next : index + i + 1u;
  }
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint count = listHeads[airlightCountIndex(pixel)];
  if (count <= uint(AIRLIGHT_K_BUFFER_SIZE))
  {
    return;
  }
  atomicMax(listHeads[1], count);
  uint index = atomicAdd(listHeads[0], uint(AIRLIGHT_K_BUFFER_SIZE)) + 1u;
  if (index + uint(AIRLIGHT_K_BUFFER_SIZE) > uint(nodes.length()) / AIRLIGHT_NODE_WORDS)
  {
    return;
  }
  uint head = listHeads[airlightHeadIndex(pixel)];
  for (uint node = head; node != 0u;)
  {
    node = sortRun(node);
  }
  sortSlots(airlightKBufferStart(pixel), index, head);
  listHeads[airlightHeadIndex(pixel)] = index;
}
