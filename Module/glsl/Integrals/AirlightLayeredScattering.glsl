// Light of suns that was scattered more than once, in media of level layers: fog that thins with
// height, and boxes, which count as layers across the sun's shortest way through them. By
// Eddington's approximation with a forward peak of weight g^2, which goes straight on (Joseph,
// Wiscombe and Weinman, "The Delta-Eddington Approximation for Radiative Flux Transfer", 1976): for
// each unit of irradiance the radiance i0 + i1 mu, mu the cosine with the way down, at the optical
// depth tau below the lit side is a sum of exponentials,
//
//   i0, i1 = fall (1, p) e^(-k tau) + climb (1, -p) e^(-k (end - tau)) - beam e^(-tau/mu0)
//
// so that a ray's integral is closed. Light that was scattered forward by the peak keeps a lobe
// twice as wide as one scattering's. LayeredSolution makes the terms.

// The rows of a sun in AirlightMultiple: directions in the module's coordinates, the rest a channel
// each. All depths are of the medium without its peaks.
#define AIRLIGHT_SUN_DIRECTION 0  // unit vector to it; the cosine mu0 with the layers' normal
#define AIRLIGHT_SUN_LAYERS 1     // their normal, towards the sun's side; see airlightLayerDepth
#define AIRLIGHT_SUN_IRRADIANCE 2
#define AIRLIGHT_SUN_SHARE 3      // what the sides of a box leave
#define AIRLIGHT_SUN_END 4        // the depth of the other side
#define AIRLIGHT_SUN_FALL 5       // of i0
#define AIRLIGHT_SUN_CLIMB 6      // of i0
#define AIRLIGHT_SUN_BEAM 7       // of i0
#define AIRLIGHT_SUN_BEAM_FLUX 8  // of i1

// Of one light along a ray, per unit of its power: what was scattered more than once, and what
// would be scattered once if nothing cast shadows.
struct AirlightMultipleRay
{
  real3 several;
  real3 once;
};

AIRLIGHT_FN real3 airlightSun(AIRLIGHT_MULTIPLE_IN int sun, int row)
{
  return real3(airlightMultiple.sun[sun * AIRLIGHT_SUN_ROWS + row]);
}

// Of unit extinction, below the side that the sun lights.
AIRLIGHT_FN real airlightLayerDepth(
  AIRLIGHT_IN(AirlightMedium) medium, real4 layers, real3 point)
{
  if (AIRLIGHT_DENSITY_KIND(medium) == AIRLIGHT_DENSITY_HEIGHT)
  {
    real height = max(airlightScaleHeights(medium, point), real(-60.0));
    return exp(-height) / medium.inverseScaleHeight;
  }
  return max(layers.w - dot(real3(layers), point), real(0.0));
}

// The integral over s in [0, l] of e^(-rate (start + slope s)) e^-s.
AIRLIGHT_FN real3 airlightLayerIntegral(real3 rate, real3 start, real slope, real3 l)
{
  real3 x = real3(real(1.0)) + rate * slope;
  real3 way = x * l;
  real3 begin = exp(-rate * start);
  real3 differs = begin - exp(-rate * start - way);
  // The difference of nearly equal numbers, by its series.
  real3 series = begin * l *
    (real3(real(1.0)) - way * (real(0.5) - way * (real(0.16666666666666667) - way / real(24.0))));
  real3 result;
  for (int channel = 0; channel < 3; channel++)
  {
    result[channel] =
      abs(way[channel]) < real(0.05) ? series[channel] : differs[channel] / x[channel];
  }
  return result;
}

// Along the part `range` of a ray, which is inside the medium.
AIRLIGHT_FN AirlightMultipleRay airlightMultipleOfSun(
  AIRLIGHT_MULTIPLE_IN AIRLIGHT_IN(AirlightMedium) medium, real3 origin, real3 direction,
  real2 range, int sun)
{
  AirlightMultipleRay result;
  real3 peak = airlightMultiple.layerScale;
  real4 layers = airlightMultiple.sun[sun * AIRLIGHT_SUN_ROWS + AIRLIGHT_SUN_LAYERS];
  real4 towards = airlightMultiple.sun[sun * AIRLIGHT_SUN_ROWS + AIRLIGHT_SUN_DIRECTION];
  const real far = real(1e4); // nothing is left beyond, and products stay finite
  real3 end = airlightSun(AIRLIGHT_MULTIPLE_OUT sun, AIRLIGHT_SUN_END) / peak;
  real3 start = min(medium.sigmaT *
    airlightLayerDepth(medium, layers, origin + range.x * direction), min(real3(far), end));
  real3 depth = min(medium.sigmaT *
    airlightInsideDepth(medium, origin, direction, range.x, range.y), real3(far));
  real slope = -dot(real3(layers), direction);
  // No light beyond the sides.
  depth = slope > real(1e-6) ? min(depth, (end - start) / slope) : depth;
  depth = slope < real(-1e-6) ? min(depth, start / -slope) : depth;
  real3 beam = real3(real(1.0) / towards.w);
  real3 first = airlightLayerIntegral(beam, start, slope, depth);
  real3 straight = airlightLayerIntegral(beam, peak * start, slope, peak * depth);
  real3 fall =
    airlightLayerIntegral(airlightMultiple.layerRate, peak * start, slope, peak * depth);
  real3 climb = airlightLayerIntegral(-airlightMultiple.layerRate,
    peak * start - airlightSun(AIRLIGHT_MULTIPLE_OUT sun, AIRLIGHT_SUN_END), slope, peak * depth);
  // Light that is scattered towards the eye travels against the ray.
  real3 turned = slope * airlightMultiple.layerCosine * airlightMultiple.layerFlux;
  real3 diffuse =
    (real3(real(1.0)) - turned) * fall *
      airlightSun(AIRLIGHT_MULTIPLE_OUT sun, AIRLIGHT_SUN_FALL) +
    (real3(real(1.0)) + turned) * climb *
      airlightSun(AIRLIGHT_MULTIPLE_OUT sun, AIRLIGHT_SUN_CLIMB) -
    (airlightSun(AIRLIGHT_MULTIPLE_OUT sun, AIRLIGHT_SUN_BEAM) -
      slope * airlightMultiple.layerCosine *
        airlightSun(AIRLIGHT_MULTIPLE_OUT sun, AIRLIGHT_SUN_BEAM_FLUX)) * straight;
  real3 albedo = medium.sigmaS / max(medium.sigmaT, real3(real(1e-30)));
  real cosTheta = dot(real3(towards), direction);
  real lobe = airlightMultiple.layerScale == real3(real(1.0)) ? real(0.0) : airlightMultiple.lobe;
  real wide = real(1.0) + lobe * lobe - real(2.0) * lobe * cosTheta;
  wide = real(0.079577471545947668) * (real(1.0) - lobe * lobe) / (wide * sqrt(wide));
  real3 forward = wide * albedo * (straight / peak - first);
  real3 irradiance = airlightSun(AIRLIGHT_MULTIPLE_OUT sun, AIRLIGHT_SUN_IRRADIANCE);
  result.several = irradiance * airlightSun(AIRLIGHT_MULTIPLE_OUT sun, AIRLIGHT_SUN_SHARE) *
    max(airlightMultiple.layerAlbedo * diffuse + forward, real3(real(0.0)));
  result.once = irradiance * albedo * airlightPhase(medium.phase, cosTheta) * first;
  return result;
}

// The irradiance that a sun's scattered light brings to a surface of this unit normal, as
// airlightMultipleIrradiance().
AIRLIGHT_FN real3 airlightSunIrradiance(
  AIRLIGHT_MULTIPLE_IN AIRLIGHT_IN(AirlightMedium) medium, real3 point, real3 normal, int sun)
{
  real4 layers = airlightMultiple.sun[sun * AIRLIGHT_SUN_ROWS + AIRLIGHT_SUN_LAYERS];
  real4 towards = airlightMultiple.sun[sun * AIRLIGHT_SUN_ROWS + AIRLIGHT_SUN_DIRECTION];
  real3 depth = min(medium.sigmaT * airlightLayerDepth(medium, layers, point),
    airlightSun(AIRLIGHT_MULTIPLE_OUT sun, AIRLIGHT_SUN_END) / airlightMultiple.layerScale);
  real3 thinner = airlightMultiple.layerScale * depth;
  real3 fall = airlightSun(AIRLIGHT_MULTIPLE_OUT sun, AIRLIGHT_SUN_FALL) *
    exp(-airlightMultiple.layerRate * thinner);
  real3 climb = airlightSun(AIRLIGHT_MULTIPLE_OUT sun, AIRLIGHT_SUN_CLIMB) *
    exp(-airlightMultiple.layerRate *
      (airlightSun(AIRLIGHT_MULTIPLE_OUT sun, AIRLIGHT_SUN_END) - thinner));
  real3 beam = exp(-thinner / towards.w);
  real up = dot(real3(layers), normal);
  real3 even =
    fall + climb - airlightSun(AIRLIGHT_MULTIPLE_OUT sun, AIRLIGHT_SUN_BEAM) * beam;
  real3 down = airlightMultiple.layerFlux * (fall - climb) -
    airlightSun(AIRLIGHT_MULTIPLE_OUT sun, AIRLIGHT_SUN_BEAM_FLUX) * beam;
  const real pi = real(3.14159265358979324);
  real3 forward = max(dot(real3(towards), normal), real(0.0)) * (beam - exp(-depth / towards.w));
  return airlightSun(AIRLIGHT_MULTIPLE_OUT sun, AIRLIGHT_SUN_IRRADIANCE) *
    airlightSun(AIRLIGHT_MULTIPLE_OUT sun, AIRLIGHT_SUN_SHARE) *
    max(pi * even + real(2.0) / real(3.0) * pi * up * down + forward, real3(real(0.0)));
}
