// The ray of a pixel. Positions and directions have the world's axes; their origin is the eye.
// Each is an affine function of the pixel's centre, counted from the viewport's lower left corner.

uniform ivec2 airlightViewport; // lower left corner of the viewport in the target
// Of the target's pixels, where they are not the viewport's: scale, shift.
uniform vec4 airlightTargetPixels;
uniform vec3 airlightRayOrigin[3];    // constant, per x, per y
uniform vec3 airlightRayDirection[3]; // not normalised: one unit deep along the camera's axis
// x + y gl_FragCoord.z is the distance in a parallel projection, else the depth's reciprocal
uniform vec2 airlightDepthToDistance;
uniform int airlightParallel;

vec2 airlightPixel()
{
  vec2 p = gl_FragCoord.xy - vec2(airlightViewport);
  return airlightTargetPixels.xy * p + airlightTargetPixels.zw;
}

vec3 airlightOrigin(vec2 p)
{
  return airlightRayOrigin[0] + p.x * airlightRayOrigin[1] + p.y * airlightRayOrigin[2];
}

// One unit deep, not of unit length.
vec3 airlightDirection(vec2 p)
{
  return airlightRayDirection[0] + p.x * airlightRayDirection[1] + p.y * airlightRayDirection[2];
}
