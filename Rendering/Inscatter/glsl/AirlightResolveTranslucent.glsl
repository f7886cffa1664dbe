// Adds to the records of what is drawn over the medium: on the run [runStart, runEnd] of the ray so
// much of the light passes; undimmed, `sum` is scattered into [from, to] of it, which lies inside
// the media. Runs come in order, and the records of a pixel are sorted: each is passed once.

uniform int lightBit; // of the light, -1 without surface shadows

uint airlightRadianceNext; // of the sorted records, the first that has not its radiance yet
uint airlightLitNext;      // and that does not know yet whether it is lit
uint airlightSortedEnd;
vec3 airlightSumSoFar; // into the ray so far
vec3 airlightFragmentsOrigin;
vec3 airlightFragmentsDirection;
bool airlightFirstDraw = true; // of those that share the ray

void beginFragments(ivec2 pixel, vec3 origin, vec3 direction)
{
  airlightFragmentsOrigin = origin;
  airlightFragmentsDirection = direction;
  uvec2 sorted = airlightSortedTranslucent(pixel);
  airlightRadianceNext = sorted.x;
  airlightLitNext = sorted.x;
  airlightSortedEnd = sorted.x + sorted.y;
  airlightSumSoFar = vec3(0.0);
}

bool airlightHasRadianceBefore(float t)
{
  return airlightRadianceNext < airlightSortedEnd &&
    airlightSortedDistance(airlightRadianceNext) <= t;
}

void airlightGiveRadiance(vec3 radiance)
{
#if AIRLIGHT_MULTIPLE_LAMP >= 0
  AirlightMultipleRay multiple = airlightMultipleAlong(AIRLIGHT_MULTIPLE_LAMP,
    airlightFragmentsOrigin, airlightFragmentsDirection,
    airlightSortedDistance(airlightRadianceNext));
  radiance += airlightMultipleShaded(multiple, radiance, airlightFirstDraw);
#endif
  airlightAddTranslucentRadiance(airlightSortedRecord(airlightRadianceNext), radiance);
  airlightRadianceNext++;
}

// Of the record that is next to know whether it is lit.
float airlightLitDistance()
{
#if AIRLIGHT_SHADOW_TRANSMITTANCE
  return airlightTranslucentLitDistance(airlightSortedRecord(airlightLitNext));
#else
  return airlightSortedDistance(airlightLitNext);
#endif
}

void airlightLightRun(AirlightPassing passing, float runStart, float runEnd)
{
  while (airlightLitNext < airlightSortedEnd && airlightLitDistance() <= runEnd)
  {
    uint fragment = airlightSortedRecord(airlightLitNext);
    bool isInside = airlightLitDistance() > runStart;
#if AIRLIGHT_SHADOW_TRANSMITTANCE
    if (transmittanceSlot >= 0 && isInside)
    {
      airlightSetTranslucentTransmittance(fragment, transmittanceSlot, airlightPack(passing));
    }
#endif
    if (isInside && lightBit >= 0 && airlightPasses(passing))
    {
      airlightSetTranslucentLit(fragment, lightBit);
    }
    airlightLitNext++;
  }
}

void addToFragments(AirlightLight light, AirlightRay ray, AirlightPassing passing, float runStart,
  float runEnd, float from, vec3 fromTail, float to, vec3 sum)
{
  if (airlightPasses(passing) && to > from)
  {
    while (airlightHasRadianceBefore(from))
    {
      airlightGiveRadiance(airlightSumSoFar);
    }
    while (airlightHasRadianceBefore(to))
    {
      float t = airlightSortedDistance(airlightRadianceNext);
      vec3 part = airlightInterval3(
        light, ray, from, fromTail, t, airlightTail3(light, ray, t));
      airlightGiveRadiance(airlightSumSoFar + airlightApplyTransmittance(part, passing));
    }
    airlightSumSoFar += airlightApplyTransmittance(sum, passing);
  }
  airlightLightRun(passing, runStart, runEnd);
}

// After the last run, or the last that this draw does.
void finishFragments()
{
  while (airlightRadianceNext < airlightSortedEnd)
  {
    airlightGiveRadiance(airlightSumSoFar);
  }
}

#ifdef AIRLIGHT_RAY_MARCH
// The same of a march, step by step: the step [from, to] scatters `part`, those before it `sum`.
void addStepToFragments(float from, float to, vec3 sum, vec3 part)
{
  while (airlightHasRadianceBefore(from))
  {
    airlightRadianceNext++;
  }
  while (airlightHasRadianceBefore(to))
  {
    float t = airlightSortedDistance(airlightRadianceNext);
    airlightGiveRadiance(sum + (t - from) / (to - from) * part);
  }
  airlightSumSoFar = sum + part;
}

// After the last step.
void lightFragments(AirlightRay ray)
{
  for (uint place = airlightLitNext; place < airlightSortedEnd && lightBit >= 0; place++)
  {
    if (airlightIsSurfaceLit(ray.origin + airlightSortedDistance(place) * ray.direction))
    {
      airlightSetTranslucentLit(airlightSortedRecord(place), lightBit);
    }
  }
}
#endif
