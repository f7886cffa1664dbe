// Phase functions as sums of poles. In s = tan(theta/2) a phase function p, normalised over the
// sphere, is seen by the scattering integral as w(s) = p/(1 + s^2) and is written
//
//   w(s) = sum_k c1_k/q + c2_k/q^2 + c3_k/q^3,   q = s^2 + b_k^2
//
// The isotropic function is the single pole b = 1, c1 = 1/(4 pi); a polynomial in the cosine has
// its poles at b = 1, because 1/(1 + s^2) = (1 + cos)/2. High powers of it, which poles could only
// give as small differences of large terms, stand apart and are integrated by quadrature.

struct AirlightPhase
{
  real4 pole[AIRLIGHT_MAX_POLES]; // (b, c1, c2, c3)
  int poleCount;
  int order;                      // of the poles: 1, 2 or 3
  real2 power;                    // (c, n): c ((1 + cos)/2)^n; c is 0 where the poles are all
  // A table in place of all that: texels (angle, logarithm of the value, its slope, 0).
  AIRLIGHT_DATA_MEMBER
  int first;
  int rows; // 0: no table
};

// Where the number of poles is known when a shader is compiled, its loops unroll.
#ifndef AIRLIGHT_POLE_COUNT
#define AIRLIGHT_POLE_COUNT phase.poleCount
#endif
#ifndef AIRLIGHT_POLE_ORDER
#define AIRLIGHT_POLE_ORDER phase.order
#endif

// Where all are isotropic, AIRLIGHT_ISOTROPIC is defined.

#ifndef AIRLIGHT_HAS_POWER
#define AIRLIGHT_HAS_POWER 1
#endif

// A tabulated function: between the rows the logarithm is a cubic with the given slopes.
AIRLIGHT_FN real airlightPhaseTable(AIRLIGHT_IN(AirlightPhase) phase, real cosTheta)
{
#if AIRLIGHT_HAS_TABLE
  real sinTheta = sqrt(max((real(1.0) - cosTheta) * (real(1.0) + cosTheta), real(0.0)));
  real angle = airlightAngle(sinTheta, cosTheta);
  int low = 0;
  int high = phase.rows;
  while (high - low > 1)
  {
    int middle = (low + high) / 2;
    bool after = AIRLIGHT_FETCH(phase, phase.first + middle).x <= angle;
    low = after ? middle : low;
    high = after ? high : middle;
  }
  real4 row = AIRLIGHT_FETCH(phase, phase.first + low);
  real4 next = AIRLIGHT_FETCH(phase, phase.first + min(low + 1, phase.rows - 1));
  real h = next.x - row.x;
  real x = h > real(0.0) ? clamp((angle - row.x) / h, real(0.0), real(1.0)) : real(0.0);
  real y = real(1.0) - x;
  return exp(y * y * (real(1.0) + x + x) * row.y + x * x * (real(1.0) + y + y) * next.y +
    h * x * y * (y * row.z - x * next.z));
#else
  return real(0.0);
#endif
}

// The poles and the power at (1 + cosTheta)/2 and (1 - cosTheta)/2; apart, the latter is exact near
// the forward direction.
AIRLIGHT_FN real airlightPhaseHalves(
  AIRLIGHT_IN(AirlightPhase) phase, real forward, real backward)
{
#ifdef AIRLIGHT_ISOTROPIC
  return phase.pole[0].y;
#endif
  real p = real(0.0);
  for (int k = 0; k < AIRLIGHT_POLE_COUNT; k++)
  {
    real4 pole = phase.pole[k];
    // 1/(q (1 + cos)/2), finite in all directions.
    real r = real(1.0) / (backward + pole.x * pole.x * forward);
    p += r * (pole.y + forward * r * (pole.z + forward * r * pole.w));
  }
  if (AIRLIGHT_HAS_POWER != 0 && phase.power.x > real(0.0))
  {
    p += phase.power.x * pow(max(forward, real(1e-6)), phase.power.y);
  }
  return p;
}

// p(cosTheta) in 1/sr; cosTheta = 1 is forward.
AIRLIGHT_FN real airlightPhase(AIRLIGHT_IN(AirlightPhase) phase, real cosTheta)
{
  if (AIRLIGHT_HAS_TABLE != 0 && phase.rows > 0)
  {
    return airlightPhaseTable(phase, cosTheta);
  }
  return airlightPhaseHalves(
    phase, real(0.5) * (real(1.0) + cosTheta), real(0.5) * (real(1.0) - cosTheta));
}

// How much larger the poles' terms are than their sum, far from and near the direction of s = 0:
// what rounding is amplified by. 1 for a single pole.
AIRLIGHT_FN real airlightPhaseCancellation(AIRLIGHT_IN(AirlightPhase) phase)
{
  real4 sum = real4(real(0.0));
  for (int k = 0; k < AIRLIGHT_POLE_COUNT; k++)
  {
    real4 pole = phase.pole[k];
    real r = real(1.0) / (pole.x * pole.x);
    real3 c = real3(pole.y, pole.z * r, pole.w * r * r);
    real3 size = abs(c);
    sum += real4(c.x, size.x, r * (c.x + c.y + c.z), r * (size.x + size.y + size.z));
  }
  return max(sum.y / sum.x, sum.w / sum.z);
}

// What one pole adds to airlightPhaseG(): e^(u s0)/u times the integral of e^(-us) times its part
// of w over s from s0 = x/u. The simple pole gives g(x, y), y = b u. Integration by parts leads
// from one order to the next, with G = e^z E1(z), z = x - i y:
//
//   a2 = (g + Re G - x/|z|^2)/(2 b^2)
//   a3 = (3 a2 + u^2 (1/|z|^2 - g)/2 - u^2 x/|z|^4)/(4 b^2)
AIRLIGHT_FN real airlightPoleG(real4 pole, real x, real u)
{
  real y = pole.x * u;
  real q = x * x + y * y;
  if (q < real(1e-30))
  {
    y = max(y, real(1e-15));
    u = y / pole.x;
    q = x * x + y * y;
  }
#ifndef AIRLIGHT_DOUBLE
  if (q >= real(AIRLIGHT_G_NEAR * AIRLIGHT_G_NEAR))
  {
    return airlightPoleFar(x, y, real3(pole.y, pole.z, pole.w), u * u);
  }
#endif
  real2 g = airlightGPair(x, y);
  real inverse = real(1.0) / q;
  real b2 = pole.x * pole.x;
  real u2 = u * u;
  real a2 = (g.x + g.y - x * inverse) / (real(2.0) * b2);
  real a3 = (real(3.0) * a2 + u2 * (real(0.5) * (inverse - g.x) - x * inverse * inverse)) /
    (real(4.0) * b2);
  return pole.y * g.x + pole.z * a2 + pole.w * a3;
}

// e^(u s0)/u times the integral of e^(-us) w over s from s0 = x/u: the phase function's share of
// the scattering integral, see AirlightPointLight.glsl.
AIRLIGHT_FN real airlightPhaseG(AIRLIGHT_IN(AirlightPhase) phase, real x, real u)
{
#ifdef AIRLIGHT_ISOTROPIC
  return phase.pole[0].y * airlightG(x, u);
#endif
  real sum = real(0.0);
  for (int k = 0; k < AIRLIGHT_POLE_COUNT; k++)
  {
    real4 pole = phase.pole[k];
    sum += AIRLIGHT_POLE_ORDER > 1 ? airlightPoleG(pole, x, u)
                                   : pole.y * airlightG(x, pole.x * u);
  }
  return sum;
}
