// A light without shadows, for AirlightTurnedRay.glsl.

int keysLeft = 0;
const int keysTotal = 0;

bool airlightOpenKeys(ivec2 pixel, float end)
{
  return true;
}

uint airlightNextKey()
{
  keysLeft = -1;
  return 0u;
}

float airlightKeyDistance(uint key)
{
  return 0.0;
}

int airlightKeyWeight(uint key)
{
  return 0;
}
