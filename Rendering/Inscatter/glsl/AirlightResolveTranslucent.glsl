// Adds to the records of what is drawn over the medium: on the run [runStart, runEnd] of the ray so
// much of the light passes; undimmed, `sum` is scattered into [from, to] of it, which lies inside
// the media.

uniform int lightBit; // of the light, -1 without surface shadows

void addToFragments(AirlightMedia media, AirlightLight light, ivec2 pixel, AirlightRay ray,
  AirlightPassing passing, float runStart, float runEnd, float from,
  vec3 fromTail, float to, vec3 sum)
{
  bool isLit = airlightPasses(passing);
  uint fragment = translucentHeads[airlightTranslucentHead(pixel)];
  for (int guard = 0; fragment != 0u && guard < airlightTranslucentCapacity; guard++)
  {
    float t = airlightTranslucentDistance(fragment);
    if (isLit && t > from && to > from)
    {
      vec3 part = sum;
      if (t < to)
      {
        part = airlightInterval3(
          media, light, ray, from, fromTail, t, airlightTail3(media, light, ray, t));
      }
      airlightAddTranslucentRadiance(fragment, airlightApplyTransmittance(part, passing));
    }
#if AIRLIGHT_SHADOW_TRANSMITTANCE
    t = airlightTranslucentLitDistance(fragment);
    if (transmittanceSlot >= 0 && t > runStart && t <= runEnd)
    {
      airlightSetTranslucentTransmittance(fragment, transmittanceSlot, airlightPack(passing));
    }
#endif
    if (isLit && lightBit >= 0 && t > runStart && t <= runEnd)
    {
      airlightSetTranslucentLit(fragment, lightBit);
    }
    fragment = airlightNextTranslucent(fragment);
  }
}

#ifdef AIRLIGHT_RAY_MARCH
// The same of a march, step by step: the step [from, to] scatters `part`, those before it `sum`.
void addStepToFragments(ivec2 pixel, float from, float to, vec3 sum, vec3 part)
{
  uint fragment = translucentHeads[airlightTranslucentHead(pixel)];
  for (int guard = 0; fragment != 0u && guard < airlightTranslucentCapacity; guard++)
  {
    float t = airlightTranslucentDistance(fragment);
    if (t > from && t <= to)
    {
      airlightAddTranslucentRadiance(fragment, sum + (t - from) / (to - from) * part);
    }
    fragment = airlightNextTranslucent(fragment);
  }
}

// After the last step, which ends at `end`.
void finishFragments(ivec2 pixel, AirlightRay ray, float end, vec3 sum)
{
  uint fragment = translucentHeads[airlightTranslucentHead(pixel)];
  for (int guard = 0; fragment != 0u && guard < airlightTranslucentCapacity; guard++)
  {
    float t = airlightTranslucentDistance(fragment);
    if (t > end)
    {
      airlightAddTranslucentRadiance(fragment, sum);
    }
    if (lightBit >= 0 && airlightIsSurfaceLit(ray.origin + t * ray.direction))
    {
      airlightSetTranslucentLit(fragment, lightBit);
    }
    fragment = airlightNextTranslucent(fragment);
  }
}
#endif
