// A ray in steps, between the boundaries of shadows: one loop, in which each pass ends at a
// boundary or at a step's end. The steps are those of AirlightGoniometricSteps.glsl or
// AirlightHeightFogSteps.glsl.

void airlightEquiangularRay(AirlightRay ray, inout AirlightEquiangularPixel pixel)
{
  AirlightSteps steps = airlightSteps(ray);
  float last = airlightLastStep(steps);
  float from = ray.lit.x;
  AirlightCounts shadows = airlightStartCounts();
  airlightBeginEquiangular(ray, from, shadows, pixel);
  bool lit = airlightPassing(shadows);
  float litLength = lit ? -from : 0.0;
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
    sum += lit ? airlightStep(steps, done, end) : AirlightSpectrum(0.0);
    done = end;
    more = stops || done < last;
    if (stops)
    {
      shadows = airlightAdd(shadows, weight);
      bool was = lit;
      lit = airlightPassing(shadows);
      float parameter = clamp(t, ray.lit.x, ray.lit.y);
      litLength += was == lit ? 0.0 : lit ? -parameter : parameter;
      ends = airlightNextBoundary(t, weight) == AIRLIGHT_END;
      at = airlightStepAt(steps, ray, t);
    }
    else
    {
      airlightNextStep(steps);
    }
  }
  pixel.litLength = max(litLength + (lit ? ray.lit.y : 0.0), 0.0);
#if AIRLIGHT_WHOLE
  AirlightSpectrum all = airlightAllSteps(ray);
#else
  AirlightSpectrum all = AirlightSpectrum(0.0);
#endif
  pixel.whole = airlightEquiangularLight(light, ray, all);
  pixel.sum = airlightEquiangularLight(light, ray, max(sum, AirlightSpectrum(0.0)));
}
