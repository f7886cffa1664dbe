// A light without shadows: no boundaries.

const int AIRLIGHT_MORE = 0;
const int AIRLIGHT_PAUSE = 1;
const int AIRLIGHT_END = 2;

bool airlightOpenBoundaries(
  ivec2 pixel, AirlightRay ray, float surface, inout float from, inout int shadows)
{
  return true;
}

int airlightNextBoundary(out float t, out int weight)
{
  t = 0.0;
  weight = 0;
  return AIRLIGHT_END;
}

void airlightCloseBoundaries(ivec2 pixel, int state, float from, int shadows) {}
