// Added to the mappers' fragment shaders where fragments are drawn over the medium behind them:
// what the medium before each fragment makes of its colour, before it is blended.

#if AIRLIGHT_AT_VERTICES
in vec3 airlightPassesVSOutput; // named so that VTK knows it for a vertex shader's
in vec3 airlightAddedVSOutput;
#endif
uniform int airlightAdditive; // 1: for fragments that are added to what is behind

vec3 airlightApplyMedium(vec3 colour)
{
  if (airlightStage != AIRLIGHT_STAGE_TRANSLUCENT)
  {
    return colour;
  }
  colour = airlightFinite(colour);
#if AIRLIGHT_ENCODED_INPUT
  colour = airlightDecode(colour);
#endif
#if AIRLIGHT_AT_VERTICES
  return colour * airlightPassesVSOutput + airlightAddedVSOutput;
#else
  vec2 p = airlightPixel();
  vec3 origin = airlightOrigin(p);
  vec3 direction = normalize(airlightDirection(p));
  float t = airlightFragmentDistance();
  vec3 passes = exp(-airlightDepth(origin, direction, t));
  return airlightAdditive != 0
    ? colour * passes
    : colour * passes + airlightInscatterToFragment(origin, direction, t);
#endif
}
