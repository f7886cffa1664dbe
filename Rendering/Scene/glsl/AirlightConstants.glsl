// What is the same for all pixels, and much used, of point lights in the one medium: six vectors a
// light, see SetEquiangularConstants().

flat in vec4 airlightFlatConstants[24]; // AirlightFullScreenVS.glsl

// The medium as it is given, with what the constants say of it.
void airlightTakeMedium()
{
  airlightMedia = givenMedia;
  airlightMedia.item[0].phase.pole[0].y = airlightFlatConstants[1].w;
  airlightMedia.item[0].sigmaT = airlightFlatConstants[2].xyz;
}

// And of the k-th light. Its intensity has the scattering coefficient in it.
void airlightTakeLight(int k, inout AirlightLight light)
{
  light.position = airlightFlatConstants[6 * k].xyz;
  light.radius = airlightFlatConstants[6 * k].w;
  light.intensity = airlightFlatConstants[6 * k + 1].xyz;
}

// What its light scatters, of a sum along the ray: a channel that does not scatter is dark,
// whatever the limit of its integral.
vec3 airlightEquiangularLight(AirlightLight light, AirlightRay ray, AirlightSpectrum sum)
{
  vec3 full = light.intensity * (sum / ray.foot.h);
  return mix(vec3(0.0), full, greaterThan(light.intensity, vec3(0.0)));
}

// The k-th light's moment about the pixel's ray.
vec3 airlightOwnMoment(int k, vec2 p, float unit, AirlightLight light, vec3 origin, vec3 direction)
{
  vec4 pixel = airlightFlatConstants[6 * k + 3];
  AirlightLightPixel own = AirlightLightPixel(int(airlightFlatConstants[6 * k + 2].w), pixel.xy,
    pixel.zw, airlightFlatConstants[6 * k + 4].xyz, airlightFlatConstants[6 * k + 5].xyz);
  return airlightLightMoment(own, light, p, unit, origin, direction);
}
