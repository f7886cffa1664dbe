// What is scattered along a ray on which no shadow ends, or between two places of it (AirlightTurn.glsl).

// By the parts in which boundaries are found (AirlightTurnPart.glsl), for every phase function.
AIRLIGHT_FN AirlightShade airlightTurnByAngles(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
  AirlightTurn turn = airlightTurn(medium, ray, t0, t1);
  AirlightShade sum = AirlightShade(real(0.0));
  real psi = real(0.0);
  for (int i = 0; i < AIRLIGHT_TURN_PARTS && psi < turn.end; i++)
  {
    real next = airlightTurnPartEnd(medium, turn, psi);
    sum += airlightTurnWhole(medium, turn, psi, next);
    psi = next;
  }
  return sum;
}

// In an isotropic medium the same integral in s = tan(theta/2) is that of exp(-u s)/(1 + s^2), with
// u = sigmaT h: it takes no angles, and half as many exponentials.

// How far s grows up to t1; as a difference of its ends it would cancel on a short way. What lies beyond
// 1e7 (1 + s) is less than 1e-7 of the ray's airlight.
AIRLIGHT_FN real airlightTurnReach(
  AIRLIGHT_IN(AirlightTurn) turn, AIRLIGHT_IN(AirlightRay) ray, real t1)
{
  real x = airlightFromFoot(ray, t1);
  real h2 = turn.h * turn.h;
  real r = sqrt(h2 + turn.x * turn.x) + sqrt(h2 + x * x);
  real both = turn.s + airlightTurnTangent(turn.h, x);
  real reach = max(airlightWayBetween(ray, turn.from, t1), real(0.0)) * (both / r);
  return min(reach, real(1e7) * (real(1.0) + turn.s));
}

// How far a part may reach on which eight nodes give 1e-6: at s the poles, i and -i, allow 2.65 + 2.05 s,
// and the exponential an optical depth of 14. Both together: fitted to what quadrature found.
AIRLIGHT_FN real airlightTurnStep(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightTurn) turn, real done)
{
  real step = real(2.65) + real(2.05) * (turn.s + done);
  return step / (real(1.0) + step * (airlightMostFading(medium, turn, done) / real(14.0)));
}

// The sum of exp(-u y)/(1 + s^2) at two nodes y = off and -off from a part's middle m, times 1 + m^2. There
// 1 + s^2 is (1 + m^2) (even + odd) and (1 + m^2) (even - odd).
AIRLIGHT_FN AirlightShade airlightTurnNode(AirlightShade slope, real off, real linear, real square)
{
  real odd = off * linear;
  real even = real(1.0) + off * off * square;
  real after = even + odd;
  real before = even - odd;
  AirlightShade fades = exp2(slope * off);
  return (fades * (before * fades) + after) / (fades * (after * before));
}

// The integral over a part from `done` to `next` beyond the ray's beginning, without the phase function.
AIRLIGHT_FN AirlightShade airlightTurnStraight(AIRLIGHT_IN(AirlightTurn) turn, real done, real next)
{
  real reach = real(0.5) * (next - done);
  real middle = turn.s + real(0.5) * (done + next);
  real scale = real(1.0) / (real(1.0) + middle * middle);
  // Not less, where a channel had gone before: its power of two could be none.
  AirlightShade slope = max(turn.slope * reach, AirlightShade(real(-50.0)));
  real linear = real(2.0) * reach * (middle * scale);
  real square = reach * (reach * scale);
  AirlightShade sum = (real(0.36268378337836198) *
                          airlightTurnNode(slope, real(0.18343464249564978), linear, square) +
                        real(0.31370664587788729) *
                          airlightTurnNode(slope, real(0.52553240991632899), linear, square)) +
    (real(0.22238103445337447) *
        airlightTurnNode(slope, real(0.79666647741362673), linear, square) +
      real(0.10122853629037626) *
        airlightTurnNode(slope, real(0.96028985649753618), linear, square));
  return (real(2.0) * reach * scale) * exp2(turn.start + turn.slope * middle) * sum;
}

// The whole ray in s.
AIRLIGHT_FN AirlightShade airlightTurnByTangents(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
  AirlightTurn turn = airlightTurnFrom(medium, ray, t0);
  real reach = airlightTurnReach(turn, ray, t1);
  bool open = airlightTurnLeastFading(medium, turn.h) * reach > real(AIRLIGHT_TURN_FADED);
  AirlightShade rest = AirlightShade(real(0.0));
  if (open)
  {
    rest = airlightTurnRest(medium, turn, real(0.0));
  }
  AirlightShade parts = AirlightShade(real(0.0));
  real done = open ? reach : real(0.0);
  for (int i = 0; i < AIRLIGHT_TURN_PARTS && done < reach; i++)
  {
    real next = min(done + airlightTurnStep(medium, turn, done), reach);
    parts += airlightTurnStraight(turn, done, next);
    done = next;
  }
  return open ? rest : airlightPhaseHalves(medium.phase, real(0.5), real(0.5)) * parts;
}

AIRLIGHT_FN AirlightShade airlightTurnAll(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
#ifdef AIRLIGHT_ISOTROPIC
  return airlightTurnByTangents(medium, ray, t0, t1);
#else
  return airlightTurnByAngles(medium, ray, t0, t1);
#endif
}
