// What the medium before a fragment scatters to the eye, from a froxel grid.

vec3 airlightInscatterToFragment(vec3 origin, vec3 direction, float t)
{
  vec2 p = airlightPixel();
  float place = airlightFroxelPlace(t / airlightRayUnit(p));
  vec3 once = airlightFroxel(0, p, place).rgb;
  return airlightDiffuse(airlightMedia, origin, direction, t, once) + once;
}
