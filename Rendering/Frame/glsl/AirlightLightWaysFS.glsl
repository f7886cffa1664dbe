// What media leave of lights on their ways to the surface of a pixel: a layer above another for
// each light. See AirlightLightWaysPass.h.

uniform sampler2D distances;
uniform vec4 lights[AIRLIGHT_LAYERS]; // w 1: position; 0: direction towards a light at infinity

layout(location = 0) out vec4 found;

void main()
{
  int rows = textureSize(distances, 0).y;
  int layer = int(gl_FragCoord.y) / rows;
  vec2 p = airlightPixel() - vec2(0.0, float(layer * rows));
  float parameter = texelFetch(distances, ivec2(p), 0).r;
  vec3 depth = vec3(0.0);
  if (parameter >= 0.0)
  {
    vec3 point = airlightOrigin(p) + parameter * airlightDirection(p);
    vec4 light = lights[layer];
    // Where all lights are of one kind compilers leave the other way out.
    bool sun = AIRLIGHT_HAS_SUNS == 1 && (AIRLIGHT_HAS_LAMPS == 0 || light.w == 0.0);
    if (sun)
    {
      depth = airlightSunDepths(point, light.xyz);
    }
    else
    {
      depth = airlightDepthBetween(point, light.xyz);
    }
  }
  found = vec4(airlightTransmittanceOf(depth), 1.0);
}
