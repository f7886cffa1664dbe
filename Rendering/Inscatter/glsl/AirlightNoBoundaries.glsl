// A light without shadows: no boundaries. The ray's airlight is then that without shadows; found a
// second time it would take compilers twice as long.
#define AIRLIGHT_NO_BOUNDARIES

const int AIRLIGHT_MORE = 0;
const int AIRLIGHT_PAUSE = 1;
const int AIRLIGHT_END = 2;

bool airlightOpenBoundaries(
  ivec2 pixel, AirlightRay ray, float surface, inout float from, inout AirlightCounts shadows)
{
  return true;
}

int airlightNextBoundary(out float t, out AirlightCounts weight)
{
  t = 0.0;
  weight = airlightNoCounts();
  return AIRLIGHT_END;
}

void airlightCloseBoundaries(ivec2 pixel, int state, float from, AirlightCounts shadows) {}
