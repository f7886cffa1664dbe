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

// Where the series below is taken.
#ifdef AIRLIGHT_DOUBLE
#define AIRLIGHT_G_NEAR 2.0
#else
#define AIRLIGHT_G_NEAR 0.1
#endif

// Near the origin: E1(z) = -gamma - ln z - S(z), S(z) = sum_k (-z)^k/(k k!). The polynomial S is
// evaluated by its recurrence over real quadratics, which gives Im(S)/y without dividing by y.
// Returns (g, Re(e^z E1(z))).
AIRLIGHT_FN real2 airlightGSeries(real x, real y)
{
  real q = x * x + y * y;
  real p = x + x;
  real b1 = real(0.0);
  real b2 = real(0.0);
  // a_k = (-1)^k/(k k!), from the last one upwards: a_(k-1) = -a_k k^2/(k - 1).
#ifdef AIRLIGHT_DOUBLE
  const int terms = 30;
  real a = real(1.256662542938635e-34); // 1/(30 30!)
#else
  const int terms = 4;
  real a = real(0.010416666667); // 1/(4 4!)
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
#ifdef AIRLIGHT_DOUBLE
  real cosine = cos(y);
  real sinc = y < real(1e-3) ? real(1.0) - y * y / real(6.0) : sin(y) / y;
#else
  // As long as the series they go with.
  real y2 = y * y;
  real cosine = real(1.0) - y2 * (real(0.5) - y2 * real(0.041666667));
  real sinc = real(1.0) - y2 * (real(0.16666667) - y2 * real(0.0083333333));
#endif
  return exp(x) * real2(cosine * im - sinc * re, cosine * re + y * y * sinc * im);
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
// Away from the origin, single precision: the Stieltjes form with the exponential replaced by
// twelve positive poles, fitted by least squares with Lawson's weights: no cancellation, relative
// error 2.3e-7 for |z| >= 0.05. A pole of higher order (AirlightPhase.glsl) has the same form, with
// powers of the same quotients: 2e-6 and 6e-6 for |z| >= 0.1.
AIRLIGHT_FN real airlightFarTerm(real weight, real p, real y2, real3 c, real u2)
{
  real r = real(1.0) / (p * p + y2);
  return weight * r * (c.x + u2 * r * (c.y + u2 * r * c.z));
}

AIRLIGHT_FN real airlightPoleFar(real x, real y, real3 c, real u2)
{
  real y2 = y * y;
  return airlightFarTerm(real(0.00737798299), x + real(0.00288969572), y2, c, u2) +
    airlightFarTerm(real(0.0169662485), x + real(0.0151641167), y2, c, u2) +
    airlightFarTerm(real(0.028089009), x + real(0.0380062645), y2, c, u2) +
    airlightFarTerm(real(0.0451147239), x + real(0.0760120132), y2, c, u2) +
    airlightFarTerm(real(0.0726572211), x + real(0.140470722), y2, c, u2) +
    airlightFarTerm(real(0.112958728), x + real(0.252103957), y2, c, u2) +
    airlightFarTerm(real(0.161208399), x + real(0.445942003), y2, c, u2) +
    airlightFarTerm(real(0.198447673), x + real(0.780421821), y2, c, u2) +
    airlightFarTerm(real(0.19127282), x + real(1.35381331), y2, c, u2) +
    airlightFarTerm(real(0.122732425), x + real(2.33315752), y2, c, u2) +
    airlightFarTerm(real(0.0396131805), x + real(4.01920212), y2, c, u2) +
    airlightFarTerm(real(0.00356140332), x + real(7.08956551), y2, c, u2);
}

AIRLIGHT_FN real airlightGFar(real x, real y)
{
  return airlightPoleFar(x, y, real3(real(1.0), real(0.0), real(0.0)), real(0.0));
}
#endif

AIRLIGHT_FN real airlightG(real x, real y)
{
  real q = x * x + y * y;
  // Below this radius g is beyond single precision; nothing physical comes near it.
  if (q < real(1e-30))
  {
    y = max(y, real(1e-15));
  }
  bool near = q < real(AIRLIGHT_G_NEAR * AIRLIGHT_G_NEAR);
  return near ? airlightGSeries(x, y).x : airlightGFar(x, y);
}

// (g, Re(e^z E1(z))); in single precision within |z| <= AIRLIGHT_G_NEAR only.
AIRLIGHT_FN real2 airlightGPair(real x, real y)
{
#ifdef AIRLIGHT_DOUBLE
  if (x * x + y * y >= real(AIRLIGHT_G_NEAR * AIRLIGHT_G_NEAR))
  {
    return airlightGFarPair(x, y);
  }
#endif
  return airlightGSeries(x, y);
}
