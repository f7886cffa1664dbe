// Takes from a light's airlight what translucent casters take of it.

void main()
{
  vec2 p = airlightPixel();
  float depth = texelFetch(distances, ivec2(p), 0).r;
  float place = depth < 0.0 ? float(airlightFroxelNodes - 1) : airlightFroxelPlace(depth);
  vec4 loss = airlightFroxel(1, p, place);
  airlightGive(-loss.rgb, false);
#ifdef AIRLIGHT_RECORD
  single = airlight;
  // Where light changes between two nodes is not known: off by up to half a step, of either sign.
  // So is what lies between the rays of the grid.
  float bound = 0.75 * sqrt(loss.w) + brightest(airlightFroxelRange(1, p, place).rgb);
  counts = vec4(0.0, bound, 0.0, 0.0);
#endif
}
