// A point light's airlight before every point of a ray at once. Seen from the light, a point that
// moves along the ray turns by the angle psi, in which the inverse square is a constant
// (AirlightPointLight.glsl):
//
//   integral p/r^2 exp(-sigmaT (t + r)) dt = 1/h integral p exp(-sigmaT (t + r)) dpsi
//
// In an isotropic medium the integral between two places takes eight nodes and no angle
// (AirlightHalfAngle.glsl). With other phase functions the ray is cut into few parts. On each
// (AirlightEquiangularPanel.glsl) the integrand is replaced by the polynomial that meets it at the
// eight nodes of Gauss and Legendre, whose integral is known everywhere: that of the whole part is
// the quadrature's, and every end of a shadow in between takes one arctangent and a polynomial of
// degree eight, where the closed form takes an exponential integral. The parts are chosen such that
// the polynomial's integral is off by 1e-6 of the part's, at most a few times that
// (Testing/Cxx/Module/TestEquiangularQuadrature.cxx).

// Optical depths after which nothing counts any more.
#ifdef AIRLIGHT_DOUBLE
#define AIRLIGHT_NEGLIGIBLE_DEPTH 24.0
#else
#define AIRLIGHT_NEGLIGIBLE_DEPTH 14.0
#endif
// More parts than any ray has that matters.
#define AIRLIGHT_MAXIMUM_PANELS 64

struct AirlightEquiangular
{
  real from; // where the ray begins, from its origin
  real x;    // and from the light's foot
  real h;
  real left; // the angle at the light between the ray's beginning and its direction
  real s;    // at the ray's beginning
  real end;  // psi where the ray ends, or the light is gone
  // sigmaT (t + r) in powers of two, negative: at the foot's s = 0, and per unit of s.
  AirlightSpectrum start;
  AirlightSpectrum slope;
  real later; // see airlightEquiangularPanelEnd()
};

// Sine and cosine in [0, pi/2], errors 4e-9 and 2e-10. Pair by pair, here and below: each step of a
// chain waits for the one before it.
AIRLIGHT_FN real2 airlightSineCosine(real a)
{
#ifdef AIRLIGHT_DOUBLE
  return real2(sin(a), cos(a));
#else
  real z = a * a;
  real z2 = z * z;
  return real2(a *
      ((real(0.9999999957) + z * real(-0.1666665799)) +
        z2 * ((real(0.008333051064) + z * real(-0.0001980907531)) + z2 * real(2.605224917e-06))),
    (real(0.9999999998) + z * real(-0.4999999936)) +
      z2 * ((real(0.04166663626) + z * real(-0.00138883614)) +
      z2 * (real(2.476016136e-05) + z * real(-2.605149508e-07))));
#endif
}

// The angle by which the light sees the ray turn from its beginning to t, from cross and dot
// product of the two directions: a difference of two angles would cancel.
AIRLIGHT_FN real airlightAngleAt(
  AIRLIGHT_IN(AirlightEquiangular) arc, AIRLIGHT_IN(AirlightRay) ray, real t)
{
  real x = max(airlightFromFoot(ray, t), arc.x);
  real way = max(airlightWayBetween(ray, arc.from, t), real(0.0));
  return airlightAngle(arc.h * way, arc.h * arc.h + arc.x * x);
}

// Twice the arctangent of y/x to a percent, x and y not below 0.
AIRLIGHT_FN real airlightTwiceAngle(real y, real x)
{
  real q = min(x, y) / max(max(x, y), real(1e-37));
  real a = real(2.0) * q / (real(1.0) + real(0.28) * q * q);
  return y > x ? real(3.1415926535897932) - a : a;
}

// The cotangent of half an angle in (0, pi], to 2 %.
AIRLIGHT_FN real airlightHalfCotangent(real angle)
{
  real z = real(0.25) * angle * angle;
  return max(real(2.0) - z * (real(0.66666667) + z * real(0.05832)), real(0.0)) / angle;
}

// s = tan(theta/2) (AirlightPointLight.glsl) at a place x from the light's foot: the cotangent of
// half the angle that is left there. t + r is tL + h s.
AIRLIGHT_FN real airlightHalfAngleTangent(real h, real x)
{
  real r = sqrt(h * h + x * x);
  return (x >= real(0.0) ? x + r : h) / (x >= real(0.0) ? h : r - x);
}

// The least optical depth per unit of s, of the channels that fade; 0 where none does.
AIRLIGHT_FN real airlightLeastDepthPerTangent(AIRLIGHT_IN(AirlightMedium) medium, real h)
{
  real least = airlightLeastExtinction(medium);
  return least < real(AIRLIGHT_FAR) ? least * h : real(0.0);
}

// A ray from t0 on, without its angles.
AIRLIGHT_FN AirlightEquiangular airlightEquiangularFrom(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightRay) ray, real t0)
{
  const real log2e = real(1.4426950408889634);
  AirlightEquiangular arc;
  arc.from = t0;
  arc.x = airlightFromFoot(ray, t0);
  arc.h = ray.foot.h;
  arc.left = real(0.0);
  arc.later = real(0.0);
  arc.end = real(0.0);
  arc.start = AIRLIGHT_SPECTRUM(medium.sigmaT) * (-log2e * ray.foot.tL);
  arc.slope = AIRLIGHT_SPECTRUM(medium.sigmaT) * (-log2e * arc.h);
  arc.s = airlightHalfAngleTangent(arc.h, arc.x);
  return arc;
}

// A ray's part [t0, t1] in which the light is not cut off.
AIRLIGHT_FN AirlightEquiangular airlightEquiangularRange(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
  AirlightEquiangular arc = airlightEquiangularFrom(medium, ray, t0);
  arc.left = airlightAngle(arc.h, arc.x);
  arc.later = real(0.66) / arc.left;
  real tau = airlightLeastDepthPerTangent(medium, arc.h);
  real gone = arc.left - airlightTwiceAngle(tau, arc.s * tau + real(AIRLIGHT_NEGLIGIBLE_DEPTH));
  arc.end = min(airlightAngleAt(arc, ray, t1), gone);
  return arc;
}

// How far the ray may turn from an angle `left` to its direction, for a phase function's peaks:
// poles lie about 2 b off the real angles before the forward direction, and 2/b before the backward
// one. A power n of half the cosine is close to a normal distribution of the deviation sqrt(2/n),
// of which eight nodes follow three.
AIRLIGHT_FN real airlightSmoothAngle(AIRLIGHT_IN(AirlightPhase) phase, real left)
{
  real length = real(4.0);
#ifndef AIRLIGHT_ISOTROPIC
  real forward = real(3.1415926535897932) - left;
  for (int k = 0; k < AIRLIGHT_POLE_COUNT; k++)
  {
    real b = phase.pole[k].x;
    bool back = b > real(1.0);
    real off = real(2.0) * (back ? real(1.0) / b : b);
    real along = back ? left : forward;
    length = min(length, (back ? real(0.35) : real(0.83)) * sqrt(along * along + off * off));
  }
  if (AIRLIGHT_HAS_POWER != 0 && phase.power.x > real(0.0))
  {
    length = min(length, real(4.2) / sqrt(phase.power.y));
  }
#endif
  return length;
}

// Extinction times the light's distance from the ray, of the channel that fades most among those
// that have not faded yet after a way of `s` from the ray's beginning.
AIRLIGHT_FN real airlightMostFading(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightEquiangular) arc, real s)
{
#if defined(AIRLIGHT_GREY) && AIRLIGHT_GREY
  return arc.h * medium.sigmaT.x;
#else
  real3 tau = arc.h * medium.sigmaT;
  tau = mix(real3(real(0.0)), tau, lessThan(tau * s, real3(real(AIRLIGHT_NEGLIGIBLE_DEPTH))));
  return max(tau.x, max(tau.y, tau.z));
#endif
}

// How far the part may reach that begins at psi. What limits it is where the integrand is not
// smooth: the asymptote, which it nears as exp(-2 tau/angle), and a phase function's peaks. Of
// later parts the tolerance is larger where little of the angle is left, or of the light.
AIRLIGHT_FN real airlightEquiangularPanelLength(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightEquiangular) arc, real psi)
{
  real left = max(arc.left - psi, real(1e-6));
  real cotangent = airlightHalfCotangent(left);
  real s = max(cotangent - arc.s, real(0.0));
  real tau = airlightMostFading(medium, arc, s);
  // Fitted to where eight nodes give 1e-6.
  real root = sqrt(tau);
  real ratio = clamp(arc.later * left, real(0.081), real(0.3)) * root /
    (root + real(0.045) * sqrt(left));
  // In optical depths.
  real most = real(4.0) + min(tau * s, real(8.0));
  real faded = airlightTwiceAngle(tau, cotangent * tau + most);
  real length = min(left - max(ratio * left, faded), airlightSmoothAngle(medium.phase, left));
  return max(length, real(1e-3) * left);
}

// Where it may end.
AIRLIGHT_FN real airlightEquiangularPanelEnd(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightEquiangular) arc, real psi)
{
  return min(psi + airlightEquiangularPanelLength(medium, arc, psi), arc.end);
}

// The integral from `done` in s beyond the beginning of a ray on whose rest the light fades: to
// infinity, which differs by less than what is left where the light is gone. The closed form of
// AirlightPointLight.glsl times h: one evaluation instead of the many parts in which a ray nears
// its asymptote. Of other phase functions the poles take one each, and their weights may cancel.
AIRLIGHT_FN AirlightSpectrum airlightEquiangularRest(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightEquiangular) arc, real done)
{
  real s = arc.s + done;
  AirlightSpectrum u = arc.h * AIRLIGHT_SPECTRUM(medium.sigmaT);
  AirlightSpectrum passes = real(2.0) * u * exp2(arc.start + arc.slope * s);
#if defined(AIRLIGHT_GREY) && AIRLIGHT_GREY
  return passes * airlightPhaseG(medium.phase, u * s, u);
#else
  return passes *
    real3(airlightPhaseG(medium.phase, u.x * s, u.x), airlightPhaseG(medium.phase, u.y * s, u.y),
      airlightPhaseG(medium.phase, u.z * s, u.z));
#endif
}
