// Phase functions as sums of poles. In s = tan(theta/2) a phase function p, normalised over the
// sphere, is seen by the scattering integral as w(s) = p/(1 + s^2) and is written
//
//   w(s) = sum_k c_k/(s^2 + b_k^2)    that is    p = sum_k 2 c_k/((1 - cos) + b_k^2 (1 + cos))
//
// The isotropic function is the single pole b = 1, c = 1/(4 pi).

struct AirlightPhase
{
  real2 pole[AIRLIGHT_MAX_POLES]; // (b, c)
  int poleCount;
};

// Where the number of poles is known when a shader is compiled, its loops unroll.
#ifndef AIRLIGHT_POLE_COUNT
#define AIRLIGHT_POLE_COUNT phase.poleCount
#endif

// p(cosTheta) in 1/sr; cosTheta = 1 is forward.
AIRLIGHT_FN real airlightPhase(AIRLIGHT_IN(AirlightPhase) phase, real cosTheta)
{
  real p = real(0.0);
  for (int k = 0; k < AIRLIGHT_POLE_COUNT; k++)
  {
    real b = phase.pole[k].x;
    p += real(2.0) * phase.pole[k].y /
      ((real(1.0) - cosTheta) + b * b * (real(1.0) + cosTheta));
  }
  return p;
}

// How much larger the poles' terms are than their sum, far from and near the direction of s = 0:
// what rounding is amplified by. 1 for a single pole.
AIRLIGHT_FN real airlightPhaseCancellation(AIRLIGHT_IN(AirlightPhase) phase)
{
  real4 sum = real4(real(0.0));
  for (int k = 0; k < AIRLIGHT_POLE_COUNT; k++)
  {
    real c = phase.pole[k].y;
    real c0 = c / (phase.pole[k].x * phase.pole[k].x);
    sum += real4(c, abs(c), c0, abs(c0));
  }
  return max(sum.y / sum.x, sum.w / sum.z);
}

// sum_k c_k g(x, b_k y): the phase function's share of the scattering integral, see
// AirlightPointLight.glsl.
AIRLIGHT_FN real airlightPhaseG(AIRLIGHT_IN(AirlightPhase) phase, real x, real y)
{
  real sum = real(0.0);
  for (int k = 0; k < AIRLIGHT_POLE_COUNT; k++)
  {
    sum += phase.pole[k].y * airlightG(x, phase.pole[k].x * y);
  }
  return sum;
}
