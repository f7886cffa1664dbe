// A light without shadows: no boundaries.

void airlightOpenBoundaries(ivec2 pixel) {}

bool airlightNextBoundary(out float t, out int weight)
{
  t = 0.0;
  weight = 0;
  return false;
}
