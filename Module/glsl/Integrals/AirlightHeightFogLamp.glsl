// A point light of inverse-square fall-off in one medium whose density falls exponentially with
// height. There is no closed form, but the optical depths of both ways are known, and in v with
// t - foot = h sinh v the integrand is smooth everywhere:
//
//   integral d p/r^2 exp(-sigmaT (D + C)) dt = 1/h integral d p/cosh v exp(-sigmaT (D + C)) dv
//
// with the density d and the columns D before the ray's point and C from there to the light. The
// phase function's poles lie pi/2 off the real axis or farther, so that four nodes of Gauss and
// Legendre follow a part of 1.5; the fading limits the parts, too. The sum is off by 2e-6 in the
// median, 1e-4 at 99 % (Testing/Cxx/Module/TestHeightFogLamp.cxx).

// Optical depth after which nothing counts, wherever the light is.
#define AIRLIGHT_BURIED_DEPTH 40.0
// Nor does what is so many scale heights above the lowest place of a ray before that depth.
#define AIRLIGHT_CLEAR_HEIGHTS 20.0
// More parts than any ray has that matters.
#define AIRLIGHT_MAXIMUM_FOG_PARTS 128

// A light and a ray, which begins in the medium. Heights in scale heights above that of density 1.
struct AirlightHeightFogLamp
{
  real h;     // distance of the light from the ray
  real start; // of the ray's beginning, from the light's foot
  real rise;  // scale heights in one unit
  real footHeight;
  real lampHeight;
  real lampDensity;
  real startHeight;
  real startDensity;
  real begin; // v
  real end;
  AirlightSpectrum least; // of airlightHeightFogLoss() so far
};

// The mean density on a way between places of these densities of which the second is `rise` scale
// heights above the first.
AIRLIGHT_FN real airlightMeanDensity(real first, real second, real rise)
{
  real z = rise * rise;
  bool level = z < real(0.0625);
  return level ? real(0.5) * (first + second) *
      (real(1.0) - z * (real(0.083333333333333333) -
        z * (real(0.0083333333333333333) - z * real(0.00084325396825396825))))
               : (first - second) / (level ? real(1.0) : rise);
}

// The height where e = (exp(v), exp(-v)).
AIRLIGHT_FN real airlightHeightFogAt(AIRLIGHT_IN(AirlightHeightFogLamp) lamp, real2 e)
{
  return lamp.footHeight + lamp.rise * (real(0.5) * lamp.h * (e.x - e.y));
}

// Both columns together.
AIRLIGHT_FN real airlightHeightFogColumns(
  AIRLIGHT_IN(AirlightHeightFogLamp) lamp, real2 e, real height, real density)
{
  real x = real(0.5) * lamp.h * (e.x - e.y);
  real r = real(0.5) * lamp.h * (e.x + e.y);
  real before = max(x - lamp.start, real(0.0)) *
    airlightMeanDensity(lamp.startDensity, density, height - lamp.startHeight);
  real after = r * airlightMeanDensity(density, lamp.lampDensity, lamp.lampHeight - height);
  return min(before + after, real(1e30));
}

AIRLIGHT_FN real2 airlightExponentials(real v)
{
  real e = exp(v);
  return real2(e, real(1.0) / e);
}

// Where (exp(v) - exp(-v))/2 is x.
AIRLIGHT_FN real2 airlightExponentialsAt(real x)
{
  real most = abs(x) + sqrt(x * x + real(1.0));
  return x < real(0.0) ? real2(real(1.0) / most, most) : real2(most, real(1.0) / most);
}

AIRLIGHT_FN real airlightHeightFogV(AIRLIGHT_IN(AirlightHeightFogLamp) lamp, real x)
{
  const real far = real(1e18); // squares are finite in single precision
  return airlightAsinh(clamp(x / lamp.h, -far, far));
}

// The logarithm of a phase function's power, down to where it is small beside the rest.
AIRLIGHT_FN real airlightPowerLogarithm(AIRLIGHT_IN(AirlightPhase) phase, real2 e)
{
  if (AIRLIGHT_HAS_POWER != 0 && phase.power.x > real(0.0))
  {
    return max(phase.power.y * log(max(e.y / (e.x + e.y), real(1e-6))), real(-12.0));
  }
  return real(0.0);
}

// Minus the logarithm of density times transmittance.
AIRLIGHT_FN AirlightSpectrum airlightHeightFogFade(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightHeightFogLamp) lamp, real2 e)
{
  real height = airlightHeightFogAt(lamp, e);
  real columns = airlightHeightFogColumns(lamp, e, height, airlightExponentialDensity(height));
  return AIRLIGHT_SPECTRUM(medium.sigmaT) * columns + height;
}

// The same with 1/cosh v.
AIRLIGHT_FN AirlightSpectrum airlightHeightFogLoss(AirlightSpectrum fade, real2 e)
{
  return fade + log(e.x + e.y);
}

// The ray's part [t0, t1].
AIRLIGHT_FN AirlightHeightFogLamp airlightHeightFogLamp(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
  AirlightHeightFogLamp lamp;
  lamp.h = ray.foot.h;
  lamp.start = -ray.foot.tL;
  lamp.rise = airlightRise(medium, ray.direction);
  lamp.startHeight = airlightScaleHeights(medium, ray.origin);
  lamp.startDensity = airlightExponentialDensity(lamp.startHeight);
  lamp.lampHeight = airlightScaleHeights(medium, light.position);
  lamp.lampDensity = airlightExponentialDensity(lamp.lampHeight);
  lamp.footHeight = lamp.lampHeight + dot(medium.up, ray.across) * medium.inverseScaleHeight;
  t1 = min(t1, airlightFadingLength(medium, ray.origin, ray.direction,
    airlightLeastExtinction(medium), real(AIRLIGHT_BURIED_DEPTH)));
  real lowest = lamp.startHeight + lamp.rise * (lamp.rise > real(0.0) ? t0 : t1);
  real clear = (lowest + real(AIRLIGHT_CLEAR_HEIGHTS) - lamp.startHeight) / lamp.rise;
  // On level rays that is infinite, or not a number.
  t0 = lamp.rise < real(0.0) && clear > t0 ? min(clear, t1) : t0;
  t1 = lamp.rise > real(0.0) && clear < t1 ? clear : t1;
  lamp.begin = airlightHeightFogV(lamp, airlightFromFoot(ray, t0));
  lamp.end = airlightHeightFogV(lamp, airlightFromFoot(ray, max(t0, t1)));
  real2 begin = airlightExponentials(lamp.begin);
  real2 foot = airlightExponentials(clamp(real(0.0), lamp.begin, lamp.end));
  lamp.least = min(airlightHeightFogLoss(airlightHeightFogFade(medium, lamp, begin), begin),
    airlightHeightFogLoss(airlightHeightFogFade(medium, lamp, foot), foot));
  return lamp;
}

AIRLIGHT_FN real airlightLeastOf(AirlightSpectrum v)
{
#if defined(AIRLIGHT_GREY) && AIRLIGHT_GREY
  return v;
#else
  return min(v.x, min(v.y, v.z));
#endif
}

// Where the part may end that begins at v, at lamp.end where nothing counts from there on. By how
// much logarithms change is limited, less so where the integrand is small already.
AIRLIGHT_FN real airlightHeightFogPartEnd(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_INOUT(AirlightHeightFogLamp) lamp, real v)
{
  const real longest = real(1.5);
  const real most = real(1.7);
  const real dark = real(AIRLIGHT_NEGLIGIBLE_DEPTH);
  real end = min(v + longest, lamp.end);
  real2 e0 = airlightExponentials(v);
  real2 e1 = airlightExponentials(end);
  // In two steps: columns may grow exponentially with height.
  real x0 = real(0.5) * (e0.x - e0.y);
  real x1 = min(real(0.5) * (e1.x - e1.y), x0 + most / max(lamp.h * abs(lamp.rise), real(1e-30)));
  e1 = airlightExponentialsAt(x1);
  AirlightSpectrum fade0 = airlightHeightFogFade(medium, lamp, e0);
  AirlightSpectrum fade1 = airlightHeightFogFade(medium, lamp, e1);
  AirlightSpectrum loss0 = airlightHeightFogLoss(fade0, e0);
  AirlightSpectrum loss1 = airlightHeightFogLoss(fade1, e1);
  lamp.least = min(lamp.least, min(loss0, loss1));
  AirlightSpectrum more = min(loss0, loss1) - lamp.least;
  AirlightSpectrum middle =
    airlightHeightFogFade(medium, lamp, airlightExponentialsAt(real(0.5) * (x0 + x1)));
  AirlightSpectrum change = abs(fade1 - middle) + abs(middle - fade0) +
    abs(airlightPowerLogarithm(medium.phase, e1) - airlightPowerLogarithm(medium.phase, e0));
  AirlightSpectrum allowed =
    max(AirlightSpectrum(most) + real(0.5) * min(more, AirlightSpectrum(dark)),
      real(0.25) * (loss0 - lamp.least));
  AirlightSpectrum isDark = step(AirlightSpectrum(dark), more);
  real share = airlightLeastOf(max(allowed / max(change, allowed), isDark));
  real next = airlightAsinh(x0 + (x1 - x0) * share);
  // A part is at least 1 % of the longest, and what it leaves of that, too; both more than what
  // rounding makes of v.
  real least = max(real(0.01) * (end - v), real(1e-5) * max(abs(end), real(1.0)));
  next = next < end - least ? max(next, v + least) : end;
  // Where all is dark it may become lighter again, towards the lamp at the latest.
  bool gone = airlightLeastOf(isDark) > real(0.5) && airlightLeastOf(loss1 - loss0) > real(0.0);
  return gone ? (v < real(0.0) ? min(next, real(0.0)) : lamp.end) : next;
}

AIRLIGHT_FN AirlightSpectrum airlightHeightFogSample(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightHeightFogLamp) lamp, real2 e)
{
  real height = airlightHeightFogAt(lamp, e);
  real density = airlightExponentialDensity(height);
  real inverse = real(1.0) / (e.x + e.y);
  real columns = airlightHeightFogColumns(lamp, e, height, density);
  return (airlightPhaseHalves(medium.phase, e.y * inverse, e.x * inverse) *
           (real(2.0) * density * inverse)) *
    exp(AIRLIGHT_SPECTRUM(medium.sigmaT) * -columns);
}

// The integral over a part.
AIRLIGHT_FN AirlightSpectrum airlightHeightFogPart(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightHeightFogLamp) lamp, real v0, real v1)
{
  real reach = real(0.5) * (v1 - v0);
  real2 middle = airlightExponentials(v0 + reach);
  real2 inner = airlightExponentials(reach * real(0.33998104358485626));
  real2 outer = airlightExponentials(reach * real(0.86113631159405258));
  return reach *
    (real(0.65214515486254614) *
        (airlightHeightFogSample(medium, lamp, middle * inner) +
          airlightHeightFogSample(medium, lamp, middle * real2(inner.y, inner.x))) +
      real(0.34785484513745386) *
        (airlightHeightFogSample(medium, lamp, middle * outer) +
          airlightHeightFogSample(medium, lamp, middle * real2(outer.y, outer.x))));
}

// The integral times h on [t0, t1], per unit sigmaS I.
AIRLIGHT_FN AirlightSpectrum airlightHeightFogRay(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
  AirlightHeightFogLamp lamp = airlightHeightFogLamp(medium, light, ray, t0, t1);
  AirlightSpectrum sum = AirlightSpectrum(real(0.0));
  real v = lamp.begin;
  for (int i = 0; i < AIRLIGHT_MAXIMUM_FOG_PARTS && v < lamp.end; i++)
  {
    real next = airlightHeightFogPartEnd(medium, lamp, v);
    sum += airlightHeightFogPart(medium, lamp, v, next);
    v = next;
  }
  return sum;
}
