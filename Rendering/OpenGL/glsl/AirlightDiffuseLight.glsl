// Light that comes to the media from all around: ambient light or, in its place, what was scattered
// more than once. On [0, l] of a ray, which the lights scatter `once` into, in their shadows.
vec3 airlightDiffuse(AirlightMedia media, vec3 origin, vec3 direction, float l, vec3 once)
{
#if AIRLIGHT_MULTIPLE
  return airlightMultipleShaded(airlightMultipleAlong(media, origin, direction, l), once);
#else
  return airlightAmbient(media, origin, direction, l);
#endif
}
