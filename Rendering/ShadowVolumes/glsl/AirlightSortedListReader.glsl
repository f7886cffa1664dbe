// The boundaries of a pixel's list, which AirlightSortFS.glsl put in order, some of them a draw.

uniform int resume; // 0: the first draw of the sorted lists

uint boundaryNode;
uint boundaryLast;
int boundariesLeft;

#if AIRLIGHT_SHADOW_TRANSMITTANCE

uint boundaryPrevious; // the last but one

// What a pause leaves takes the last two boundaries read, the first of which becomes the head.
void airlightLeave(float from, AirlightCounts shadows)
{
  uint a = AIRLIGHT_NODE_WORDS * boundaryPrevious;
  uint b = AIRLIGHT_NODE_WORDS * boundaryLast;
  nodes[a] = floatBitsToUint(from);
  nodes[b] = floatBitsToUint(airlightRunStart);
  nodes[a + AIRLIGHT_NODE_WEIGHT] = uint(shadows.blocks.r);
  nodes[b + AIRLIGHT_NODE_WEIGHT] = uint(shadows.thickness.r);
  for (uint i = 1u; i < 3u; i++)
  {
    nodes[a + AIRLIGHT_NODE_THICKNESS + i - 1u] = uint(shadows.blocks[i]);
    nodes[b + AIRLIGHT_NODE_THICKNESS + i - 1u] = uint(shadows.thickness[i]);
  }
}

void airlightTakeUp(out float from, out AirlightCounts shadows)
{
  uint a = AIRLIGHT_NODE_WORDS * boundaryNode;
  uint b = AIRLIGHT_NODE_WORDS * nodes[a + AIRLIGHT_NODE_NEXT];
  from = uintBitsToFloat(nodes[a]);
  airlightRunStart = uintBitsToFloat(nodes[b]);
  shadows.blocks.r = int(nodes[a + AIRLIGHT_NODE_WEIGHT]);
  shadows.thickness.r = int(nodes[b + AIRLIGHT_NODE_WEIGHT]);
  for (uint i = 1u; i < 3u; i++)
  {
    shadows.blocks[i] = int(nodes[a + AIRLIGHT_NODE_THICKNESS + i - 1u]);
    shadows.thickness[i] = int(nodes[b + AIRLIGHT_NODE_THICKNESS + i - 1u]);
  }
  boundaryNode = nodes[b + AIRLIGHT_NODE_NEXT];
}

#else

void airlightLeave(float from, int shadows)
{
  nodes[AIRLIGHT_NODE_WORDS * boundaryLast] = floatBitsToUint(from);
  nodes[AIRLIGHT_NODE_WORDS * boundaryLast + AIRLIGHT_NODE_WEIGHT] = uint(shadows);
}

void airlightTakeUp(out float from, out int shadows)
{
  uint word = AIRLIGHT_NODE_WORDS * boundaryNode;
  from = uintBitsToFloat(nodes[word]);
  shadows = int(nodes[word + AIRLIGHT_NODE_WEIGHT]);
  boundaryNode = nodes[word + AIRLIGHT_NODE_NEXT];
}

#endif

bool airlightOpenBoundaries(ivec2 pixel, float unit, float surface)
{
  airlightEndBoundaries(unit, surface);
  boundaryNode = listHeads[airlightHeadIndex(pixel)];
  boundaryLast = 0u;
  boundariesLeft = AIRLIGHT_CHUNK;
  return boundaryNode != 0u;
}

// A pause leaves its distance and its counts in the last boundary read, which becomes the head.
void airlightBeginBoundaries(AirlightRay ray, inout float from, inout AirlightCounts shadows)
{
  if (boundaryNode != 0u && resume != 0)
  {
    airlightTakeUp(from, shadows);
  }
}

int airlightNextBoundary(out float t, out AirlightCounts weight)
{
  t = airlightNodeDistance(boundaryNode);
  weight = airlightNodeWeight(boundaryNode);
  bool last = boundaryNode == 0u || !(t < boundaryEnd);
  t *= boundaryUnit;
  if (last || boundariesLeft == 0)
  {
    return last ? AIRLIGHT_END : AIRLIGHT_PAUSE;
  }
  boundariesLeft--;
#if AIRLIGHT_SHADOW_TRANSMITTANCE
  boundaryPrevious = boundaryLast;
#endif
  boundaryLast = boundaryNode;
  boundaryNode = airlightNextNode(boundaryNode);
  return AIRLIGHT_MORE;
}

void airlightCloseBoundaries(ivec2 pixel, int state, float from, AirlightCounts shadows)
{
#if AIRLIGHT_SHADOW_TRANSMITTANCE
  uint paused = boundaryPrevious;
#else
  uint paused = boundaryLast;
#endif
  listHeads[airlightHeadIndex(pixel)] = state == AIRLIGHT_PAUSE ? paused : 0u;
  if (state == AIRLIGHT_PAUSE)
  {
    airlightLeave(from, shadows);
  }
}
