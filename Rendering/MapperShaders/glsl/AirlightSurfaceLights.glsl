// What both shaders of a mapper know of media and lights.

uniform AirlightMedia airlightMedia;
// w 1: position; 0: direction towards a light at infinity; -1: left as VTK shades it
uniform vec4 airlightSceneLights[AIRLIGHT_SCENE_LIGHTS];
uniform int airlightSceneLightCount;

// What optical depths leave of light.
vec3 airlightTransmittanceOf(vec3 depth)
{
#if AIRLIGHT_GREY
  return vec3(exp(-depth.x));
#else
  return exp(-depth);
#endif
}
