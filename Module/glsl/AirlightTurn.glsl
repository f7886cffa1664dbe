// A point light's airlight before every point of a ray at once. Seen from the light, a point that
// moves along the ray turns by the angle psi, in which the inverse square is a constant
// (AirlightPointLight.glsl):
//
//   integral p/r^2 exp(-sigmaT (t + r)) dt = 1/h integral p exp(-sigmaT (t + r)) dpsi
//
// The ray is cut into few parts. On each the integrand is replaced by the polynomial that meets it
// at the eight nodes of Gauss and Legendre, whose integral is known everywhere: that of the whole
// part is the quadrature's, and every end of a shadow in between takes one arctangent and a
// polynomial of degree eight, where the closed form takes an exponential integral. The parts are
// chosen such that the polynomial's integral is off by 1e-6 of the part's, at most a few times that
// (Testing/Cxx/TestTurn.cxx).

#if defined(AIRLIGHT_GREY) && AIRLIGHT_GREY
#define AirlightShade real
#define AIRLIGHT_SHADE(colour) (colour).x
#else
#define AirlightShade real3
#define AIRLIGHT_SHADE(colour) (colour)
#endif

// Optical depths after which nothing counts any more.
#ifdef AIRLIGHT_DOUBLE
#define AIRLIGHT_TURN_FADED 24.0
#else
#define AIRLIGHT_TURN_FADED 17.0
#endif
// More parts than any ray has that matters.
#define AIRLIGHT_TURN_PARTS 64

struct AirlightTurn
{
  real from;  // where the ray begins, from its origin
  real depth; // of that in the medium
  real x;     // of that from the light's foot
  real r;     // from the light
  real h;
  real left; // the angle at the light between the ray's beginning and its direction
  real end;  // psi where the ray ends, or the light is gone
};

struct AirlightTurnPart
{
  real middle;
  real reach;
  AirlightShade whole; // half of the integral over the part
  AirlightShade even[4];
  AirlightShade odd[4];
};

// Sine and cosine in [0, pi/2], errors 4e-9 and 2e-10.
AIRLIGHT_FN real2 airlightSineCosine(real a)
{
#ifdef AIRLIGHT_DOUBLE
  return real2(sin(a), cos(a));
#else
  real z = a * a;
  return real2(a *
      (real(0.9999999957) +
        z * (real(-0.1666665799) +
        z * (real(0.008333051064) + z * (real(-0.0001980907531) + z * real(2.605224917e-06))))),
    real(0.9999999998) +
      z * (real(-0.4999999936) +
      z * (real(0.04166663626) +
      z * (real(-0.00138883614) + z * (real(2.476016136e-05) + z * real(-2.605149508e-07))))));
#endif
}

// The angle by which the light sees the ray turn from its beginning to t, from cross and dot product
// of the two directions: a difference of two angles would cancel.
AIRLIGHT_FN real airlightTurned(
  AIRLIGHT_IN(AirlightTurn) turn, AIRLIGHT_IN(AirlightRay) ray, real t)
{
  real l = max(t - turn.from, real(0.0));
  real x = max((t - ray.range.x) - ray.foot.tL, turn.x);
  return airlightAngle(turn.h * l, turn.h * turn.h + turn.x * x);
}

// Twice the arctangent.
AIRLIGHT_FN real airlightTwiceAngle(real y, real x)
{
  return real(2.0) * airlightAngle(y, x);
}

// A ray's part [t0, t1] in which the light is not cut off.
AIRLIGHT_FN AirlightTurn airlightTurn(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
  AirlightTurn turn;
  turn.from = t0;
  turn.depth = t0 - ray.range.x;
  turn.x = turn.depth - ray.foot.tL;
  turn.h = ray.foot.h;
  turn.r = sqrt(turn.h * turn.h + turn.x * turn.x);
  turn.left = airlightAngle(turn.h, turn.x);
  // In s = tan(theta/2) (AirlightPointLight.glsl) the optical depth grows by sigmaT h per unit.
  real s = turn.x >= real(0.0) ? (turn.x + turn.r) / turn.h : turn.h / (turn.r - turn.x);
  real faded = real(AIRLIGHT_TURN_FADED) / (airlightLeastExtinction(medium) * turn.h);
  turn.end = min(airlightTurned(turn, ray, t1),
    airlightTwiceAngle(faded, real(1.0) + s * (s + faded)));
  return turn;
}

// How far the ray may turn from an angle `left` to its direction, for a phase function's peaks: poles
// lie about 2 b off the real angles before the forward direction, and 2/b before the backward one.
AIRLIGHT_FN real airlightSmoothTurn(AIRLIGHT_IN(AirlightPhase) phase, real left)
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
    length = min(length, (back ? real(0.5) : real(0.83)) * sqrt(along * along + off * off));
  }
#endif
  return length;
}

// How long a part may be that begins at psi. What limits it is where the integrand is not smooth:
// the asymptote, which it nears as exp(-2 tau/angle), and a phase function's peaks.
AIRLIGHT_FN real airlightTurnPartEnd(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightTurn) turn, real psi)
{
  real tau = turn.h * max(medium.sigmaT.x, max(medium.sigmaT.y, medium.sigmaT.z));
  real left = max(turn.left - psi, real(1e-6));
  // Fitted to where eight nodes give 1e-6.
  real ratio = sqrt(tau / left);
  ratio = real(0.3) * ratio / (ratio + real(0.045));
  // Four optical depths at first, more where less is left.
  real many = psi > real(0.0) ? real(6.0) : real(4.0);
  real2 half1 = airlightSineCosine(real(0.5) * left);
  real faded = airlightTwiceAngle(half1.x, half1.y + half1.x * many / tau);
  real length = left - max(ratio * left, faded);
  length = min(length, airlightSmoothTurn(medium.phase, left));
  return min(psi + max(length, real(1e-3) * left), turn.end);
}

AIRLIGHT_FN AirlightShade airlightTurnSample(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightTurn) turn, real psi)
{
  real2 half1 = airlightSineCosine(real(0.5) * psi);
  real s = real(2.0) * half1.x * half1.y;
  real c = real(1.0) - real(2.0) * half1.x * half1.x;
  real d = max(turn.h * c - turn.x * s, real(1e-30));
  // t + r at the angle psi.
  real way = turn.depth + turn.r * (turn.r * s + turn.h) / d;
  return airlightPhase(medium.phase, -(turn.x * c + turn.h * s) / turn.r) *
    exp(-AIRLIGHT_SHADE(medium.sigmaT) * way);
}

// The part from psi0 to psi1. With y in [-1, 1] along it and z = y^2, what is before y is
//
//   E(1) + y E(2 z - 1) - (1 - z) O(2 z - 1)
//
// with cubics E, of the nodes' sums, and O, of their differences; so at y = -1 it is 0 to the bit.
AIRLIGHT_FN AirlightTurnPart airlightTurnPart(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_IN(AirlightTurn) turn, real psi0, real psi1)
{
  AirlightTurnPart part;
  part.middle = real(0.5) * (psi0 + psi1);
  part.reach = real(0.5) * (psi1 - psi0);
  AirlightShade sum[4];
  AirlightShade gap[4];
  for (int k = 0; k < 4; k++)
  {
    real node = part.reach *
      (k < 2 ? (k == 0 ? real(0.18343464249564978) : real(0.52553240991632899))
             : (k == 2 ? real(0.79666647741362673) : real(0.96028985649753618)));
    AirlightShade after = airlightTurnSample(medium, turn, part.middle + node);
    AirlightShade before = airlightTurnSample(medium, turn, part.middle - node);
    sum[k] = part.reach * (after + before);
    gap[k] = part.reach * (after - before);
  }
  part.even[0] = real(0.255673747222) * sum[0] +
    real(0.221805968253) * sum[1] +
    real(0.0253799423589) * sum[2] +
    real(-0.00285965783329) * sum[3];
  part.even[1] = real(-0.152398985846) * sum[0] +
    real(0.00711579102774) * sum[1] +
    real(0.165152275338) * sum[2] +
    real(-0.0198690805204) * sum[3];
  part.even[2] = real(0.147003529978) * sum[0] +
    real(-0.231036877713) * sum[1] +
    real(0.064803171746) * sum[2] +
    real(0.0192301759894) * sum[3];
  part.even[3] = real(-0.0689363996646) * sum[0] +
    real(0.158968441372) * sum[1] +
    real(-0.144144872217) * sum[2] +
    real(0.0541128305095) * sum[3];
  part.odd[0] = real(0.00757419981627) * gap[0] +
    real(-0.0040837883702) * gap[1] +
    real(0.18858661277) * gap[2] +
    real(0.104672729119) * gap[3];
  part.odd[1] = real(0.141475364289) * gap[0] +
    real(-0.228653715794) * gap[1] +
    real(-0.0346463856799) * gap[2] +
    real(0.126852396324) * gap[3];
  part.odd[2] = real(-0.0368131538904) * gap[0] +
    real(0.200815580834) * gap[1] +
    real(-0.271467418821) * gap[2] +
    real(0.122345043081) * gap[3];
  part.odd[3] = real(-0.328832923192) * gap[0] +
    real(0.264678987586) * gap[1] +
    real(-0.1583181504) * gap[2] +
    real(0.0493067029454) * gap[3];
  part.whole = ((part.even[3] + part.even[2]) + part.even[1]) + part.even[0];
  return part;
}

// The integral from the part's beginning to psi, or to its nearer end.
AIRLIGHT_FN AirlightShade airlightTurnBefore(AIRLIGHT_IN(AirlightTurnPart) part, real psi)
{
  real y = clamp((psi - part.middle) / part.reach, real(-1.0), real(1.0));
  real z = y * y;
  real w = z + z - real(1.0);
  AirlightShade even = ((part.even[3] * w + part.even[2]) * w + part.even[1]) * w + part.even[0];
  AirlightShade odd = ((part.odd[3] * w + part.odd[2]) * w + part.odd[1]) * w + part.odd[0];
  return (part.whole + y * even) - (real(1.0) - z) * odd;
}
