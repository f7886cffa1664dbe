// Rays through media whose density falls exponentially with height: how far they matter, and where
// quadrature is cut. Heights are in scale heights here, so that a density is exp(-height); a ray
// may cross thousands of them of which a dozen count.

// Least and greatest difference of heights outside of which nothing is left of light or density.
#define AIRLIGHT_DARK_HEIGHTS 4.0 // exp(-exp(4))
#ifdef AIRLIGHT_DOUBLE
#define AIRLIGHT_THIN_HEIGHTS 40.0
#else
#define AIRLIGHT_THIN_HEIGHTS 20.0 // exp(-20)
#endif

// How many scale heights a ray rises in one unit.
AIRLIGHT_FN real airlightRise(AIRLIGHT_IN(AirlightMedium) medium, real3 direction)
{
  return dot(medium.up, direction) * medium.inverseScaleHeight;
}

AIRLIGHT_FN real airlightScaleHeights(AIRLIGHT_IN(AirlightMedium) medium, real3 point)
{
  return airlightHeight(medium, point) * medium.inverseScaleHeight;
}

// How far from a point a ray goes until its optical depth is `depth`, where extinction is sigma at
// density 1; AIRLIGHT_FAR where it never is.
AIRLIGHT_FN real airlightFadingLength(
  AIRLIGHT_IN(AirlightMedium) medium, real3 point, real3 direction, real sigma, real depth)
{
  if (sigma <= real(0.0))
  {
    return real(AIRLIGHT_FAR);
  }
  if (AIRLIGHT_DENSITY_KIND(medium) != AIRLIGHT_DENSITY_HEIGHT)
  {
    return depth / sigma;
  }
  // depth = sigma exp(-height) (1 - exp(-rise l))/rise, by logarithms: exp(-height) may be beyond
  // all numbers, as may be the way at the density of the point.
  real rise = airlightRise(medium, direction);
  real way = log(depth / sigma) + max(airlightScaleHeights(medium, point), real(-80.0));
  real turn = way + log(max(abs(rise), real(1e-30)));
  if (turn < real(-7.0))
  {
    return exp(way);
  }
  if (rise > real(0.0))
  {
    return turn < real(0.0) ? -log(real(1.0) - exp(turn)) / rise : real(AIRLIGHT_FAR);
  }
  return (turn > real(20.0) ? turn : log(real(1.0) + exp(turn))) / max(-rise, real(1e-30));
}

// How far from a point a ray goes until nothing of the density is left, above heights at which even
// a light from near the horizon comes through; AIRLIGHT_FAR where it never is.
AIRLIGHT_FN real airlightThinningLength(
  AIRLIGHT_IN(AirlightMedium) medium, real3 point, real3 direction, real sigma)
{
  real rise = airlightRise(medium, direction);
  if (AIRLIGHT_DENSITY_KIND(medium) != AIRLIGHT_DENSITY_HEIGHT || rise <= real(1e-18))
  {
    return real(AIRLIGHT_FAR);
  }
  real thickness = log(max(sigma, real(1e-30)) / rise) - airlightScaleHeights(medium, point);
  return (real(AIRLIGHT_THIN_HEIGHTS) + max(thickness + real(5.0), real(0.0))) / rise;
}

// Height at which the way to a light at infinity has an optical depth of 1; far below where there
// is none.
AIRLIGHT_FN real airlightDimHeight(AIRLIGHT_IN(AirlightMedium) medium, real3 toLight)
{
  real slope = airlightRise(medium, toLight);
  real sigma = max(medium.sigmaT.x, max(medium.sigmaT.y, medium.sigmaT.z));
  return slope > real(1e-18) && sigma > real(0.0) ? log(sigma / slope) : real(-AIRLIGHT_FAR);
}

// The first t in (t0, t1), else t1, at which a ray enters or leaves what counts of [from, end]:
// from a little below the height at which the light is dim up to where nothing is left of the
// density, above that height and above where the ray is lowest.
AIRLIGHT_FN real airlightLayerEnd(AIRLIGHT_IN(AirlightMedium) medium, real3 origin, real3 direction,
  real2 part, real dim, real t0, real t1)
{
  if (AIRLIGHT_DENSITY_KIND(medium) != AIRLIGHT_DENSITY_HEIGHT)
  {
    return t1;
  }
  real rise = airlightRise(medium, direction);
  real start = airlightScaleHeights(medium, origin);
  real lowest = start + rise * (rise > real(0.0) ? part.x : part.y);
  // Level rays have no such place: what is not a number is not between t0 and t1.
  real dark = (dim - real(AIRLIGHT_DARK_HEIGHTS) - start) / rise;
  real thin = (max(lowest, dim) + real(AIRLIGHT_THIN_HEIGHTS) - start) / rise;
  // A little after t0, which may be one of them.
  t0 *= real(1.000001);
  t1 = dark > t0 && dark < t1 ? dark : t1;
  return thin > t0 && thin < t1 ? thin : t1;
}
