// A light without shadows, for AirlightEquiangularRay.glsl.

int packedLeft = 0;
const int packedWeights = 0;

bool airlightOpenPacked(ivec2 pixel, float end)
{
  return true;
}

uint airlightNextPacked()
{
  packedLeft = -1;
  return 0u;
}

float airlightPackedDistance(uint boundary)
{
  return 0.0;
}

int airlightPackedWeight(uint boundary)
{
  return 0;
}
