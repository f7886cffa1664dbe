// Light that comes to the media from all around, ambient light or, in its place, what lamps scatter
// more than once; and what media emit.

// As if nothing cast shadows, on [0, l] of a ray.
vec3 airlightDiffuse(vec3 origin, vec3 direction, float l)
{
#if AIRLIGHT_MULTIPLE
  vec3 sum = airlightAmbient(origin, direction, l);
  for (int i = 0; i < AIRLIGHT_MULTIPLE_LIGHTS; i++)
  {
    sum += airlightMultipleAlong(i, origin, direction, l).several;
  }
  return sum;
#else
  return airlightAmbient(origin, direction, l);
#endif
}

// Beside the lights' own airlight, which has what they scatter.
vec3 airlightDiffuseRest(vec3 origin, vec3 direction, float l)
{
#if AIRLIGHT_MULTIPLE
  return airlightAmbient(origin, direction, l) +
    airlightMultipleOfCollisions(origin, direction, l);
#else
  return airlightAmbient(origin, direction, l);
#endif
}
