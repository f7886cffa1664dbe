// Steps of AirlightSteppedRay.glsl for a lamp in fog that falls with height: by
// AirlightHeightFogLamp.glsl.

#define AIRLIGHT_MAXIMUM_STEPS AIRLIGHT_MAXIMUM_FOG_PARTS
#define AirlightSteps AirlightHeightFogLamp

AirlightSteps airlightSteps(AirlightRay ray)
{
  return airlightHeightFogLamp(airlightMedia.item[0], light, ray, ray.lit.x, ray.lit.y);
}

float airlightFirstStep(AirlightSteps steps)
{
  return steps.begin;
}

float airlightLastStep(AirlightSteps steps)
{
  return steps.end;
}

float airlightStepAt(AirlightSteps steps, AirlightRay ray, float t)
{
  return airlightHeightFogV(steps, airlightFromFoot(ray, t));
}

float airlightStepEnd(inout AirlightSteps steps, float v)
{
  return airlightHeightFogPartEnd(airlightMedia.item[0], steps, v);
}

AirlightSpectrum airlightStep(AirlightSteps steps, float v0, float v1)
{
  return airlightHeightFogPart(airlightMedia.item[0], steps, v0, v1);
}

void airlightNextStep(inout AirlightSteps steps) {}

AirlightSpectrum airlightAllSteps(AirlightRay ray)
{
  return airlightHeightFogRay(airlightMedia.item[0], light, ray, ray.lit.x, ray.lit.y);
}
