// Single scattering of a point light of inverse-square fall-off along a ray, in closed form.
//
// The ray starts where it enters the medium; t is the distance from there. The light's foot on the
// ray is at tL, its distance from the ray is h, and r(t) = sqrt(h^2 + (t - tL)^2). With
// s(t) = ((t - tL) + r)/h = tan(theta/2) the integral of p/r^2 exp(-sigmaT (t + r)) becomes
// (2/h) e^(-sigmaT tL) times the integral of e^(-u s) w(s) ds, u = sigmaT h, and each pole of w
// gives one value of g (AirlightPhase.glsl). Per unit sigmaS I:
//
//   tail(t) = integral_t^inf = 2 sigmaT exp(-sigmaT (t + r)) phaseG(u s, u)

// Wider angles take more nodes in the quadrature of short intervals.
#ifdef AIRLIGHT_DOUBLE
#define AIRLIGHT_WIDE_ANGLE 0.1
#else
#define AIRLIGHT_WIDE_ANGLE 0.5
#endif

// Below this fraction of the tail an interval counts as short: there the difference of two tails
// loses too many digits, and the quadrature of few nodes that replaces it is exact enough. The
// digits lost depend on how much the phase function's poles cancel, the least on the exponential.
AIRLIGHT_FN real airlightShortFraction(AIRLIGHT_IN(AirlightPhase) phase)
{
#ifdef AIRLIGHT_DOUBLE
  return clamp(real(1e-4) * airlightPhaseCancellation(phase), real(1e-3), real(1e-2));
#else
  return clamp(real(0.02) * airlightPhaseCancellation(phase), real(0.1), real(0.5));
#endif
}

struct AirlightFoot
{
  real tL; // distance along the ray to the light's foot
  real h;  // distance of the light from the ray, above 0
};

// x = t - tL.
AIRLIGHT_FN real airlightTail(
  AIRLIGHT_IN(AirlightPhase) phase, real sigmaT, AIRLIGHT_IN(AirlightFoot) foot, real t, real x)
{
  real r = sqrt(foot.h * foot.h + x * x);
  // h s(t); before the foot the sum cancels, its conjugate does not.
  real hs = x >= real(0.0) ? x + r : foot.h * foot.h / (r - x);
  return real(2.0) * sigmaT * exp(-sigmaT * (t + r)) *
    airlightPhaseG(phase, sigmaT * hs, sigmaT * foot.h);
}

// One sample of the quadrature below, for each channel: the light turned by `angle` from the sample
// at x0 = t0 - tL.
AIRLIGHT_FN real3 airlightAngleSample(AIRLIGHT_IN(AirlightPhase) phase, real3 sigmaT,
  AIRLIGHT_IN(AirlightFoot) foot, real x0, real r0, real angle)
{
  real c = cos(angle);
  real s = sin(angle);
  real cosPhi = max((foot.h * c - x0 * s) / r0, real(1e-30));
  real sinPhi = (x0 * c + foot.h * s) / r0;
  real r = foot.h / cosPhi;
  return airlightPhase(phase, -sinPhi) * exp(-sigmaT * (foot.tL + r * sinPhi + r));
}

// The integral from x0 on by Gauss-Legendre quadrature in the angle seen from the light, where the
// inverse square is a constant. For short intervals, in which the difference of two tails would
// cancel.
AIRLIGHT_FN real3 airlightShortSegment(AIRLIGHT_IN(AirlightPhase) phase, real3 sigmaT,
  AIRLIGHT_IN(AirlightFoot) foot, real x0, real way, bool needed)
{
  real x1 = x0 + way;
  real r0 = sqrt(foot.h * foot.h + x0 * x0);
  // From cross and dot product of the two directions: a difference of two angles would cancel.
  real turn = airlightAngle(foot.h * way, foot.h * foot.h + x0 * x1);
  // A wide angle with little in it: the phase function's peak lies beyond it (strong backward
  // scattering), and its flank takes more nodes.
  int panels = turn > real(AIRLIGHT_WIDE_ANGLE) ? 4 : 1;
  real reach = real(0.5) * turn / real(panels);
  real3 sum = real3(real(0.0));
  // One loop, whose length compilers do not know: software renderers run both sides of every branch
  // and what is unrolled, but leave a loop as soon as no pixel of a group is in it.
  int nodes = needed ? panels * AIRLIGHT_GAUSS_COUNT : 0;
  for (int k = 0; k < nodes; k++)
  {
    real2 node = airlightGaussNode((k % AIRLIGHT_GAUSS_COUNT) / 2);
    real middle = real(2 * (k / AIRLIGHT_GAUSS_COUNT) + 1) * reach;
    real angle = middle + (k % 2 == 0 ? reach : -reach) * node.x;
    sum += node.y * airlightAngleSample(phase, sigmaT, foot, x0, r0, angle);
  }
  return sum * (reach / foot.h);
}

// The integral from x0 = t0 - tL along a way of this length per unit sigmaS I, given the tails at
// its ends, for each channel.
AIRLIGHT_FN real3 airlightSegmentFromTails(AIRLIGHT_IN(AirlightPhase) phase, real3 sigmaT,
  AIRLIGHT_IN(AirlightFoot) foot, real x0, real way, real3 tail0, real3 tail1)
{
  real3 result = tail0 - tail1;
  real3 least = airlightShortFraction(phase) * tail0;
  // Written so that differences that are not numbers count as short, too.
  bool3 enough = greaterThan(result, least);
  return mix(
    airlightShortSegment(phase, sigmaT, foot, x0, way, !all(enough)), result, enough);
}

// The integral over [t0, t1] per unit sigmaS I, for one channel. t0 >= 0.
AIRLIGHT_FN real airlightSegment(AIRLIGHT_IN(AirlightPhase) phase, real sigmaT,
  AIRLIGHT_IN(AirlightFoot) foot, real t0, real t1)
{
  return airlightSegmentFromTails(phase, real3(sigmaT), foot, t0 - foot.tL, t1 - t0,
    real3(airlightTail(phase, sigmaT, foot, t0, t0 - foot.tL)),
    real3(airlightTail(phase, sigmaT, foot, t1, t1 - foot.tL))).x;
}
