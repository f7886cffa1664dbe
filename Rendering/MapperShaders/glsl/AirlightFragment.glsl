// Where this fragment is on its pixel's ray. gl_FragCoord.w is the reciprocal of the depth along
// the camera's axis in full single precision, at any ratio of the clipping range, where a depth
// buffer keeps 24 bits of a hyperbola.
//
// To the last bit the same in all shaders, if drivers support that: what is drawn with one
// shader is compared with what another drew.
#ifdef GL_ARB_gpu_shader5
#define AIRLIGHT_SAME_EVERYWHERE precise
#else
#define AIRLIGHT_SAME_EVERYWHERE
#endif

// Its distance on the unit of airlightDirection(), which shadow planes' are on, too. Of the ray
// nothing needs to be known.
float airlightFragmentParameter()
{
  AIRLIGHT_SAME_EVERYWHERE float t = airlightParallel != 0
    ? airlightDepthToDistance.x + airlightDepthToDistance.y * gl_FragCoord.z
    : 1.0 / gl_FragCoord.w;
  return t;
}

vec3 airlightFragmentPoint()
{
  vec2 p = airlightPixel();
  return airlightOrigin(p) + airlightFragmentParameter() * airlightDirection(p);
}

// Its distance along the unit ray. Written out: some compilers do not see through functions.
float airlightFragmentDistance()
{
  vec2 p = airlightPixel();
  AIRLIGHT_SAME_EVERYWHERE vec3 d =
    airlightRayDirection[0] + p.x * airlightRayDirection[1] + p.y * airlightRayDirection[2];
  AIRLIGHT_SAME_EVERYWHERE float square = d.x * d.x + d.y * d.y + d.z * d.z;
  AIRLIGHT_SAME_EVERYWHERE float t = airlightParallel != 0
    ? airlightDepthToDistance.x + airlightDepthToDistance.y * gl_FragCoord.z
    : sqrt(square) / gl_FragCoord.w;
  return t;
}
