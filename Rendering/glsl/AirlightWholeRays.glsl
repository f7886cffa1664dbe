// The airlight of lights whose shadows are left out of account, along whole rays: the composition
// then needs no picture of it.

// A light's own pixel, its whole part and the rest, and what the distance between light and ray
// grows by per pixel away from it.
struct AirlightOwnPixel
{
  int HasPixel;
  vec2 Pixel;
  vec2 PixelRest;
  vec3 PerX;
  vec3 PerY;
};
uniform AirlightLight lights[AIRLIGHT_WHOLE_LIGHTS];
uniform AirlightOwnPixel own[AIRLIGHT_WHOLE_LIGHTS];

vec3 airlightWholeRay(
  AirlightLight light, AirlightOwnPixel near, vec2 p, vec3 origin, vec3 direction, float end)
{
#if !AIRLIGHT_CONES
  light.cosCone = 0.0;
#endif
  AirlightRay ray = airlightRay(media, light, origin, direction, end);
  if (near.HasPixel != 0)
  {
    vec2 q = (p - near.Pixel) - near.PixelRest;
    float l = length(q.x * near.PerX + q.y * near.PerY);
    ray.foot.h =
      max(airlightParallel != 0 ? l : l / length(airlightDirection(p)), light.radius);
  }
  vec3 tail = airlightTail3(media, light, ray, ray.lit.x);
  vec3 sum = airlightInterval3(media, light, ray, ray.lit.x, tail, ray.lit.y,
    airlightTail3(media, light, ray, ray.lit.y));
  return ray.lit.y > ray.lit.x ? sum : vec3(0.0);
}

vec3 airlightWholeRays(vec2 p, vec3 origin, vec3 direction, float end)
{
  vec3 sum = vec3(0.0);
  AIRLIGHT_EACH_LIGHT
  // A channel that does not scatter is dark, whatever the limit of its integral.
  vec3 sigmaS = vec3(0.0);
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    sigmaS += media.item[i].sigmaS;
  }
  return mix(vec3(0.0), sum, greaterThan(sigmaS, vec3(0.0)));
}
