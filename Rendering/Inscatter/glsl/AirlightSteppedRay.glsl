// A ray in steps, between the boundaries of shadows: one loop, in which each pass ends at a
// boundary or at a step's end. The steps are those of AirlightGoniometricSteps.glsl or
// AirlightHeightFogSteps.glsl.

void airlightEquiangularRay(AirlightRay ray, inout AirlightEquiangularPixel pixel)
{
  AirlightSteps steps = airlightSteps(ray);
  float last = airlightLastStep(steps);
  AirlightRayShadows shadows = airlightBeginEquiangular(ray, pixel);
  AirlightSpectrum sum = AirlightSpectrum(0.0);
  float done = airlightFirstStep(steps);
  float t;
  AirlightCounts weight;
  bool ends = airlightNextBoundary(t, weight) == AIRLIGHT_END;
  float at = airlightStepAt(steps, ray, t);
  bool more = true;
  for (int left = pixel.boundaries + AIRLIGHT_MAXIMUM_STEPS; more && left > 0; left--)
  {
    float end = airlightStepEnd(steps, done);
    // The last step takes what lies beyond the ray's end, too.
    bool stops = !ends && (at <= end || end >= last);
    end = stops ? clamp(at, done, end) : end;
    sum += shadows.lit ? airlightStep(steps, done, end) : AirlightSpectrum(0.0);
    done = end;
    more = stops || done < last;
    if (stops)
    {
      airlightCross(ray, t, weight, shadows);
      ends = airlightNextBoundary(t, weight) == AIRLIGHT_END;
      at = airlightStepAt(steps, ray, t);
    }
    else
    {
      airlightNextStep(steps);
    }
  }
#if AIRLIGHT_WHOLE
  AirlightSpectrum all = airlightAllSteps(ray);
#else
  AirlightSpectrum all = AirlightSpectrum(0.0);
#endif
  airlightFinishEquiangular(ray, shadows, all, sum, pixel);
}
