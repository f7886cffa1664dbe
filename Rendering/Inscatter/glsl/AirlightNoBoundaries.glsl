// A light without shadows: no boundaries.

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
