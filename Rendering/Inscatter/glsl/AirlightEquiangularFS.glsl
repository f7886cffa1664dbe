// As AirlightResolveFS.glsl, of a light that AirlightEquiangular.glsl takes.

void main()
{
  airlightTakeMedium();
  light = givenLight;
  airlightTakeLight(0, light);
  vec2 p = airlightPixel();
  AirlightEquiangularPixel pixel;
  if (!airlightEquiangularPixel(p, airlightRayUnit(p), texelFetch(distances, ivec2(p), 0).r, pixel))
  {
    discard;
  }
  vec3 more = vec3(0.0);
#if AIRLIGHT_MULTIPLE_LAMP >= 0
  AirlightMultipleRay multiple = airlightMultipleAlong(
    AIRLIGHT_MULTIPLE_LAMP, airlightOrigin(p), pixel.direction, pixel.end);
#if AIRLIGHT_MULTIPLE_OF_WHOLE
  multiple.once = pixel.whole;
#endif
  more = airlightMultipleShaded(multiple, pixel.sum, true);
#endif
  airlightGive(pixel.sum + more, pixel.surfaceLit);
#ifdef AIRLIGHT_RECORD
  airlightRecord(pixel.sum, more, pixel.whole, pixel.boundaries, pixel.litLength);
#endif
}
