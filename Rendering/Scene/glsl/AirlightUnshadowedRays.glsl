// The airlight of lights whose shadows are left out of account, along whole rays: the composition
// then needs no picture of it.

uniform AirlightLight lights[AIRLIGHT_UNSHADOWED_LIGHTS];

#if AIRLIGHT_EQUIANGULAR

// Of the k-th light.
vec3 airlightUnshadowedRay(int k, vec2 p, vec3 origin, vec3 direction, float unit, float end)
{
  AirlightLight light = lights[k];
  airlightTakeLight(k, light);
  AirlightRay ray = airlightRayBeside(light, origin, direction, end,
    airlightOwnMoment(k, p, unit, light, origin, direction));
#ifdef AIRLIGHT_HEIGHT_FOG
  AirlightSpectrum sum =
    airlightHeightFogRay(airlightMedia.item[0], light, ray, ray.lit.x, ray.lit.y);
#else
  AirlightSpectrum sum = airlightEquiangular(airlightMedia.item[0], ray, ray.lit.x, ray.lit.y);
#endif
  return airlightEquiangularLight(light, ray, sum);
}

#else

uniform AirlightLightPixel lightPixels[AIRLIGHT_UNSHADOWED_LIGHTS];

vec3 airlightUnshadowedRay(int k, vec2 p, vec3 origin, vec3 direction, float unit, float end)
{
  AirlightLight light = lights[k];
#ifdef AIRLIGHT_NO_CONE
  light.cosCone = 0.0;
#endif
  AirlightRay ray = airlightRayBeside(light, origin, direction, end,
    airlightLightMoment(lightPixels[k], light, p, unit, origin, direction));
  vec3 tail = airlightTail3(light, ray, ray.lit.x);
  vec3 sum = airlightInterval3(light, ray, ray.lit.x, tail, ray.lit.y,
    airlightTail3(light, ray, ray.lit.y));
  sum = ray.lit.y > ray.lit.x ? sum : vec3(0.0);
  vec3 sigmaS = vec3(0.0);
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    sigmaS += airlightMedia.item[i].sigmaS;
  }
  return mix(vec3(0.0), sum, greaterThan(sigmaS, vec3(0.0)));
}

#endif

vec3 airlightUnshadowedRays(vec2 p, vec3 origin, vec3 direction, float unit, float end)
{
  vec3 sum = vec3(0.0);
  AIRLIGHT_EACH_LIGHT
  return sum;
}
