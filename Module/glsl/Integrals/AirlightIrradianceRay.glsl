// What the integral over a surface's hemisphere in AirlightScatteredIrradiance.glsl is made of:
// directions, and the radiance that arrives from each.

#define AIRLIGHT_PI 3.1415926535897932

// A surface's point and what the directions from it are counted by.
struct AirlightIrradianceFrame
{
  real3 point;
  real3 normal;
  real3 axis;   // gamma = 0: to the light, or to the region (see airlightIrradianceFrame())
  real3 across; // phi = 0: the side of the axis that the normal is on
  real3 third;
  real cosTilt; // of the normal against the axis
  real sinTilt;
  bool cone;    // the axis goes through a spot's tip
  bool outside; // of the one region, which holds a point of the axis
};

AIRLIGHT_FN real airlightArcCosine(real x)
{
  return airlightAngle(sqrt(max(real(1.0) - x * x, real(0.0))), x);
}

// A unit vector across the axis.
AIRLIGHT_FN real3 airlightAcross(real3 axis)
{
  real3 other = abs(axis.x) < real(0.6) ? real3(real(1.0), real(0.0), real(0.0))
                                        : real3(real(0.0), real(1.0), real(0.0));
  return normalize(cross(axis, other));
}

AIRLIGHT_FN AirlightIrradianceFrame airlightIrradianceFrame(
  AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light, real3 point, real3 normal)
{
  AirlightIrradianceFrame frame;
  frame.point = point;
  frame.normal = normal;
  bool sun = airlightIsDirectional(light);
  real3 way = sun ? light.position : light.position - point;
  frame.cone = light.cosCone > real(0.0);
  frame.outside = false;
  if (AIRLIGHT_MEDIUM_COUNT == 1 && !airlightHolds(airlightMedia.item[0].region, point))
  {
    frame.outside = true;
    // Seen from outside, a region that does not hold the light may be on another side.
    if (sun || !airlightHolds(airlightMedia.item[0].region, light.position))
    {
      way = airlightRegionMiddle(airlightMedia.item[0].region) - point;
      frame.cone = false;
    }
  }
  real l = length(way);
  // On the light itself all directions are alike.
  frame.axis = l > real(0.0) ? way / l : normal;
  real3 side = normal - dot(normal, frame.axis) * frame.axis;
  frame.cosTilt = clamp(dot(normal, frame.axis), real(-1.0), real(1.0));
  frame.sinTilt = length(side);
  frame.across =
    frame.sinTilt > real(1e-5) ? side / frame.sinTilt : airlightAcross(frame.axis);
  frame.third = cross(frame.axis, frame.across);
  return frame;
}

// What a light that needs quadrature scatters into one piece of a ray, with few nodes: many rays
// are summed.
AIRLIGHT_FN real3 airlightIrradiancePiece(AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light,
  AIRLIGHT_IN(AirlightRay) ray, AIRLIGHT_IN(AirlightPiece) piece)
{
  real t0 = piece.from;
  real t1 = airlightNegligibleFrom(AIRLIGHT_MEDIA_OUT piece, ray.origin, ray.direction);
  bool sun = airlightIsDirectional(light);
  real v0 = sun ? t0 : airlightAsinh(airlightFromFoot(ray, t0) / ray.foot.h);
  real v1 = sun ? t1 : airlightAsinh(airlightFromFoot(ray, t1) / ray.foot.h);
  // One panel on each side of the light's foot, where the peak is.
  real middle = sun ? v1 : clamp(real(0.0), v0, v1);
  real3 sum = real3(real(0.0));
  for (int side = 0; side < AIRLIGHT_ROLLED(2); side++)
  {
    real from = side == 0 ? v0 : middle;
    real to = side == 0 ? middle : v1;
    if (to > from)
    {
      real3 errorEstimate;
      sum +=
        airlightPanel(AIRLIGHT_MEDIA_OUT light, ray, piece, sun, from, to, false, errorEstimate);
    }
  }
  return sum;
}

AIRLIGHT_FN real3 airlightIrradianceQuadrature(
  AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray)
{
  real3 sum = real3(real(0.0));
  real t0 = ray.lit.x;
  while (t0 < ray.lit.y)
  {
    AirlightPiece piece =
      airlightPieceAt(AIRLIGHT_MEDIA_OUT ray.origin, ray.direction, t0, ray.lit.y);
    if (piece.inside != 0)
    {
      sum += airlightIrradiancePiece(AIRLIGHT_MEDIA_OUT light, ray, piece);
    }
    t0 = piece.to;
  }
  return light.intensity * sum;
}

// Radiance that arrives at the point from a direction.
AIRLIGHT_FN real3 airlightArriving(
  AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light, real3 point, real3 direction)
{
  AirlightRay ray = airlightRay(AIRLIGHT_MEDIA_OUT light, point, direction, real(AIRLIGHT_FAR));
  if (!(ray.lit.y > ray.lit.x))
  {
    return real3(real(0.0));
  }
  if (AIRLIGHT_LIGHT_KIND == AIRLIGHT_POINT_QUADRATURE ||
    AIRLIGHT_LIGHT_KIND == AIRLIGHT_DIRECTIONAL_QUADRATURE)
  {
    return airlightIrradianceQuadrature(AIRLIGHT_MEDIA_OUT light, ray);
  }
  return airlightInterval3(AIRLIGHT_MEDIA_OUT light, ray, ray.lit.x,
    airlightTail3(AIRLIGHT_MEDIA_OUT light, ray, ray.lit.x), ray.lit.y,
    airlightTail3(AIRLIGHT_MEDIA_OUT light, ray, ray.lit.y));
}
