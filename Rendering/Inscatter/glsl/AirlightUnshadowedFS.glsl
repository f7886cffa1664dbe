// The airlight of a few lights without shadows along each pixel's ray, added to that of others.
// litBit is the sum of theirs.

void main()
{
  airlightTakeMedium();
  vec2 p = airlightPixel();
  float parameter = texelFetch(distances, ivec2(p), 0).r;
  float unit = airlightRayUnit(p);
  float end = parameter >= 0.0 ? unit * parameter : AIRLIGHT_FAR;
  airlightGive(
    airlightUnshadowedRays(p, airlightOrigin(p), airlightDirection(p) / unit, unit, end), true);
}
