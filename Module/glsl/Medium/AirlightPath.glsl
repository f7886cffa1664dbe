// A ray's way through one medium. `surface`: whether its region is a closed surface, which of a
// medium among others is known when a shader is compiled.

// Ends closer to t than this are at t.
AIRLIGHT_FN real airlightAfter(real t)
{
#ifdef AIRLIGHT_DOUBLE
  return t + real(1e-13) * abs(t);
#else
  return t + real(1e-6) * abs(t);
#endif
}

#if AIRLIGHT_HAS_GRID
#if AIRLIGHT_HAS_SURFACE
// From hit to hit.
AIRLIGHT_FN real airlightGridDepthInSurface(
  AIRLIGHT_IN(AirlightMedium) medium, real3 origin, real3 direction, real from, real to)
{
  real2 range = airlightRegionRange(medium.region, origin, direction, to);
  real t = max(from, range.x);
  real sum = real(0.0);
  while (t < range.y)
  {
    real3 at = airlightSurfaceSums(medium, origin, direction, t, airlightAfter(t));
    real end = min(at.y, range.y);
    if (at.z > real(0.5))
    {
      sum += AIRLIGHT_GRID_DEPTH(medium, origin, direction, t, end);
    }
    t = end;
  }
  return sum;
}
#endif

// Integral of the density of an image along the part of [from, to] of a ray that is in the region.
AIRLIGHT_FN real airlightGridDepthInRegion(AIRLIGHT_IN(AirlightMedium) medium, bool surface,
  real3 origin, real3 direction, real from, real to)
{
#if AIRLIGHT_HAS_SURFACE
  if (surface)
  {
    return airlightGridDepthInSurface(medium, origin, direction, from, to);
  }
#endif
  real2 range = airlightRegionRange(medium.region, origin, direction, to);
  return AIRLIGHT_GRID_DEPTH(medium, origin, direction, max(range.x, from), range.y);
}
#endif

// Integral of the density along the part of [0, l] of a ray that is inside the region: times
// sigmaT it is the optical depth.
AIRLIGHT_FN real airlightPathDepth(
  AIRLIGHT_IN(AirlightMedium) medium, bool surface, real3 origin, real3 direction, real l)
{
#if AIRLIGHT_HAS_GRID
  if (AIRLIGHT_DENSITY_KIND(medium) == AIRLIGHT_DENSITY_GRID)
  {
    return airlightGridDepthInRegion(medium, surface, origin, direction, real(0.0), l);
  }
#endif
  if (surface)
  {
    return airlightSurfaceSums(medium, origin, direction, l, real(0.0)).x;
  }
  real2 range = airlightRegionRange(medium.region, origin, direction, l);
  return airlightFormulaDepth(medium, origin, direction, range.x, range.y);
}

// The same on the way to a light at infinity. An unbounded uniform medium would swallow it: there
// the light is taken as unattenuated.
AIRLIGHT_FN real airlightSunDepth(
  AIRLIGHT_IN(AirlightMedium) medium, bool surface, real3 point, real3 toLight)
{
  if (AIRLIGHT_REGION_KIND(medium.region) == AIRLIGHT_REGION_UNBOUNDED &&
    AIRLIGHT_DENSITY_KIND(medium) == AIRLIGHT_DENSITY_UNIFORM)
  {
    return real(0.0);
  }
  return airlightPathDepth(medium, surface, point, toLight, real(AIRLIGHT_FAR));
}

// What is known of the path at t, at or a little before `after`; x: airlightPathDepth() up to t, if
// it is asked for; y: where after `after` the ray next enters or leaves the region, or a surface's
// box; z: 1 where it is inside between, else 0.
AIRLIGHT_FN real3 airlightPathAt(AIRLIGHT_IN(AirlightMedium) medium, bool surface, real3 origin,
  real3 direction, real t, real after, bool hasDepth)
{
  real2 range = airlightRegionRange(medium.region, origin, direction, real(AIRLIGHT_FAR));
  real3 at = real3(real(0.0), range.y, real(1.0));
  if (surface)
  {
    at = airlightSurfaceSums(medium, origin, direction, t, after);
    at.y = min(at.y, range.y);
  }
#if AIRLIGHT_HAS_GRID
  bool image = AIRLIGHT_DENSITY_KIND(medium) == AIRLIGHT_DENSITY_GRID;
  if (hasDepth && image)
  {
    at.x = airlightGridDepthInRegion(medium, surface, origin, direction, real(0.0), t);
  }
#else
  const bool image = false;
#endif
  if (hasDepth && !image && !surface)
  {
    at.x = airlightFormulaDepth(medium, origin, direction, range.x, clamp(t, range.x, range.y));
  }
  if (range.y <= range.x || after >= range.y)
  {
    return real3(at.x, real(AIRLIGHT_FAR), real(0.0));
  }
  return after < range.x ? real3(at.x, range.x, real(0.0)) : at;
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
