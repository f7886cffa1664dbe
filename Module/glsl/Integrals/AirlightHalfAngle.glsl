// What is scattered along a ray on which no shadow ends, or between two places of it
// (AirlightEquiangular.glsl).

// By the parts in which boundaries are found (AirlightEquiangularPanel.glsl), for every phase
// function.
AIRLIGHT_FN AirlightSpectrum airlightEquiangularQuadrature(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
  AirlightEquiangular arc = airlightEquiangularRange(medium, ray, t0, t1);
  AirlightSpectrum sum = AirlightSpectrum(real(0.0));
  real psi = real(0.0);
  for (int i = 0; i < AIRLIGHT_MAXIMUM_PANELS && psi < arc.end; i++)
  {
    real next = airlightEquiangularPanelEnd(medium, arc, psi);
    sum += airlightEquiangularPanelSum(medium, arc, psi, next);
    psi = next;
  }
  return sum;
}

// In an isotropic medium the same integral in s = tan(theta/2) is that of exp(-u s)/(1 + s^2), with
// u = sigmaT h: it takes no angles, and half as many exponentials.

// How far s grows up to t1; as a difference of its ends it would cancel on a short way. What lies
// beyond 1e7 (1 + s) is less than 1e-7 of the ray's airlight.
AIRLIGHT_FN real airlightHalfAngleReach(
  AIRLIGHT_IN(AirlightEquiangular) arc, AIRLIGHT_IN(AirlightRay) ray, real t1)
{
  real x = airlightFromFoot(ray, t1);
  real h2 = arc.h * arc.h;
  real r = sqrt(h2 + arc.x * arc.x) + sqrt(h2 + x * x);
  real both = arc.s + airlightHalfAngleTangent(arc.h, x);
  real reach = max(airlightWayBetween(ray, arc.from, t1), real(0.0)) * (both / r);
  return min(reach, real(1e7) * (real(1.0) + arc.s));
}

// How far a part may reach on which eight nodes give 1e-6: at s the poles, i and -i, allow 2.65 +
// 2.05 s, and the exponential an optical depth of 14. Both together: fitted to what quadrature
// found.
AIRLIGHT_FN real airlightHalfAngleStep(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightEquiangular) arc, real done)
{
  real step = real(2.65) + real(2.05) * (arc.s + done);
  return step / (real(1.0) + step * (airlightMostFading(medium, arc, done) / real(14.0)));
}

// The sum of exp(-u y)/(1 + s^2) at two nodes y = off and -off from a part's middle m, times 1 +
// m^2. There 1 + s^2 is (1 + m^2) (even + odd) and (1 + m^2) (even - odd).
AIRLIGHT_FN AirlightSpectrum airlightHalfAngleNode(
  AirlightSpectrum slope, real off, real linear, real square)
{
  real odd = off * linear;
  real even = real(1.0) + off * off * square;
  real after = even + odd;
  real before = even - odd;
  AirlightSpectrum fades = exp2(slope * off);
  return (fades * (before * fades) + after) / (fades * (after * before));
}

// The integral over a part from `done` to `next` beyond the ray's beginning, without the phase
// function.
AIRLIGHT_FN AirlightSpectrum airlightHalfAnglePanel(
  AIRLIGHT_IN(AirlightEquiangular) arc, real done, real next)
{
  real reach = real(0.5) * (next - done);
  real middle = arc.s + real(0.5) * (done + next);
  real scale = real(1.0) / (real(1.0) + middle * middle);
  // Not less, where a channel had gone before: its power of two could be none.
  AirlightSpectrum slope = max(arc.slope * reach, AirlightSpectrum(real(-50.0)));
  real linear = real(2.0) * reach * (middle * scale);
  real square = reach * (reach * scale);
  AirlightSpectrum sum = (real(0.36268378337836198) *
                          airlightHalfAngleNode(slope, real(0.18343464249564978), linear, square) +
                        real(0.31370664587788729) *
                          airlightHalfAngleNode(slope, real(0.52553240991632899), linear, square)) +
    (real(0.22238103445337447) *
        airlightHalfAngleNode(slope, real(0.79666647741362673), linear, square) +
      real(0.10122853629037626) *
        airlightHalfAngleNode(slope, real(0.96028985649753618), linear, square));
  return (real(2.0) * reach * scale) * exp2(arc.start + arc.slope * middle) * sum;
}

// The whole ray in s.
AIRLIGHT_FN AirlightSpectrum airlightHalfAngleQuadrature(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
  AirlightEquiangular arc = airlightEquiangularFrom(medium, ray, t0);
  real reach = airlightHalfAngleReach(arc, ray, t1);
  bool open = airlightLeastDepthPerTangent(medium, arc.h) * reach > real(AIRLIGHT_NEGLIGIBLE_DEPTH);
  AirlightSpectrum rest = AirlightSpectrum(real(0.0));
  if (open)
  {
    rest = airlightEquiangularRest(medium, arc, real(0.0));
  }
  AirlightSpectrum parts = AirlightSpectrum(real(0.0));
  real done = open ? reach : real(0.0);
  for (int i = 0; i < AIRLIGHT_MAXIMUM_PANELS && done < reach; i++)
  {
    real next = min(done + airlightHalfAngleStep(medium, arc, done), reach);
    parts += airlightHalfAnglePanel(arc, done, next);
    done = next;
  }
  return open ? rest : airlightPhaseHalves(medium.phase, real(0.5), real(0.5)) * parts;
}

AIRLIGHT_FN AirlightSpectrum airlightEquiangular(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
#ifdef AIRLIGHT_ISOTROPIC
  return airlightHalfAngleQuadrature(medium, ray, t0, t1);
#else
  return airlightEquiangularQuadrature(medium, ray, t0, t1);
#endif
}
