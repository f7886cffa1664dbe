// A light and the ray that it lights.

// How a light's airlight is integrated.
#define AIRLIGHT_POINT_CLOSED 0         // inverse square, inside the one uniform medium: closed form
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
  int gridFirst;  // in shaders, where an image is the density: texel of the means between a place
  real3 gridSize; // and the light (AirlightLightGrid.h), and their numbers of cells
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
  AirlightFoot foot; // of the light, from range.x
};

// The part of [range.x, range.y] inside a spot's cone. The cone is convex, so there is one. With
// y = (t - tL)/h and the components (axisH, axisD) of the axis towards the light's perpendicular
// and along the ray, inside means axisH + y axisD >= cosCone sqrt(1 + y^2).
AIRLIGHT_FN real2 airlightConeRange(
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray)
{
  real3 fromLight = ray.origin + (ray.range.x + ray.foot.tL) * ray.direction - light.position;
  real axisD = dot(light.axis, ray.direction);
  real axisH = dot(light.axis, fromLight) / ray.foot.h;
  real c2 = light.cosCone * light.cosCone;
  real2 empty = real2(ray.range.x, ray.range.x);
  real discriminant = axisD * axisD + axisH * axisH - c2;
  if (discriminant <= real(0.0))
  {
    return empty;
  }
  // (axisD^2 - c^2) y^2 + 2 axisH axisD y + (axisH^2 - c^2) = 0, roots without cancellation.
  real a = axisD * axisD - c2;
  real b = axisH * axisD;
  real c = axisH * axisH - c2;
  real s = light.cosCone * sqrt(discriminant);
  real q = b > real(0.0) ? -(b + s) : s - b;
  real far = real(AIRLIGHT_FAR);
  real root1 = abs(q) > abs(a) * far ? far * sign(q) * (a < real(0.0) ? real(-1.0) : real(1.0)) : q / a;
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
    return empty;
  }
  real foot = ray.range.x + ray.foot.tL;
  real first = clamp(foot + ray.foot.h * from, ray.range.x, ray.range.y);
  return real2(first, clamp(foot + ray.foot.h * to, first, ray.range.y));
}

// The light's distance from a pixel's ray, h of its foot, where the light stands for a pixel of its
// own: its whole part and the rest, `perX` and `perY` what the distance grows by per pixel away from
// it, for a direction of length `unit`. Near the light this keeps digits that airlightRay() loses.
AIRLIGHT_FN real airlightFootDistance(real2 p, real2 pixel, real2 pixelRest, real3 perX, real3 perY,
  real unit, real radius)
{
  real2 q = (p - pixel) - pixelRest;
  return max(length(q.x * perX + q.y * perY) / unit, radius);
}

// The ray from origin to t1 and the foot of the light's perpendicular on it.
AIRLIGHT_FN AirlightRay airlightRay(AIRLIGHT_IN(AirlightMedia) media,
  AIRLIGHT_IN(AirlightLight) light, real3 origin, real3 direction, real t1)
{
  AirlightRay ray;
  ray.origin = origin;
  ray.direction = direction;
  ray.range = real2(t1, real(0.0));
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    real2 range = airlightRegionRange(media.item[i].region, origin, direction, t1);
    if (range.y > range.x)
    {
      ray.range = real2(min(ray.range.x, range.x), max(ray.range.y, range.y));
    }
  }
  ray.range = real2(min(ray.range.x, t1), max(ray.range.y, min(ray.range.x, t1)));
  real3 toLight = light.position - origin;
  ray.foot.tL = dot(toLight, direction) - ray.range.x;
  ray.foot.h = max(length(cross(toLight, direction)), light.radius);
  ray.lit = ray.range;
#ifndef AIRLIGHT_NO_CONE
  if (light.cosCone > real(0.0))
  {
    ray.lit = airlightConeRange(light, ray);
  }
#endif
  return ray;
}
