// Steps of AirlightSteppedRay.glsl for a photometric lamp: by AirlightGoniometricArc.glsl, each of
// which ends where the ray leaves a cell of the table, or where three nodes end.

#define AIRLIGHT_MAXIMUM_STEPS AIRLIGHT_MAXIMUM_CELLS

struct AirlightSteps
{
  AirlightEquiangular arc;
  AirlightGoniometricArc walk;
};

AirlightSteps airlightSteps(AirlightRay ray)
{
  AirlightSteps steps;
  steps.arc = airlightEquiangularRange(airlightMedia.item[0], ray, ray.lit.x, ray.lit.y);
  steps.walk = airlightGoniometricArc(light.photometry, ray, steps.arc);
  return steps;
}

float airlightFirstStep(AirlightSteps steps)
{
  return 0.0;
}

float airlightLastStep(AirlightSteps steps)
{
  return steps.arc.end;
}

float airlightStepAt(AirlightSteps steps, AirlightRay ray, float t)
{
  return airlightAngleAt(steps.arc, ray, t);
}

float airlightStepEnd(inout AirlightSteps steps, float psi)
{
  float end =
    airlightGoniometricEnd(airlightMedia.item[0], light.photometry, steps.arc, psi, steps.walk);
  return min(end, steps.arc.end);
}

AirlightSpectrum airlightStep(AirlightSteps steps, float psi0, float psi1)
{
  return airlightGoniometricPart(airlightMedia.item[0], steps.arc, steps.walk, psi0, psi1);
}

void airlightNextStep(inout AirlightSteps steps)
{
  airlightGoniometricCross(steps.walk);
}

AirlightSpectrum airlightAllSteps(AirlightRay ray)
{
  return airlightGoniometricQuadrature(
    airlightMedia.item[0], light.photometry, ray, ray.lit.x, ray.lit.y);
}
