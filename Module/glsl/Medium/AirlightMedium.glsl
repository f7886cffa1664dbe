// One medium: coefficients, phase function, region and how its density varies in it.

#define AIRLIGHT_DENSITY_UNIFORM 0
#define AIRLIGHT_DENSITY_HEIGHT 1 // exp(-height/scaleHeight)
#define AIRLIGHT_DENSITY_GRID 2   // an image's samples (AirlightDensityGrid.h, AirlightGrid.glsl)

// What depends on extinction: one number where all media are grey.
#if defined(AIRLIGHT_GREY) && AIRLIGHT_GREY
#define AirlightSpectrum real
#define AIRLIGHT_SPECTRUM(colour) (colour).x
#else
#define AirlightSpectrum real3
#define AIRLIGHT_SPECTRUM(colour) (colour)
#endif

struct AirlightMedium
{
  real3 sigmaS;  // scattering coefficient at density 1, 1/world; with albedos at places, extinction
  real3 sigmaT;  // extinction coefficient at density 1, 1/world
  real3 ambient; // ambient radiance, the mean of all directions
  real3 emission; // emission coefficient at density 1
  AirlightPhase phase;
  AirlightRegion region;
  int density;
  real3 up;               // unit vector
  real inverseScaleHeight;
  real originHeight;      // of the origin of coordinates above the height of density 1
  AIRLIGHT_SKY_MEMBER
  AIRLIGHT_GRID_MEMBER
};

// Whether an image has arrays of colours.
#ifndef AIRLIGHT_HAS_COLOURS
#define AIRLIGHT_HAS_COLOURS(medium) false
#endif

// Likewise.
#ifndef AIRLIGHT_DENSITY_KIND
#define AIRLIGHT_DENSITY_KIND(medium) (medium).density
#endif

// (1 - exp(-sigma l))/sigma, sigma >= 0: the optical length of a way of length l along which
// density falls exponentially; l where sigma is 0.
AIRLIGHT_FN real airlightOpticalLength(real sigma, real l)
{
  real depth = sigma * l;
  if (depth < real(0.02))
  {
    return l *
      (real(1.0) -
        depth * (real(0.5) -
        depth * (real(0.16666666666666667) -
        depth * (real(0.041666666666666667) -
        depth * (real(0.0083333333333333333) -
        depth * (real(0.0013888888888888889) - depth * real(0.00019841269841269841)))))));
  }
  return (real(1.0) - exp(-depth)) / sigma;
}

// The integral of exp(-(depth + rate u)) over u in [0, l], for each channel. From whichever end is
// less deep: a rate below 0 would grow beyond all numbers before it is made small again.
AIRLIGHT_FN real airlightFading(real depth, real rate, real l)
{
  return rate >= real(0.0) ? exp(-depth) * airlightOpticalLength(rate, l)
                           : exp(-(depth + rate * l)) * airlightOpticalLength(-rate, l);
}

AIRLIGHT_FN real3 airlightFading3(real3 depth, real3 rate, real l)
{
  return real3(airlightFading(depth.x, rate.x, l), airlightFading(depth.y, rate.y, l),
    airlightFading(depth.z, rate.z, l));
}

// The ambient radiance that is scattered into a ray of this direction. Harmonics may be below 0.
AIRLIGHT_FN real3 airlightAmbientRadiance(AIRLIGHT_IN(AirlightMedium) medium, real3 direction)
{
#ifdef AIRLIGHT_HAS_SKY
  if (medium.sky.on != 0)
  {
    return max(medium.ambient + airlightSkyPart(medium.sky, direction), real3(real(0.0)));
  }
#endif
  return medium.ambient;
}

// What shines by itself at density 1 into a ray of this direction, per unit of length: ambient
// light that is scattered, and emission.
AIRLIGHT_FN real3 airlightSource(AIRLIGHT_IN(AirlightMedium) medium, real3 direction)
{
  return medium.sigmaS * airlightAmbientRadiance(medium, direction) + medium.emission;
}

// The scattering coefficient and airlightSource() at density 1 at a point: images can have arrays
// of colours, of which sigmaS and the emission are multiples.
AIRLIGHT_FN real3 airlightScatteringAt(AIRLIGHT_IN(AirlightMedium) medium, real3 point)
{
#ifdef AIRLIGHT_GRID_COLOUR
  return medium.sigmaS * AIRLIGHT_GRID_COLOUR(medium, medium.albedo, point);
#else
  return medium.sigmaS;
#endif
}

AIRLIGHT_FN real3 airlightSourceAt(
  AIRLIGHT_IN(AirlightMedium) medium, real3 point, real3 direction)
{
#ifdef AIRLIGHT_GRID_COLOUR
  return airlightScatteringAt(medium, point) * airlightAmbientRadiance(medium, direction) +
    medium.emission * AIRLIGHT_GRID_COLOUR(medium, medium.glow, point);
#else
  return airlightSource(medium, direction);
#endif
}

AIRLIGHT_FN real airlightHeight(AIRLIGHT_IN(AirlightMedium) medium, real3 point)
{
  return medium.originHeight + dot(medium.up, point);
}

// At a height in scale heights. Deep below, the medium is opaque anyway; the bound keeps numbers
// finite.
AIRLIGHT_FN real airlightExponentialDensity(real height)
{
  return exp(min(-height, real(80.0)));
}

// Density at a point inside the region.
AIRLIGHT_FN real airlightDensity(AIRLIGHT_IN(AirlightMedium) medium, real3 point)
{
  if (AIRLIGHT_DENSITY_KIND(medium) == AIRLIGHT_DENSITY_UNIFORM)
  {
    return real(1.0);
  }
#if AIRLIGHT_HAS_GRID
  if (AIRLIGHT_DENSITY_KIND(medium) == AIRLIGHT_DENSITY_GRID)
  {
    return AIRLIGHT_GRID_DENSITY(medium, point);
  }
#endif
  return airlightExponentialDensity(airlightHeight(medium, point) * medium.inverseScaleHeight);
}

// Integral of the density along [from, to] of a ray, all of it inside the region; of an image its
// length.
AIRLIGHT_FN real airlightFormulaDepth(
  AIRLIGHT_IN(AirlightMedium) medium, real3 origin, real3 direction, real from, real to)
{
  if (AIRLIGHT_DENSITY_KIND(medium) != AIRLIGHT_DENSITY_HEIGHT)
  {
    return to - from;
  }
  // From the lower end, where the density is largest.
  real rate = dot(medium.up, direction) * medium.inverseScaleHeight;
  real lower = rate >= real(0.0) ? from : to;
  // Opaque either way, and a channel without extinction stays clear: infinity times 0 is not a
  // number.
  return min(airlightDensity(medium, origin + lower * direction) *
      airlightOpticalLength(abs(rate), to - from),
    real(1e30));
}

// The same of any density.
AIRLIGHT_FN real airlightInsideDepth(
  AIRLIGHT_IN(AirlightMedium) medium, real3 origin, real3 direction, real from, real to)
{
#if AIRLIGHT_HAS_GRID
  if (AIRLIGHT_DENSITY_KIND(medium) == AIRLIGHT_DENSITY_GRID)
  {
    return AIRLIGHT_GRID_DEPTH(medium, origin, direction, from, to);
  }
#endif
  return airlightFormulaDepth(medium, origin, direction, from, to);
}

// True where all channels fade alike, so that one of them serves for three.
AIRLIGHT_FN bool airlightIsGrey(AIRLIGHT_IN(AirlightMedium) medium)
{
#ifdef AIRLIGHT_GREY
  return AIRLIGHT_GREY != 0;
#else
  return medium.sigmaT.x == medium.sigmaT.y && medium.sigmaT.x == medium.sigmaT.z;
#endif
}

// What is left of light after these optical depths. Shaders know whether all channels fade alike;
// what the depths of the others take is left out then, too.
AIRLIGHT_FN real3 airlightTransmittanceOf(real3 depth)
{
#if defined(AIRLIGHT_GREY) && AIRLIGHT_GREY
  return real3(exp(-depth.x));
#else
  return exp(-depth);
#endif
}
