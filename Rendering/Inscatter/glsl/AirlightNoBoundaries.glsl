// A light without shadows: no boundaries. The ray's airlight is then that without shadows; found a
// second time it would take compilers twice as long.
#define AIRLIGHT_NO_BOUNDARIES

const int airlightBoundaryCount = 0;
const int airlightBoundaryWeights = 0;

bool airlightOpenBoundaries(ivec2 pixel, float unit, float surface)
{
  return true;
}

void airlightBeginBoundaries(AirlightRay ray, inout float from, inout AirlightCounts shadows) {}

int airlightNextBoundary(out float t, out AirlightCounts weight)
{
  t = 0.0;
  weight = airlightNoCounts();
  return AIRLIGHT_END;
}

void airlightCloseBoundaries(ivec2 pixel, int state, float from, AirlightCounts shadows) {}
