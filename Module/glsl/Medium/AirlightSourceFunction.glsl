// The source function of multiply scattered light round a point lamp of power 1 in an unbounded
// uniform medium, in optical lengths (sigma_t = 1):
//
//   J(r, mu) = (1/r) exp(Q(x, y) - kappa r),   Q = sum of q_ij x^i T_j(y)
//
// T are Chebyshev polynomials; x and y, in [-1, 1], stand for the distance r and for the cosine mu
// of the angle between the scattered light and the way from the lamp. The fluence and the flux of
// the light that was scattered at least once are fitted in the same way by x alone.
// AirlightSourceFit.h makes the coefficients. Channels differ where their albedos do.

#define AIRLIGHT_SOURCE_ROWS 8
#define AIRLIGHT_SOURCE_COLUMNS 6
#define AIRLIGHT_SOURCE_LEAST 0.05 // the range of r that is fitted
#define AIRLIGHT_SOURCE_MOST 20.0
#define AIRLIGHT_SOURCE_SMALL_LOBE 1e-3
// More lamps than any scene needs at once.
#define AIRLIGHT_MAX_MULTIPLE_LAMPS 16
#define AIRLIGHT_MAX_MULTIPLE_SUNS 4
#define AIRLIGHT_SUN_ROWS 9

// One number for three in a grey medium, and no angle in an isotropic one: shaders know.
#if defined(AIRLIGHT_MULTIPLE_GREY) && AIRLIGHT_MULTIPLE_GREY
#define AirlightMultipleSpectrum real
#define AIRLIGHT_MULTIPLE_SPECTRUM(colour) (colour).x
#else
#define AirlightMultipleSpectrum real3
#define AIRLIGHT_MULTIPLE_SPECTRUM(colour) real3(colour)
#endif

struct AirlightMultiple
{
  int on;      // 1: all but the lamps is set
  int count;   // of lamps and suns; 0: no multiple scattering
  int suns;
  real3 kappa; // how fast the light falls far away, per optical length
  real3 loss;  // (3/2) (1 - c g_1): of light that meets a face of the region
  real lobe;   // the square of the phase function's mean cosine
  real4 source[AIRLIGHT_SOURCE_ROWS * AIRLIGHT_SOURCE_COLUMNS]; // q_ij, a channel each
  real4 moment[2 * AIRLIGHT_SOURCE_ROWS]; // of the fluence, then of the flux
  real4 lamp[AIRLIGHT_MAX_MULTIPLE_LAMPS];  // position; least distance from it
  real4 power[AIRLIGHT_MAX_MULTIPLE_LAMPS]; // 4 pi times the radiant intensity; 1: of collisions
  // Of suns, see AirlightLayeredScattering.glsl.
  real meanCosine;   // of scattering
  real groundDepth;  // where level ground ends the layers, as airlightLayerDepth(); 0: none
  real3 groundAlbedo;
  real layerCosine;  // of scattering without its forward peak
  real3 layerAlbedo; // likewise
  real3 layerScale;  // its extinction by that of the medium
  real3 layerRate;   // how fast the light falls far from the sides, per depth
  real3 layerFlux;   // there the light's i1 by its i0
  real4 sun[AIRLIGHT_MAX_MULTIPLE_SUNS * AIRLIGHT_SUN_ROWS];
};
AIRLIGHT_MULTIPLE_UNIFORM

// x in [-1, 1].
AIRLIGHT_FN AirlightMultipleSpectrum airlightSourceX(AirlightMultipleSpectrum r)
{
  const real low = real(0.11111111111111111);   // sqrt(r/(r + 4)) of the least and the greatest r
  const real high = real(0.91287092917527686);
  AirlightMultipleSpectrum within =
    clamp(r, AirlightMultipleSpectrum(real(AIRLIGHT_SOURCE_LEAST)),
      AirlightMultipleSpectrum(real(AIRLIGHT_SOURCE_MOST)));
  AirlightMultipleSpectrum root = sqrt(within / (within + AirlightMultipleSpectrum(real(4.0))));
  return (root - AirlightMultipleSpectrum(low)) * (real(2.0) / (high - low)) -
    AirlightMultipleSpectrum(real(1.0));
}

// y in [-1, 1]: by the shape of a Henyey-Greenstein lobe of this asymmetry parameter.
AIRLIGHT_FN real airlightSourceY(real lobe, real mu)
{
  if (lobe < real(AIRLIGHT_SOURCE_SMALL_LOBE))
  {
    return mu;
  }
  real least = sqrt((real(1.0) - lobe) / (real(1.0) + lobe));
  real w = (real(1.0) - lobe) * inversesqrt(real(1.0) + lobe * lobe - real(2.0) * lobe * mu);
  return (sqrt(w) - least) * (real(2.0) / (real(1.0) - least)) - real(1.0);
}

// The polynomial in y of row i.
AIRLIGHT_FN AirlightMultipleSpectrum airlightSourceRow(
  AIRLIGHT_MULTIPLE_IN int i, real y, real y2, real y3, real y4, real y5)
{
  AirlightMultipleSpectrum row =
    AIRLIGHT_MULTIPLE_SPECTRUM(airlightMultiple.source[i * AIRLIGHT_SOURCE_COLUMNS]);
#ifndef AIRLIGHT_ISOTROPIC
  row += y * AIRLIGHT_MULTIPLE_SPECTRUM(airlightMultiple.source[i * AIRLIGHT_SOURCE_COLUMNS + 1]) +
    y2 * AIRLIGHT_MULTIPLE_SPECTRUM(airlightMultiple.source[i * AIRLIGHT_SOURCE_COLUMNS + 2]) +
    (y3 * AIRLIGHT_MULTIPLE_SPECTRUM(airlightMultiple.source[i * AIRLIGHT_SOURCE_COLUMNS + 3]) +
      y4 * AIRLIGHT_MULTIPLE_SPECTRUM(airlightMultiple.source[i * AIRLIGHT_SOURCE_COLUMNS + 4])) +
    y5 * AIRLIGHT_MULTIPLE_SPECTRUM(airlightMultiple.source[i * AIRLIGHT_SOURCE_COLUMNS + 5]);
#endif
  return row;
}

// The polynomial of these coefficients in x. Pair by pair: each step of a chain waits for the one
// before it.
AIRLIGHT_FN AirlightMultipleSpectrum airlightSourcePolynomial(AirlightMultipleSpectrum x,
  AirlightMultipleSpectrum q0, AirlightMultipleSpectrum q1, AirlightMultipleSpectrum q2,
  AirlightMultipleSpectrum q3, AirlightMultipleSpectrum q4, AirlightMultipleSpectrum q5,
  AirlightMultipleSpectrum q6, AirlightMultipleSpectrum q7)
{
  AirlightMultipleSpectrum x2 = x * x;
  return ((q0 + x * q1) + x2 * (q2 + x * q3)) +
    (x2 * x2) * ((q4 + x * q5) + x2 * (q6 + x * q7));
}

// Q of each channel.
AIRLIGHT_FN AirlightMultipleSpectrum airlightSourceLogarithm(
  AIRLIGHT_MULTIPLE_IN AirlightMultipleSpectrum x, real y)
{
  real y2 = real(2.0) * y * y - real(1.0);
  real y3 = real(2.0) * y * y2 - y;
  real y4 = real(2.0) * y2 * y2 - real(1.0);
  real y5 = real(2.0) * y2 * y3 - y;
  return airlightSourcePolynomial(x,
    airlightSourceRow(AIRLIGHT_MULTIPLE_OUT 0, y, y2, y3, y4, y5),
    airlightSourceRow(AIRLIGHT_MULTIPLE_OUT 1, y, y2, y3, y4, y5),
    airlightSourceRow(AIRLIGHT_MULTIPLE_OUT 2, y, y2, y3, y4, y5),
    airlightSourceRow(AIRLIGHT_MULTIPLE_OUT 3, y, y2, y3, y4, y5),
    airlightSourceRow(AIRLIGHT_MULTIPLE_OUT 4, y, y2, y3, y4, y5),
    airlightSourceRow(AIRLIGHT_MULTIPLE_OUT 5, y, y2, y3, y4, y5),
    airlightSourceRow(AIRLIGHT_MULTIPLE_OUT 6, y, y2, y3, y4, y5),
    airlightSourceRow(AIRLIGHT_MULTIPLE_OUT 7, y, y2, y3, y4, y5));
}

// The logarithm of r times the fluence (from row 0) or of r times the flux (from row
// AIRLIGHT_SOURCE_ROWS), plus kappa r.
AIRLIGHT_FN AirlightMultipleSpectrum airlightMomentLogarithm(
  AIRLIGHT_MULTIPLE_IN int first, AirlightMultipleSpectrum x)
{
  return airlightSourcePolynomial(x,
    AIRLIGHT_MULTIPLE_SPECTRUM(airlightMultiple.moment[first]),
    AIRLIGHT_MULTIPLE_SPECTRUM(airlightMultiple.moment[first + 1]),
    AIRLIGHT_MULTIPLE_SPECTRUM(airlightMultiple.moment[first + 2]),
    AIRLIGHT_MULTIPLE_SPECTRUM(airlightMultiple.moment[first + 3]),
    AIRLIGHT_MULTIPLE_SPECTRUM(airlightMultiple.moment[first + 4]),
    AIRLIGHT_MULTIPLE_SPECTRUM(airlightMultiple.moment[first + 5]),
    AIRLIGHT_MULTIPLE_SPECTRUM(airlightMultiple.moment[first + 6]),
    AIRLIGHT_MULTIPLE_SPECTRUM(airlightMultiple.moment[first + 7]));
}
