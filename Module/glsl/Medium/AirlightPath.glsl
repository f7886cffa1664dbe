// A ray's way through one medium.

// Integral of the density along the part of [0, l] of a ray that is inside the region: times
// sigmaT it is the optical depth.
AIRLIGHT_FN real airlightPathDepth(
  AIRLIGHT_IN(AirlightMedium) medium, real3 origin, real3 direction, real l)
{
  if (AIRLIGHT_REGION_KIND(medium.region) == AIRLIGHT_REGION_SURFACE)
  {
    return airlightSurfaceSums(medium, origin, direction, l, real(0.0)).x;
  }
  real2 range = airlightRegionRange(medium.region, origin, direction, l);
  return airlightInsideDepth(medium, origin, direction, range.x, range.y);
}

// The same on the way to a light at infinity. An unbounded uniform medium would swallow it: there
// the light is taken as unattenuated.
AIRLIGHT_FN real airlightSunDepth(
  AIRLIGHT_IN(AirlightMedium) medium, real3 point, real3 toLight)
{
  if (AIRLIGHT_REGION_KIND(medium.region) == AIRLIGHT_REGION_UNBOUNDED &&
    AIRLIGHT_DENSITY_KIND(medium) == AIRLIGHT_DENSITY_UNIFORM)
  {
    return real(0.0);
  }
  return airlightPathDepth(medium, point, toLight, real(AIRLIGHT_FAR));
}

// x: where after t the ray next enters or leaves the region, or a surface's box; y: 1 where it is
// inside between, else 0.
AIRLIGHT_FN real2 airlightNextEnd(
  AIRLIGHT_IN(AirlightMedium) medium, real3 origin, real3 direction, real t)
{
  real2 range = airlightRegionRange(medium.region, origin, direction, real(AIRLIGHT_FAR));
  if (range.y <= range.x || t >= range.y)
  {
    return real2(real(AIRLIGHT_FAR), real(0.0));
  }
  if (t < range.x)
  {
    return real2(range.x, real(0.0));
  }
  if (AIRLIGHT_REGION_KIND(medium.region) == AIRLIGHT_REGION_SURFACE)
  {
    real3 sums = airlightSurfaceSums(medium, origin, direction, real(0.0), t);
    return real2(min(sums.y, range.y), sums.z > real(0.5) ? real(1.0) : real(0.0));
  }
  return real2(range.y, real(1.0));
}

// Extinction, at density 1, of the channel that fades least among those that fade: the far end of
// what matters depends on it.
AIRLIGHT_FN real airlightLeastExtinction(AIRLIGHT_IN(AirlightMedium) medium)
{
  // A clear channel scatters nothing and has no say.
  real x = medium.sigmaT.x > real(0.0) ? medium.sigmaT.x : real(AIRLIGHT_FAR);
  real y = medium.sigmaT.y > real(0.0) ? medium.sigmaT.y : real(AIRLIGHT_FAR);
  real z = medium.sigmaT.z > real(0.0) ? medium.sigmaT.z : real(AIRLIGHT_FAR);
  return min(x, min(y, z));
}
