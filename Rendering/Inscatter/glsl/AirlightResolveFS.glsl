// One light's airlight along each pixel's ray: the sum over the ray's lit intervals. Blended
// additively, light by light.

uniform AirlightLightPixel lightPixel;

#ifdef AIRLIGHT_RECORD
// What runs in the dark would scatter is a part of what the error is bounded by.
const bool wantsDark = true;
#else
const bool wantsDark = false;
#endif

#if defined(AIRLIGHT_RECORD) && defined(AIRLIGHT_RAY_MARCH)
// Scattered along the whole ray, shadows or not.
vec3 unshadowed(AirlightRay ray)
{
  vec3 tail = airlightTail3(light, ray, ray.lit.x);
  return ray.lit.y > ray.lit.x ? airlightInterval3(light, ray, ray.lit.x, tail, ray.lit.y,
                                   airlightTail3(light, ray, ray.lit.y))
                               : vec3(0.0);
}
#endif

void main()
{
  vec2 p = airlightPixel();
  ivec2 pixel = ivec2(p);
  float parameter = texelFetch(distances, pixel, 0).r;
  float unit = airlightRayUnit(p);
  float surface = unit * parameter;
  vec3 origin = airlightOrigin(p);
  vec3 direction = airlightDirection(p) / unit;
  AirlightRay ray =
    airlightRayBeside(light, origin, direction, surface >= 0.0 ? surface : AIRLIGHT_FAR,
      airlightLightMoment(lightPixel, light, p, unit, origin, direction));

#ifdef AIRLIGHT_TRANSLUCENT_FRAGMENTS
  beginFragments(pixel, origin, direction);
#endif
#ifdef AIRLIGHT_RAY_MARCH
  float litLength;
  int boundaries;
  bool surfaceLit;
  vec3 sum = airlightMarched(ray, surface, litLength, boundaries, surfaceLit);
  int state = AIRLIGHT_END;
  int shadows = surfaceLit ? 0 : 1;
#ifdef AIRLIGHT_RECORD
  vec3 whole = unshadowed(ray);
#endif
#else
  float from = ray.lit.x;
  float runStart = -1.0; // of what is lit, or not, as a whole
  AirlightCounts shadows = airlightStartCounts();
  if (!airlightOpenBoundaries(pixel, unit, parameter))
  {
    discard;
  }
  airlightBeginBoundaries(ray, from, shadows);
#ifdef AIRLIGHT_TRANSLUCENT_FRAGMENTS
  airlightFirstDraw = !(from > ray.lit.x);
#if AIRLIGHT_SHADOW_TRANSMITTANCE
  runStart = airlightRunStart;
#else
  runStart = from > ray.lit.x ? from : runStart; // where a draw before this one left off
#endif
#endif
  vec3 fromTail = airlightTail3(light, ray, from);
  vec3 sum = vec3(0.0);
  vec3 whole = vec3(0.0); // without shadows; where the error is recorded
  float litLength = 0.0;
  int boundaries = 0;
  AirlightPassing passing = airlightPassing(shadows);

  int state = AIRLIGHT_MORE;
  while (state == AIRLIGHT_MORE)
  {
    float t;
    AirlightCounts weight;
    state = airlightNextBoundary(t, weight);
    if (state == AIRLIGHT_PAUSE)
    {
      break;
    }
    bool more = state == AIRLIGHT_MORE;
    AirlightCounts next = shadows;
    if (more)
    {
      next = airlightAdd(shadows, weight);
      boundaries++;
    }
    // Only where light ends or begins does the integral change; the ray's end ends it too.
    AirlightPassing nextPassing = airlightPassing(next);
    if (!more || passing != nextPassing)
    {
      float to = more ? clamp(t, from, ray.lit.y) : ray.lit.y;
      vec3 toTail = fromTail;
      vec3 part = vec3(0.0);
      if (to > from && (more || wantsDark || airlightPasses(passing)))
      {
        part = airlightRun3(light, ray, wantsDark || airlightPasses(passing), from, toTail, to);
        whole += part;
        if (airlightPasses(passing))
        {
          sum += airlightApplyTransmittance(part, passing);
#ifdef AIRLIGHT_RECORD
          litLength += airlightLengthInside(ray.origin, ray.direction, from, to);
#endif
        }
      }
#ifdef AIRLIGHT_TRANSLUCENT_FRAGMENTS
      float runEnd = more ? t : AIRLIGHT_FAR;
      addToFragments(
        light, ray, passing, runStart, runEnd, from, fromTail, max(from, to), part);
      runStart = runEnd;
#endif
      from = max(from, to);
      fromTail = toTail;
    }
    shadows = next;
    passing = nextPassing;
  }
#if AIRLIGHT_SHADOW_TRANSMITTANCE
  airlightRunStart = runStart;
  if (state == AIRLIGHT_END && transmittanceSlot >= 0)
  {
    airlightSetSurfaceTransmittance(transmittanceSlot, pixel, airlightPack(passing));
  }
#endif
  airlightCloseBoundaries(pixel, state, from, shadows);
#endif

#ifdef AIRLIGHT_TRANSLUCENT_FRAGMENTS
  finishFragments();
#endif

  // A channel that does not scatter is dark, whatever the limit of its integral.
  vec3 sigmaS = vec3(0.0);
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    sigmaS += airlightMedia.item[i].sigmaS;
  }
  sum = mix(vec3(0.0), sum, greaterThan(sigmaS, vec3(0.0)));
  vec3 more = vec3(0.0);
#if AIRLIGHT_MULTIPLE_LAMP >= 0
  AirlightMultipleRay multiple = airlightMultipleAlong(
    AIRLIGHT_MULTIPLE_LAMP, origin, direction, surface >= 0.0 ? surface : AIRLIGHT_FAR);
  more = airlightMultipleShaded(multiple, sum, state != AIRLIGHT_PAUSE);
#endif
  airlightGive(
    sum + more, state == AIRLIGHT_END && airlightPasses(airlightPassing(shadows)));
#ifdef AIRLIGHT_RECORD
  // Not less than with shadows, but where a driver ends loops early (AirlightQuadrature.glsl). Of a
  // ray that takes several draws, each counts its own part.
  whole = mix(vec3(0.0), max(whole, sum), greaterThan(sigmaS, vec3(0.0)));
  airlightRecord(sum, more, whole, boundaries, litLength);
#endif
}
