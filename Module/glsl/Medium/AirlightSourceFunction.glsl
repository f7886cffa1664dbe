// The source function of multiply scattered light round a point lamp of power 1 in an unbounded
// uniform medium, in optical lengths (sigma_t = 1):
//
//   J(r, mu) = (1/r) exp(Q(x, y) - kappa r),   Q = sum of q_ij T_i(x) T_j(y)
//
// T are Chebyshev polynomials, x stands for the distance r and y for the cosine mu of the angle
// between the scattered light and the way from the lamp. The fluence and the flux of the light that
// was scattered at least once are fitted in the same way by x alone. AirlightSourceFit.h makes the
// coefficients. Channels differ where their albedos do.

#define AIRLIGHT_SOURCE_ROWS 8
#define AIRLIGHT_SOURCE_COLUMNS 6
#define AIRLIGHT_SOURCE_LEAST 0.05 // the range of r that is fitted
#define AIRLIGHT_SOURCE_MOST 20.0
#define AIRLIGHT_SOURCE_SMALL_LOBE 1e-3
// More lamps than any scene needs at once.
#define AIRLIGHT_MAX_MULTIPLE_LAMPS 16

struct AirlightMultiple
{
  int on;      // 1: all but the lamps is set
  int count;   // of lamps; 0: no multiple scattering
  real3 kappa; // how fast the light falls far away, per optical length
  real3 loss;  // (3/2) (1 - c g_1): of light that meets a face of the region
  real lobe;   // the square of the phase function's mean cosine
  real4 source[AIRLIGHT_SOURCE_ROWS * AIRLIGHT_SOURCE_COLUMNS]; // q_ij, a channel each
  real4 moment[2 * AIRLIGHT_SOURCE_ROWS]; // of the fluence, then of the flux
  real4 lamp[AIRLIGHT_MAX_MULTIPLE_LAMPS];  // position; least distance from it
  real4 power[AIRLIGHT_MAX_MULTIPLE_LAMPS]; // 4 pi times the radiant intensity
};
AIRLIGHT_MULTIPLE_UNIFORM

// x in [-1, 1].
AIRLIGHT_FN real3 airlightSourceX(real3 r)
{
  const real low = real(0.11111111111111111);   // sqrt(r/(r + 4)) of the least and the greatest r
  const real high = real(0.91287092917527686);
  real3 within = clamp(r, real3(real(AIRLIGHT_SOURCE_LEAST)), real3(real(AIRLIGHT_SOURCE_MOST)));
  real3 root = sqrt(within / (within + real3(real(4.0))));
  return (root - real3(low)) * (real(2.0) / (high - low)) - real3(real(1.0));
}

// y in [-1, 1]: by the shape of a Henyey-Greenstein lobe of this asymmetry parameter.
AIRLIGHT_FN real airlightSourceY(real lobe, real mu)
{
  if (lobe < real(AIRLIGHT_SOURCE_SMALL_LOBE))
  {
    return mu;
  }
  real least = sqrt((real(1.0) - lobe) / (real(1.0) + lobe));
  real w = (real(1.0) - lobe) / sqrt(real(1.0) + lobe * lobe - real(2.0) * lobe * mu);
  return (sqrt(w) - least) * (real(2.0) / (real(1.0) - least)) - real(1.0);
}

// Q of each channel.
AIRLIGHT_FN real3 airlightSourceLogarithm(AIRLIGHT_MULTIPLE_IN real3 x, real y)
{
  real t[AIRLIGHT_SOURCE_COLUMNS];
  t[0] = real(1.0);
  t[1] = y;
  for (int j = 2; j < AIRLIGHT_SOURCE_COLUMNS; j++)
  {
    t[j] = real(2.0) * y * t[j - 1] - t[j - 2];
  }
  // Clenshaw's recurrence over the rows.
  real3 above = real3(real(0.0));
  real3 sum = real3(real(0.0));
  for (int i = AIRLIGHT_SOURCE_ROWS - 1; i >= 0; i--)
  {
    real3 row = real3(real(0.0));
    for (int j = 0; j < AIRLIGHT_SOURCE_COLUMNS; j++)
    {
      row += t[j] * real3(airlightMultiple.source[i * AIRLIGHT_SOURCE_COLUMNS + j]);
    }
    real3 next = row + (i > 0 ? real(2.0) : real(1.0)) * x * sum - above;
    above = sum;
    sum = next;
  }
  return sum;
}

// The logarithm of r times the fluence (from row 0) or of r times the flux (from row
// AIRLIGHT_SOURCE_ROWS), plus kappa r.
AIRLIGHT_FN real3 airlightMomentLogarithm(AIRLIGHT_MULTIPLE_IN int first, real3 x)
{
  real3 above = real3(real(0.0));
  real3 sum = real3(real(0.0));
  for (int i = AIRLIGHT_SOURCE_ROWS - 1; i >= 0; i--)
  {
    real3 next = real3(airlightMultiple.moment[first + i]) +
      (i > 0 ? real(2.0) : real(1.0)) * x * sum - above;
    above = sum;
    sum = next;
  }
  return sum;
}
