// What the medium before a fragment scatters to the eye, from a froxel grid.

vec3 airlightInscatterToFragment(vec3 origin, vec3 direction, float t)
{
  vec2 p = airlightPixel();
  float place = airlightFroxelPlace(t / airlightRayUnit(p));
  vec3 once = airlightFroxel(0, p, place).rgb;
#if AIRLIGHT_MULTIPLE
  // The grid does not know its lights apart: they share their shadows.
  AirlightMultipleRay sum = AirlightMultipleRay(vec3(0.0), vec3(0.0));
  for (int i = 0; i < AIRLIGHT_MULTIPLE_LIGHTS; i++)
  {
    AirlightMultipleRay ray = airlightMultipleAlong(i, origin, direction, t);
    sum.several += ray.several;
    sum.once += ray.once;
  }
  once += airlightMultipleShaded(sum, once, true);
#endif
  return airlightAmbient(origin, direction, t) + once;
}
