// One step of a merge sort of the pixels' long lists, in place: runs of `run` boundaries that are
// in order become runs of twice as many. Linked lists are merged by changing links only (R.
// Sedgewick, Algorithms, on merge sort of lists). A step walks each list twice; the number of steps
// is the logarithm of the longest list's length. Split into draws because some software renderers
// bound the iterations of all loops of one shader run together.

uniform uint run;

// By distance; at one distance entries before exits.
bool airlightIsBefore(uint a, uint b)
{
#if AIRLIGHT_K_BUFFER_SIZE > 0
  return nodes[AIRLIGHT_NODE_WORDS * a] <= nodes[AIRLIGHT_NODE_WORDS * b];
#else
  float ta = airlightNodeDistance(a);
  float tb = airlightNodeDistance(b);
  return ta < tb ||
    (ta == tb &&
      int(nodes[AIRLIGHT_NODE_WORDS * a + AIRLIGHT_NODE_WEIGHT]) >=
        int(nodes[AIRLIGHT_NODE_WORDS * b + AIRLIGHT_NODE_WEIGHT]));
#endif
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  int headIndex = airlightHeadIndex(pixel);
  uint left = listHeads[headIndex];
  if (left == 0u)
  {
    return;
  }
  uint head = 0u;
  uint tail = 0u;
  while (left != 0u)
  {
    uint right = left;
    uint leftSize = 0u;
    for (; leftSize < run && right != 0u; leftSize++)
    {
      right = airlightNextNode(right);
    }
    uint rightSize = run;
    while (leftSize > 0u || (rightSize > 0u && right != 0u))
    {
      bool takeLeft = leftSize > 0u &&
        (rightSize == 0u || right == 0u || airlightIsBefore(left, right));
      uint taken = takeLeft ? left : right;
      if (takeLeft)
      {
        left = airlightNextNode(left);
        leftSize--;
      }
      else
      {
        right = airlightNextNode(right);
        rightSize--;
      }
      if (tail == 0u)
      {
        head = taken;
      }
      else
      {
        nodes[AIRLIGHT_NODE_WORDS * tail + AIRLIGHT_NODE_NEXT] = taken;
      }
      tail = taken;
    }
    left = right;
  }
  nodes[AIRLIGHT_NODE_WORDS * tail + AIRLIGHT_NODE_NEXT] = 0u;
  listHeads[headIndex] = head;
}
