// The boundaries of a pixel's list, which AirlightSortFS.glsl put in order, counted and read in one
// draw.

uint listNode;
int airlightBoundaryCount;
int airlightBoundaryWeights;
int boundariesLeft;

bool airlightOpenBoundaries(ivec2 pixel, float unit, float surface)
{
  airlightEndBoundaries(unit, surface);
  airlightBoundaryWeights = 0;
  airlightBoundaryCount = 0;
  listNode = listHeads[airlightHeadIndex(pixel)];
  for (uint node = listNode; node != 0u; node = airlightNextNode(node))
  {
    if (!(airlightNodeDistance(node) < boundaryEnd))
    {
      break;
    }
    airlightBoundaryWeights += airlightNodeWeight(node);
    airlightBoundaryCount++;
  }
  boundariesLeft = airlightBoundaryCount;
  return listNode != 0u;
}

void airlightBeginBoundaries(AirlightRay ray, inout float from, inout int shadows) {}

int airlightNextBoundary(out float t, out int weight)
{
  t = boundaryUnit * airlightNodeDistance(listNode);
  weight = airlightNodeWeight(listNode);
  listNode = listNode != 0u ? airlightNextNode(listNode) : 0u;
  boundariesLeft--;
  return boundariesLeft >= 0 ? AIRLIGHT_MORE : AIRLIGHT_END;
}

void airlightCloseBoundaries(ivec2 pixel, int state, float from, int shadows) {}
