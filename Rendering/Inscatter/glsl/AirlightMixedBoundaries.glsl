// The boundaries of a pixel from shadow volumes and from a shadow map, in order of both.

struct AirlightNext
{
  int state;
  float t;
  int weight;
};

AirlightNext nextOfPlanes;
AirlightNext nextOfMap;
int mapCounts; // the map's part of the counts
#if AIRLIGHT_MIXED_COUNTED
int airlightBoundaryCount;
int airlightBoundaryWeights;
#endif

bool airlightOpenBoundaries(ivec2 pixel, float unit, float surface)
{
  return airlightOpenBoundariesOfMap(pixel, unit, surface) &&
    airlightOpenBoundariesOfPlanes(pixel, unit, surface);
}

void airlightBeginBoundaries(AirlightRay ray, inout float from, inout int shadows)
{
  airlightBeginBoundariesOfPlanes(ray, from, shadows);
  mapCounts = 0;
  airlightBeginBoundariesOfMap(ray, from, mapCounts);
  shadows += mapCounts;
  nextOfPlanes.state = airlightNextBoundaryOfPlanes(nextOfPlanes.t, nextOfPlanes.weight);
  nextOfMap.state = airlightNextBoundaryOfMap(nextOfMap.t, nextOfMap.weight);
#if AIRLIGHT_MIXED_COUNTED
  airlightBoundaryCount = airlightBoundaryCountOfPlanes + airlightBoundaryCountOfMap;
  airlightBoundaryWeights = airlightBoundaryWeightsOfPlanes + airlightBoundaryWeightsOfMap;
#endif
}

int airlightNextBoundary(out float t, out int weight)
{
  bool ofMap = nextOfPlanes.state == AIRLIGHT_END ||
    (nextOfPlanes.state == AIRLIGHT_MORE && nextOfMap.state == AIRLIGHT_MORE &&
      nextOfMap.t < nextOfPlanes.t);
  AirlightNext next = ofMap ? nextOfMap : nextOfPlanes;
  AirlightNext later;
  if (ofMap)
  {
    later.state = airlightNextBoundaryOfMap(later.t, later.weight);
    nextOfMap = later;
    mapCounts += next.state == AIRLIGHT_MORE ? next.weight : 0;
  }
  else
  {
    later.state = airlightNextBoundaryOfPlanes(later.t, later.weight);
    nextOfPlanes = later;
  }
  t = next.t;
  weight = next.weight;
  return next.state;
}

// After a pause, which is only where memory is short of a k-buffer, the map is looked up again from
// there on. What it began or ended between there and the last boundary of the planes counts again.
void airlightCloseBoundaries(ivec2 pixel, int state, float from, int shadows)
{
  airlightCloseBoundariesOfPlanes(pixel, state, from, shadows - mapCounts);
}
