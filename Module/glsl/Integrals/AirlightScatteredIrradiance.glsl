// The irradiance on a surface from light that the medium scattered once on its way to it: the
// integral over the hemisphere of L(w) max(0, n.w), with L(w) what airlightInterval3() gives for
// the whole ray from the surface along w. Unshadowed. After B. Sun, R. Ramamoorthi, S. Narasimhan
// and S. Nayar, "A practical analytic single scattering model for real time rendering", SIGGRAPH
// 2005, by quadrature in place of their table.
//
// In spherical coordinates about the direction to the light, gamma from it and phi around it, where
// the peak 1/sin(gamma) towards the light is smooth: dw = sin(gamma) dgamma dphi, and gamma = v^2
// puts nodes where the phase function and the extinction are steep.

// Nodes of the lattice below: Fibonacci numbers, the step is the one before.
#define AIRLIGHT_IRRADIANCE_FEW 377
#define AIRLIGHT_IRRADIANCE_FEW_STEP 233
#define AIRLIGHT_IRRADIANCE_SOME 987
#define AIRLIGHT_IRRADIANCE_SOME_STEP 610
#define AIRLIGHT_IRRADIANCE_MANY 1597
#define AIRLIGHT_IRRADIANCE_MANY_STEP 987

// ---- Where radiance depends on gamma alone: one uniform unbounded medium, no cone ---------------

// The integral of max(0, n.w) over phi.
AIRLIGHT_FN real airlightCosineRing(AIRLIGHT_IN(AirlightIrradianceFrame) frame, real gamma)
{
  real a = cos(gamma) * frame.cosTilt;
  real b = sin(gamma) * frame.sinTilt;
  if (a >= b)
  {
    return real(2.0 * AIRLIGHT_PI) * a;
  }
  if (a <= -b)
  {
    return real(0.0);
  }
  real phi0 = airlightArcCosine(-a / b);
  return real(2.0) * (a * phi0 + b * sin(phi0));
}

AIRLIGHT_FN real3 airlightIrradianceRings(AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light,
  AIRLIGHT_IN(AirlightIrradianceFrame) frame, real from, real to, int panels)
{
  real v0 = sqrt(from);
  real reach = real(0.5) * (sqrt(to) - v0) / real(panels);
  real3 sum = real3(real(0.0));
  for (int k = 0; k < AIRLIGHT_ROLLED(panels * AIRLIGHT_GAUSS_COUNT); k++)
  {
    real2 node = airlightGaussNode((k % AIRLIGHT_GAUSS_COUNT) / 2);
    real middle = v0 + real(2 * (k / AIRLIGHT_GAUSS_COUNT) + 1) * reach;
    real v = middle + (k % 2 == 0 ? reach : -reach) * node.x;
    real gamma = v * v;
    real3 direction = cos(gamma) * frame.axis + sin(gamma) * frame.across;
    sum += node.y * v * sin(gamma) * airlightCosineRing(frame, gamma) *
      airlightArriving(AIRLIGHT_MEDIA_OUT light, frame.point, direction);
  }
  return real(2.0) * reach * sum;
}

// Split where rings begin and end to cross the horizon.
AIRLIGHT_FN real3 airlightIrradianceAround(
  AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightIrradianceFrame) frame)
{
  real c = airlightAngle(abs(frame.cosTilt), frame.sinTilt);
  // Exponentials are cheap, and a forward phase function is steep.
  int panels = airlightIsDirectional(light) ? 2 : 1;
  real pi = real(AIRLIGHT_PI);
  bool front = frame.cosTilt > real(0.0);
  return airlightIrradianceRings(AIRLIGHT_MEDIA_OUT light, frame, c, pi - c, panels) +
    airlightIrradianceRings(
      AIRLIGHT_MEDIA_OUT light, frame, front ? real(0.0) : pi - c, front ? c : pi, panels);
}

// ---- Elsewhere: a Fibonacci lattice over v and phi ----------------------------------------------

// The gammas (from, to) of azimuth phi above the horizon.
AIRLIGHT_FN real2 airlightIrradianceHorizon(AIRLIGHT_IN(AirlightIrradianceFrame) frame, real cosPhi)
{
  bool front = frame.cosTilt > real(0.0);
  real side = frame.sinTilt * cosPhi;
  real horizon = airlightAngle(abs(frame.cosTilt), front ? -side : side);
  return front ? real2(real(0.0), horizon) : real2(horizon, real(AIRLIGHT_PI));
}

// The largest gamma of azimuth `ring` at which a ray meets a spot's cone. In the half-plane of one
// azimuth the ray sees the light's directions at angles theta > gamma from the axis; those in
// the cone are within delta of theta0.
AIRLIGHT_FN real airlightIrradianceCone(
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightIrradianceFrame) frame, real3 ring)
{
  real along = dot(light.axis, frame.axis);
  real outwards = dot(light.axis, ring);
  real rest = along * along + outwards * outwards - light.cosCone * light.cosCone;
  if (rest <= real(0.0))
  {
    return real(0.0);
  }
  real delta = airlightAngle(sqrt(rest), light.cosCone);
  real theta0 = airlightAngle(abs(outwards), along);
  if (outwards >= real(0.0))
  {
    return min(theta0 + delta, real(AIRLIGHT_PI));
  }
  // Turned to the other side, the cone reaches this one across the axis, ahead or behind.
  return along > real(0.0)
    ? max(delta - theta0, real(0.0))
    : (theta0 + delta > real(AIRLIGHT_PI) ? real(AIRLIGHT_PI) : real(0.0));
}

// The largest gamma of azimuth `ring` at which a ray meets the region, by bisection of v: gamma = 0
// meets it, and the region is convex.
AIRLIGHT_FN real airlightIrradianceEdge(
  AIRLIGHT_IN(AirlightRegion) region, AIRLIGHT_IN(AirlightIrradianceFrame) frame, real3 ring)
{
  real low = real(0.0);
  real high = sqrt(real(AIRLIGHT_PI));
  for (int i = 0; i < AIRLIGHT_ROLLED(12); i++)
  {
    real middle = real(0.5) * (low + high);
    real gamma = middle * middle;
    real3 direction = cos(gamma) * frame.axis + sin(gamma) * ring;
    real2 range = airlightRegionRange(region, frame.point, direction, real(AIRLIGHT_FAR));
    bool meets = range.y > range.x;
    low = meets ? middle : low;
    high = meets ? high : middle;
  }
  return high * high;
}

// Middle and half width of the azimuths at which rays meet a spot's cone.
AIRLIGHT_FN real2 airlightIrradianceSector(
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightIrradianceFrame) frame)
{
  real along = dot(light.axis, frame.axis);
  real c2 = light.cosCone * light.cosCone - along * along;
  if (!frame.cone || c2 <= real(0.0))
  {
    return real2(real(0.0), real(AIRLIGHT_PI));
  }
  real x = dot(light.axis, frame.across);
  real y = dot(light.axis, frame.third);
  real middle = airlightAngle(abs(y), x);
  return real2(y < real(0.0) ? -middle : middle,
    airlightArcCosine(min(sqrt(c2 / max(x * x + y * y, c2)), real(1.0))));
}

// One node: u in the unit square.
AIRLIGHT_FN real3 airlightIrradianceNode(AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light,
  AIRLIGHT_IN(AirlightIrradianceFrame) frame, real2 sector, real2 u)
{
  real arc = real(2.0 * AIRLIGHT_PI) * u.x;
  real phi = arc;
  real weight = real(2.0 * AIRLIGHT_PI);
  if (sector.y < real(AIRLIGHT_PI))
  {
    // Periodic again: fewer nodes towards the sector's ends.
    phi = sector.x + sector.y * (real(2.0) * u.x - real(1.0) - sin(arc) / real(AIRLIGHT_PI));
    weight = sector.y * (real(2.0) - real(2.0) * cos(arc));
  }
  real3 ring = cos(phi) * frame.across + sin(phi) * frame.third;
  real2 range = airlightIrradianceHorizon(frame, cos(phi));
  if (frame.cone)
  {
    range.y = min(range.y, airlightIrradianceCone(light, frame, ring));
  }
  if (frame.outside)
  {
    range.y = min(range.y, airlightIrradianceEdge(airlightMedia.item[0].region, frame, ring));
  }
  if (!(range.y > range.x))
  {
    return real3(real(0.0));
  }
  real v0 = sqrt(range.x);
  real across = sqrt(range.y) - v0;
  real v = v0 + across * u.y * u.y * (real(3.0) - real(2.0) * u.y);
  weight *= across * real(12.0) * u.y * (real(1.0) - u.y) * v;
  real gamma = v * v;
  real3 direction = cos(gamma) * frame.axis + sin(gamma) * ring;
  weight *= sin(gamma) * max(dot(frame.normal, direction), real(0.0));
  return weight * airlightArriving(AIRLIGHT_MEDIA_OUT light, frame.point, direction);
}

AIRLIGHT_FN real3 airlightIrradianceLattice(
  AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightIrradianceFrame) frame)
{
  int count = AIRLIGHT_IRRADIANCE_FEW;
  int stride = AIRLIGHT_IRRADIANCE_FEW_STEP;
  // Where rays leave a region through an edge, radiance has kinks, which take more nodes.
  if (AIRLIGHT_LIGHT_KIND == AIRLIGHT_POINT_CLOSED &&
    airlightHasEdges(airlightMedia.item[0].region))
  {
    count = AIRLIGHT_IRRADIANCE_SOME;
    stride = AIRLIGHT_IRRADIANCE_SOME_STEP;
  }
  else if (AIRLIGHT_LIGHT_KIND == AIRLIGHT_DIRECTIONAL_CLOSED ||
    AIRLIGHT_LIGHT_KIND == AIRLIGHT_DIRECTIONAL_HEIGHT)
  {
    count = AIRLIGHT_IRRADIANCE_MANY;
    stride = AIRLIGHT_IRRADIANCE_MANY_STEP;
  }
  real2 sector = airlightIrradianceSector(light, frame);
  real3 sum = real3(real(0.0));
  for (int k = 0; k < count; k++)
  {
    real2 u = (real2(real(k), real((k * stride) % count)) + real2(real(0.5))) / real(count);
    sum += airlightIrradianceNode(AIRLIGHT_MEDIA_OUT light, frame, sector, u);
  }
  return sum / real(count);
}

// The irradiance on a surface at `point` with the unit normal `normal`.
AIRLIGHT_FN real3 airlightScatteredIrradiance(
  AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light, real3 point, real3 normal)
{
  real3 sigmaS = real3(real(0.0));
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    sigmaS += airlightMedia.item[i].sigmaS;
  }
  if (!(dot(sigmaS, real3(real(1.0))) > real(0.0)))
  {
    return sigmaS;
  }
  AirlightIrradianceFrame frame = airlightIrradianceFrame(AIRLIGHT_MEDIA_OUT light, point, normal);
  bool closed = AIRLIGHT_LIGHT_KIND == AIRLIGHT_POINT_CLOSED ||
    AIRLIGHT_LIGHT_KIND == AIRLIGHT_DIRECTIONAL_CLOSED;
  real3 sum = closed && light.cosCone <= real(0.0) &&
      AIRLIGHT_REGION_KIND(airlightMedia.item[0].region) == AIRLIGHT_REGION_UNBOUNDED
    ? airlightIrradianceAround(AIRLIGHT_MEDIA_OUT light, frame)
    : airlightIrradianceLattice(AIRLIGHT_MEDIA_OUT light, frame);
  // A channel that does not scatter is dark, whatever the limit of its integral.
  return mix(real3(real(0.0)), sum, greaterThan(sigmaS, real3(real(0.0))));
}
