// Added to the mappers' fragment shaders where fragments are drawn over the medium behind them: what
// the medium before each fragment makes of its colour, before it is blended.

uniform int airlightThroughMedium; // 1: do so; 2: for fragments that are added to what is behind
uniform AirlightLight airlightLights[AIRLIGHT_LAMPS];

// Scattered into the ray before its fragment, shadows left out of account.
vec3 airlightBefore(vec3 origin, vec3 direction, float t)
{
  vec3 sum = airlightAmbient(airlightMedia, origin, direction, t);
  for (int k = 0; k < airlightLampCount; k++)
  {
    if (airlightLamps[k].w >= 0.0)
    {
      AirlightRay ray = airlightRay(airlightMedia, airlightLights[k], origin, direction, t);
      if (ray.lit.y > ray.lit.x)
      {
        vec3 tail = airlightTail3(airlightMedia, airlightLights[k], ray, ray.lit.x);
        sum += airlightInterval3(airlightMedia, airlightLights[k], ray, ray.lit.x, tail, ray.lit.y,
          airlightTail3(airlightMedia, airlightLights[k], ray, ray.lit.y));
      }
    }
  }
  return sum;
}

vec3 airlightThrough(vec3 colour)
{
  if (airlightThroughMedium == 0)
  {
    return colour;
  }
  vec2 p = airlightPixel();
  vec3 origin = airlightOrigin(p);
  vec3 direction = normalize(airlightDirection(p));
  float t = airlightFragmentDistance();
  vec3 passes = exp(-airlightDepth(airlightMedia, origin, direction, t));
  return airlightThroughMedium == 2 ? colour * passes
                                    : colour * passes + airlightBefore(origin, direction, t);
}
