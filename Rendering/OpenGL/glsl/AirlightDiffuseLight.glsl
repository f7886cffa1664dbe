// Light that comes to the media from all around: ambient light or, in its place, what was scattered
// more than once. On [0, l] of a ray, which the lights scatter `once` into, in their shadows.
vec3 airlightDiffuse(AirlightMedia media, vec3 origin, vec3 direction, float l, vec3 once)
{
#if AIRLIGHT_MULTIPLE
  AirlightMultipleRay ray = airlightMultipleAlong(media, origin, direction, l);
  // Where shadows take away light that is scattered once, some of the other goes, too: the same
  // share of it.
  vec3 share = clamp(once / max(ray.once, vec3(1e-30)), vec3(0.0), vec3(1.0));
  return ray.several * mix(share, vec3(1.0), lessThan(ray.once, vec3(1e-30)));
#else
  return airlightAmbient(media, origin, direction, l);
#endif
}
