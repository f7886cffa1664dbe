// One step of a merge sort of the pixels' long lists, in place: runs of `run` boundaries that are
// in order become runs of twice as many. Linked lists are merged by changing links only (R.
// Sedgewick, Algorithms, on merge sort of lists). A step walks each list twice; the number of steps
// is the logarithm of the longest list's length. Split into draws because some software renderers
// bound the iterations of all loops of one shader run together.

layout(std430, binding = AIRLIGHT_BINDING_BOUNDARIES) buffer AirlightNodes
{
  uint nodes[];
};

uniform uint run;

// By distance; at one distance entries before exits.
bool airlightInscatterToFragment(uint a, uint b)
{
#if AIRLIGHT_K_BUFFER_SIZE > 0
  return nodes[AIRLIGHT_NODE_WORDS * a] <= nodes[AIRLIGHT_NODE_WORDS * b];
#else
  float ta = uintBitsToFloat(nodes[AIRLIGHT_NODE_WORDS * a]);
  float tb = uintBitsToFloat(nodes[AIRLIGHT_NODE_WORDS * b]);
  return ta < tb ||
    (ta == tb &&
      int(nodes[AIRLIGHT_NODE_WORDS * a + 1u]) >= int(nodes[AIRLIGHT_NODE_WORDS * b + 1u]));
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
      right = nodes[AIRLIGHT_NODE_WORDS * right + 2u];
    }
    uint rightSize = run;
    while (leftSize > 0u || (rightSize > 0u && right != 0u))
    {
      bool takeLeft = leftSize > 0u &&
        (rightSize == 0u || right == 0u || airlightInscatterToFragment(left, right));
      uint taken = takeLeft ? left : right;
      if (takeLeft)
      {
        left = nodes[AIRLIGHT_NODE_WORDS * left + 2u];
        leftSize--;
      }
      else
      {
        right = nodes[AIRLIGHT_NODE_WORDS * right + 2u];
        rightSize--;
      }
      if (tail == 0u)
      {
        head = taken;
      }
      else
      {
        nodes[AIRLIGHT_NODE_WORDS * tail + 2u] = taken;
      }
      tail = taken;
    }
    left = right;
  }
  nodes[AIRLIGHT_NODE_WORDS * tail + 2u] = 0u;
  listHeads[headIndex] = head;
}
