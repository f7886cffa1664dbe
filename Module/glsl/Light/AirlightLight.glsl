// A light and the ray that it lights.

// How a light's airlight is integrated.
// inverse square, inside the one uniform medium: closed form
#define AIRLIGHT_POINT_CLOSED 0
#define AIRLIGHT_POINT_QUADRATURE 1     // any other light at a place
#define AIRLIGHT_DIRECTIONAL_CLOSED 2   // one uniform medium, unbounded or a box: exponentials
#define AIRLIGHT_DIRECTIONAL_HEIGHT 3   // one medium of exponential height, unbounded
#define AIRLIGHT_DIRECTIONAL_QUADRATURE 4

struct AirlightLight
{
  int kind;
  real3 position;    // directional: unit vector towards the light
  real3 intensity;   // radiant intensity on the axis; directional: irradiance
  real3 attenuation; // (a, b, c) of 1/(a + b r + c r^2)
  real radius;       // least distance to the ray, above 0
  real3 axis;        // of a spot, unit vector
  real cosCone;      // of a spot's half angle, above 0; -1: no spot
  real exponent;     // of the cosine of the angle to a spot's axis
  int goniometric;   // 1: `photometry` says how much goes in each direction
  AirlightPhotometry photometry;
  // For each medium with an image: texel of the means between a place and the light
  // (AirlightLightGrid.h), their numbers of cells, and in which of these a place is.
  AIRLIGHT_LIGHT_GRID_MEMBERS
};

// Where the kind of light is known when a shader is compiled, the other kinds fall away.
#ifndef AIRLIGHT_LIGHT_KIND
#define AIRLIGHT_LIGHT_KIND light.kind
#endif

AIRLIGHT_FN bool airlightIsDirectional(AIRLIGHT_IN(AirlightLight) light)
{
  return AIRLIGHT_LIGHT_KIND >= AIRLIGHT_DIRECTIONAL_CLOSED;
}

// Towards a light at infinity, else (0, 0, 0).
AIRLIGHT_FN real3 airlightToSun(AIRLIGHT_IN(AirlightLight) light)
{
  return airlightIsDirectional(light) ? light.position : real3(real(0.0));
}

struct AirlightRay
{
  real3 origin;
  real3 direction;
  real2 range;       // inside media, as distances from the origin
  real2 lit;         // the part of it inside a spot's cone
  // The same from the light's foot, to which a cone's ends can be much closer than to the origin:
  // with digits that `lit` has not. And how long that part is.
  real2 litFromFoot;
  real litWay;
  AirlightFoot foot; // of the light, from range.x
  real3 across;      // from the light to its foot
};

// How far after the light's foot t is.
AIRLIGHT_FN real airlightFromFoot(AIRLIGHT_IN(AirlightRay) ray, real t)
{
#ifndef AIRLIGHT_NO_CONE
  if (t == ray.lit.x)
  {
    return ray.litFromFoot.x;
  }
  if (t == ray.lit.y)
  {
    return ray.litFromFoot.y;
  }
#endif
  return (t - ray.range.x) - ray.foot.tL;
}

// How long [t0, t1] is.
AIRLIGHT_FN real airlightWayBetween(AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
#ifndef AIRLIGHT_NO_CONE
  if (t0 == ray.lit.x && t1 == ray.lit.y)
  {
    return ray.litWay;
  }
#endif
  return t1 - t0;
}

// Keeps of [range.x, range.y] what is inside a spot's cone. The cone is convex, so there is one.
// With y = (t - tL)/h and the components (axisH, axisD) of the axis towards the light's
// perpendicular and along the ray, inside means axisH + y axisD >= cosCone sqrt(1 + y^2). `moment`
// as in airlightRayBeside().
AIRLIGHT_FN void airlightClipToCone(
  AIRLIGHT_IN(AirlightLight) light, real3 moment, AIRLIGHT_INOUT(AirlightRay) ray)
{
  real axisD = dot(light.axis, ray.direction);
  real axisH = dot(light.axis, cross(moment, ray.direction)) / ray.foot.h;
  real c2 = light.cosCone * light.cosCone;
  ray.lit.y = ray.range.x;
  ray.litFromFoot.y = ray.litFromFoot.x;
  ray.litWay = real(0.0);
  real discriminant = axisD * axisD + axisH * axisH - c2;
  if (discriminant <= real(0.0))
  {
    return;
  }
  // (axisD^2 - c^2) y^2 + 2 axisH axisD y + (axisH^2 - c^2) = 0, roots without cancellation.
  real a = axisD * axisD - c2;
  real b = axisH * axisD;
  real c = axisH * axisH - c2;
  real s = light.cosCone * sqrt(discriminant);
  real q = b > real(0.0) ? -(b + s) : s - b;
  real far = real(AIRLIGHT_FAR);
  real root1 =
    abs(q) > abs(a) * far ? far * sign(q) * (a < real(0.0) ? real(-1.0) : real(1.0)) : q / a;
  real root2 = q != real(0.0) ? c / q : real(0.0);
  real low = min(root1, root2);
  real high = max(root1, root2);
  real from = real(-AIRLIGHT_FAR);
  real to = far;
  if (a > real(0.0))
  {
    // The ray leaves through the cone's open end: inside beyond the root in its nappe.
    from = axisD > real(0.0) ? high : from;
    to = axisD > real(0.0) ? to : low;
  }
  else if (axisH + real(0.5) * (low + high) * axisD >= real(0.0))
  {
    from = low;
    to = high;
  }
  else
  {
    return;
  }
  real foot = ray.range.x + ray.foot.tL;
  ray.litFromFoot = clamp(ray.foot.h * real2(from, to), real2(-ray.foot.tL),
    real2((ray.range.y - ray.range.x) - ray.foot.tL));
  ray.lit.x = clamp(foot + ray.litFromFoot.x, ray.range.x, ray.range.y);
  ray.lit.y = clamp(foot + ray.litFromFoot.y, ray.lit.x, ray.range.y);
  bool close = abs(ray.litFromFoot.x) + abs(ray.litFromFoot.y) < abs(ray.lit.x) + abs(ray.lit.y);
  ray.litWay = close ? ray.litFromFoot.y - ray.litFromFoot.x : ray.lit.y - ray.lit.x;
}

// The light's moment about a pixel's ray where the light stands for a pixel of its own: its whole
// part and the rest, `perX` and `perY` what the moment grows by per pixel away from it, for a
// direction of length `unit`. Near the light this keeps digits that airlightRay() loses.
AIRLIGHT_FN real3 airlightMoment(
  real2 p, real2 pixel, real2 pixelRest, real3 perX, real3 perY, real unit)
{
  real2 q = (p - pixel) - pixelRest;
  return (q.x * perX + q.y * perY) / unit;
}

// The ray from origin to t1 and the foot of the light's perpendicular on it, given the light's
// moment (light - origin) x direction: its length is the light's distance, and with the direction
// it says to which side the light is.
AIRLIGHT_FN AirlightRay airlightRayBeside(AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light,
  real3 origin, real3 direction, real t1, real3 moment)
{
  AirlightRay ray;
  ray.origin = origin;
  ray.direction = direction;
  ray.range = real2(t1, real(0.0));
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    real2 range = airlightRegionRange(airlightMedia.item[i].region, origin, direction, t1);
    if (range.y > range.x)
    {
      ray.range = real2(min(ray.range.x, range.x), max(ray.range.y, range.y));
    }
  }
  ray.range = real2(min(ray.range.x, t1), max(ray.range.y, min(ray.range.x, t1)));
  ray.foot.tL = dot(light.position - origin, direction) - ray.range.x;
  ray.foot.h = max(length(moment), light.radius);
  ray.across = cross(moment, direction);
  ray.lit = ray.range;
#ifndef AIRLIGHT_NO_CONE
  ray.litFromFoot = (ray.range - ray.range.x) - ray.foot.tL;
  ray.litWay = ray.range.y - ray.range.x;
  if (light.cosCone > real(0.0))
  {
    airlightClipToCone(light, moment, ray);
  }
#endif
  return ray;
}

AIRLIGHT_FN AirlightRay airlightRay(
  AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light, real3 origin, real3 direction, real t1)
{
  return airlightRayBeside(
    AIRLIGHT_MEDIA_OUT light, origin, direction, t1, cross(light.position - origin, direction));
}
