// Where a light is in the picture, as CameraUniforms::LightPixel.
struct AirlightLightPixel
{
  int isNear; // 0: in no pixel near the view, the rest is not set
  vec2 whole;
  vec2 rest;
  vec3 perX;
  vec3 perY;
};

// The light's moment about the pixel's ray. `unit`: the length of airlightDirection().
vec3 airlightLightMoment(
  AirlightLightPixel own, AirlightLight light, vec2 p, float unit, vec3 origin, vec3 direction)
{
  return own.isNear != 0 ? airlightMoment(p, own.whole, own.rest, own.perX, own.perY, unit)
                         : cross(light.position - origin, direction);
}
