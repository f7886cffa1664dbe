// Distance of this fragment along its pixel's unit ray. gl_FragCoord.w is the reciprocal of the
// depth along the camera's axis in full single precision, at any ratio of the clipping range,
// where a depth buffer keeps 24 bits of a hyperbola.
float airlightFragmentDistance()
{
  return airlightParallel != 0
    ? airlightDepthToDistance.x + airlightDepthToDistance.y * gl_FragCoord.z
    : length(airlightDirection(airlightPixel())) / gl_FragCoord.w;
}
