// Added to the mappers' fragment shaders where the light that the medium scatters lights surfaces,
// too.

uniform AirlightLight airlightScatteringLights[AIRLIGHT_SCATTERING_LIGHTS];
uniform int airlightScatteringLightCount;
uniform mat3 airlightNormalToWorld; // from view coordinates

// What a light of VTK would have as its colour if it gave, head on, the irradiance that the medium
// gives; `normal` in view coordinates, on the viewer's side.
vec3 airlightScatteredColour(vec3 normal)
{
  if (airlightStage != AIRLIGHT_STAGE_COLOUR && airlightStage != AIRLIGHT_STAGE_TRANSLUCENT)
  {
    return vec3(0.0);
  }
  vec3 point = airlightFragmentPoint();
#if AIRLIGHT_MULTIPLE
  vec3 sum =
    airlightMultipleIrradiance(point, normalize(airlightNormalToWorld * normal));
#else
  vec3 sum = vec3(0.0);
#endif
  for (int k = 0; k < airlightScatteringLightCount; k++)
  {
    sum += airlightScatteredIrradiance(
      airlightScatteringLights[k], point, normalize(airlightNormalToWorld * normal));
  }
  return sum / AIRLIGHT_PI;
}
