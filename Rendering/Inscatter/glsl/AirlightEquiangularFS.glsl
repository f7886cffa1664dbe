// As AirlightResolveFS.glsl, of a light that AirlightEquiangular.glsl takes.

void main()
{
  media = givenMedia;
  airlightTakeMedium(media);
  light = givenLight;
  airlightTakeLight(0, light);
  vec2 p = airlightPixel();
  AirlightEquiangularPixel pixel;
  if (!airlightEquiangularPixel(p, airlightRayUnit(p), texelFetch(distances, ivec2(p), 0).r, pixel))
  {
    discard;
  }
  airlightGive(pixel.sum, pixel.surfaceLit);
#ifdef AIRLIGHT_RECORD
  single = airlight;
  float bound = phaseError * brightest(airlight.rgb) + error * brightest(pixel.whole);
#ifdef AIRLIGHT_BOUNDARY_ERROR
  bound += AIRLIGHT_BOUNDARY_ERROR * brightest(pixel.whole);
#endif
  counts = vec4(float(pixel.boundaries), bound, pixel.litLength, 0.0);
#endif
}
