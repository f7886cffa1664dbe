// Added to the mappers' fragment shaders where light that was scattered more than once lights
// surfaces, too.

uniform mat3 airlightNormalToWorld; // from view coordinates

// As in AirlightSurfaceIrradiance.glsl.
vec3 airlightScatteredColour(vec3 normal)
{
  if (airlightStage != AIRLIGHT_STAGE_COLOUR && airlightStage != AIRLIGHT_STAGE_TRANSLUCENT)
  {
    return vec3(0.0);
  }
  return airlightMultipleIrradiance(
    airlightFragmentPoint(), normalize(airlightNormalToWorld * normal)) /
    3.14159265358979;
}
