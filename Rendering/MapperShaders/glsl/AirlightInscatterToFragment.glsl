// What the medium before a point of a surface scatters to the eye.

uniform AirlightLight airlightLights[AIRLIGHT_SCENE_LIGHTS];

// Scattered into the ray before its fragment, shadows left out of account.
vec3 airlightInscatterToFragment(vec3 origin, vec3 direction, float t)
{
  vec3 sum = vec3(0.0);
  for (int k = 0; k < airlightSceneLightCount; k++)
  {
    if (airlightSceneLights[k].w >= 0.0)
    {
      AirlightRay ray = airlightRay(airlightLights[k], origin, direction, t);
      if (ray.lit.y > ray.lit.x)
      {
        vec3 tail = airlightTail3(airlightLights[k], ray, ray.lit.x);
        sum += airlightInterval3(airlightLights[k], ray, ray.lit.x, tail, ray.lit.y,
          airlightTail3(airlightLights[k], ray, ray.lit.y));
      }
    }
  }
  return airlightDiffuse(origin, direction, t) + sum;
}
