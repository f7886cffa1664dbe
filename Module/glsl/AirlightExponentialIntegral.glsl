// The one special function of single scattering:
//
//   g(x, y) = Im( e^z E1(z) ) / y,   z = x - i y,   x, y >= 0, not both 0
//           = integral_0^inf e^-p / ((p + x)^2 + y^2) dp      (its Stieltjes form)
//
// E1 is the exponential integral (Abramowitz and Stegun, chapter 5). Dividing by y keeps the value
// finite where y goes to 0, and positive everywhere.

// The angle of the point (x, y), y >= 0, in [0, pi]. Abramowitz and Stegun 4.4.49, error 2e-8:
// built-in arctangents of some drivers are far less accurate than the rest of their arithmetic.
AIRLIGHT_FN real airlightAngle(real y, real x)
{
#ifdef AIRLIGHT_DOUBLE
  return atan(y, x);
#else
  real ax = abs(x);
  real big = max(ax, y);
  real q = min(ax, y) / max(big, real(1e-37));
  // Pair by pair: each step of a chain waits for the one before it.
  real p = q * q;
  real p2 = p * p;
  real low = (real(-0.3333314528) + p * real(0.1999355085)) +
    p2 * (real(-0.1420889944) + p * real(0.1065626393));
  real high = (real(-0.0752896400) + p * real(0.0429096138)) +
    p2 * (real(-0.0161657367) + p * real(0.0028662257));
  real a = q + q * p * (low + p2 * p2 * high);
  a = y > ax ? real(1.5707963267948966) - a : a;
  return x < real(0.0) ? real(3.1415926535897932) - a : a;
#endif
}

// Near the origin: E1(z) = -gamma - ln z - S(z), S(z) = sum_k (-z)^k/(k k!). The polynomial S is
// evaluated by its recurrence over real quadratics, which gives Im(S)/y without dividing by y.
// Returns (g, Re(e^z E1(z))).
AIRLIGHT_FN real2 airlightGSeries(real x, real y)
{
  real q = x * x + y * y;
  real p = x + x;
  real b1 = real(0.0);
  real b2 = real(0.0);
#ifdef AIRLIGHT_DOUBLE
  const int terms = 30;
#else
  const int terms = 10;
#endif
  // a_k = (-1)^k/(k k!), from the last one upwards: a_(k-1) = -a_k k^2/(k - 1).
#ifdef AIRLIGHT_DOUBLE
  real a = real(1.256662542938635e-34); // 1/(30 30!)
#else
  real a = real(2.755731922398589e-8); // 1/(10 10!)
#endif
  for (int k = terms; k >= 1; k--)
  {
    real b0 = a + p * b1 - q * b2;
    b2 = b1;
    b1 = b0;
    real rk = real(k);
    a = k > 1 ? -a * rk * rk / (rk - real(1.0)) : real(0.0);
  }
  real re = real(-0.57721566490153286) - real(0.5) * log(q) - (b1 * x - q * b2);
  real im = airlightAngle(y, x) / max(y, real(1e-30)) + b1;
  real sinc = y < real(1e-3) ? real(1.0) - y * y / real(6.0) : sin(y) / y;
  return exp(x) * real2(cos(y) * im - sinc * re, cos(y) * re + y * sin(y) * im);
}

#ifdef AIRLIGHT_DOUBLE
// Away from the origin, double precision: the continued fraction
// e^z E1(z) = 1/(z + 1 - 1/(z + 3 - 4/(z + 5 - 9/(z + 7 - ...)))), imaginary parts divided by -y:
// then every term has one sign and nothing cancels. Returns (g, Re(e^z E1(z))).
AIRLIGHT_FN real2 airlightGFarPair(real x, real y)
{
  // Convergence goes as exp(-4 sqrt(levels |z|) cos(arg(z)/2)).
  int levels = int(real(10.0) + real(190.0) / sqrt(x * x + y * y));
  real re = x + real(2 * levels + 1);
  real im = real(1.0);
  for (int n = levels - 1; n >= 0; n--)
  {
    real k = real(n + 1) * real(n + 1) / (re * re + y * y * im * im);
    re = x + real(2 * n + 1) - k * re;
    im = real(1.0) + k * im;
  }
  return real2(im, re) / (re * re + y * y * im * im);
}

AIRLIGHT_FN real airlightGFar(real x, real y)
{
  return airlightGFarPair(x, y).x;
}
#else
// Away from the origin, single precision: the Stieltjes form with the exponential replaced by eight
// positive poles, fitted by least squares with Lawson's weights: no cancellation, relative error
// 6e-7 for |z| >= 1. A pole of higher order (AirlightPhase.glsl) has the same form, with powers of
// the same quotients.
AIRLIGHT_FN real airlightFarTerm(real weight, real p, real y2, real3 c, real u2)
{
  real r = real(1.0) / (p * p + y2);
  return weight * r * (c.x + u2 * r * (c.y + u2 * r * c.z));
}

AIRLIGHT_FN real airlightPoleFar(real x, real y, real3 c, real u2)
{
  real y2 = y * y;
  return airlightFarTerm(real(0.0855436166), x + real(0.0356820929), y2, c, u2) +
    airlightFarTerm(real(0.149942807), x + real(0.170044082), y2, c, u2) +
    airlightFarTerm(real(0.200909055), x + real(0.403992495), y2, c, u2) +
    airlightFarTerm(real(0.217074451), x + real(0.789397065), y2, c, u2) +
    airlightFarTerm(real(0.182159801), x + real(1.38302551), y2, c, u2) +
    airlightFarTerm(real(0.116040211), x + real(2.30068582), y2, c, u2) +
    airlightFarTerm(real(0.0436835825), x + real(3.85542917), y2, c, u2) +
    airlightFarTerm(real(0.00464619177), x + real(6.79779735), y2, c, u2);
}

AIRLIGHT_FN real airlightGFar(real x, real y)
{
  return airlightPoleFar(x, y, real3(real(1.0), real(0.0), real(0.0)), real(0.0));
}
#endif

AIRLIGHT_FN real airlightG(real x, real y)
{
#ifdef AIRLIGHT_DOUBLE
  const real switchRadius = real(2.0);
#else
  const real switchRadius = real(1.0);
#endif
  real q = x * x + y * y;
  // Below this radius g is beyond single precision; nothing physical comes near it.
  if (q < real(1e-30))
  {
    y = max(y, real(1e-15));
  }
  return q < switchRadius * switchRadius ? airlightGSeries(x, y).x : airlightGFar(x, y);
}

// (g, Re(e^z E1(z))); in single precision within |z| <= 1 only.
AIRLIGHT_FN real2 airlightGPair(real x, real y)
{
#ifdef AIRLIGHT_DOUBLE
  if (x * x + y * y >= real(4.0))
  {
    return airlightGFarPair(x, y);
  }
#endif
  return airlightGSeries(x, y);
}
