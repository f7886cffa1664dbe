// The ray of a pixel. Positions and directions have the world's axes; their origin is the eye.
// Each is an affine function of the pixel's centre, counted from the viewport's lower left corner.

// With AIRLIGHT_FULL_SCREEN the vertex shader is AirlightFullScreenVS.glsl; with
// AIRLIGHT_FRAGMENT_IS_PIXEL the target is the viewport; with AIRLIGHT_PARALLEL it is known whether
// the projection is parallel.

#ifdef AIRLIGHT_FULL_SCREEN
flat in vec4 airlightFlatPixels;
flat in vec3 airlightFlatDirection[3];
#define airlightRayDirection airlightFlatDirection
#else
uniform ivec2 airlightViewport; // lower left corner of the viewport in the target
// Of the target's pixels, where they are not the viewport's: scale, shift.
uniform vec4 airlightTargetPixels;
uniform vec3 airlightRayDirection[3]; // as the origin; not normalised: one unit deep
#endif
uniform vec3 airlightRayOrigin[3]; // constant, per x, per y; in a perspective 0
// x + y gl_FragCoord.z is the distance in a parallel projection, else the depth's reciprocal
uniform vec2 airlightDepthToDistance;
#ifdef AIRLIGHT_PARALLEL
const int airlightParallel = AIRLIGHT_PARALLEL;
#else
uniform int airlightParallel;
#endif

vec2 airlightPixel()
{
#if defined(AIRLIGHT_FRAGMENT_IS_PIXEL)
  return gl_FragCoord.xy;
#elif defined(AIRLIGHT_FULL_SCREEN)
  return airlightFlatPixels.xy * gl_FragCoord.xy + airlightFlatPixels.zw;
#else
  vec2 p = gl_FragCoord.xy - vec2(airlightViewport);
  return airlightTargetPixels.xy * p + airlightTargetPixels.zw;
#endif
}

vec3 airlightOrigin(vec2 p)
{
#ifdef AIRLIGHT_PARALLEL
  if (airlightParallel == 0)
  {
    return vec3(0.0);
  }
#endif
  return airlightRayOrigin[0] + p.x * airlightRayOrigin[1] + p.y * airlightRayOrigin[2];
}

// One unit deep, not of unit length.
vec3 airlightDirection(vec2 p)
{
  return airlightRayDirection[0] + p.x * airlightRayDirection[1] + p.y * airlightRayDirection[2];
}

// The unit of airlightDirection().
float airlightRayUnit(vec2 p)
{
  return airlightParallel != 0 ? 1.0 : length(airlightDirection(p));
}
