// Airlight by quadrature, for what has no closed form: other attenuations than the inverse square,
// spots with an exponent, lights outside the region, varying density, several media.

// The estimated error that a panel may have, relative to the piece's integral. Where the integrand
// is smooth it is better than that by some orders of magnitude. Kinks that the panels are not cut
// at (AirlightKinks.glsl) are those of surfaces and tables: there are many, and 1e-3 is what they
// are allowed together.
#if AIRLIGHT_HAS_SURFACE || AIRLIGHT_HAS_TABLE || AIRLIGHT_HAS_PHOTOMETRY
#define AIRLIGHT_PANEL_TOLERANCE 1e-4
#else
#define AIRLIGHT_PANEL_TOLERANCE 1e-3
#endif

// So many panels may be halved, on all of a pixel's ray together. Mesa's software renderer ends all
// loops of a shader, without a word, after 65 535 rounds together, counted for eight pixels at once
// that wait for one another; with surfaces, where every node walks through a tree, a panel takes
// some hundreds of them.
#define AIRLIGHT_MOST_TRIES 800
#define AIRLIGHT_MOST_ROUNDS 6000
#ifndef AIRLIGHT_MAY_TRY // in shaders
int airlightTries = 0;
#if AIRLIGHT_HAS_SURFACE
#define AIRLIGHT_FEW_ROUNDS (airlightRounds < AIRLIGHT_MOST_ROUNDS)
#else
#define AIRLIGHT_FEW_ROUNDS true
#endif
#define AIRLIGHT_MAY_TRY (airlightTries++ < AIRLIGHT_MOST_TRIES && AIRLIGHT_FEW_ROUNDS)
#endif

// Panels narrower than this, of where they are, have nodes that rounding moves: halving them helps
// no more.
#ifdef AIRLIGHT_DOUBLE
#define AIRLIGHT_NARROWEST 1e-15
#else
#define AIRLIGHT_NARROWEST 1e-6
#endif

// Whether what is between a panel's ends and its outermost nodes is looked at, too.
#if AIRLIGHT_HAS_SURFACE && !defined(AIRLIGHT_DOUBLE) // see AirlightAdaptiveQuadrature.h
#define AIRLIGHT_CHECK_ENDS 1
#else
#define AIRLIGHT_CHECK_ENDS 0
#endif

// So many times more panels where media are inside surfaces.
#define AIRLIGHT_SURFACE_PANELS 2

// What the media of a piece scatter at a point, without what fades before and after.
AIRLIGHT_FN real3 airlightScattered(
  AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightPiece) piece, real3 point, real cosTheta)
{
  real3 sum = real3(real(0.0));
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    if (airlightPieceHolds(piece, i))
    {
      sum += airlightScatteringAt(airlightMedia.item[i], point) *
        airlightPhase(airlightMedia.item[i].phase, cosTheta) *
        airlightDensity(airlightMedia.item[i], point);
    }
  }
  return sum;
}

// Fall-off and cone of a light at a place, in the direction of a point r away. What a photometric
// table says comes on top.
AIRLIGHT_FN real airlightFalloff(AIRLIGHT_IN(AirlightLight) light, real3 point, real r)
{
  real fall = light.attenuation.x + r * (light.attenuation.y + r * light.attenuation.z);
  real spot = real(1.0);
  if (light.cosCone > real(0.0) && light.exponent > real(0.0))
  {
    real cosAngle = dot(point - light.position, light.axis) / max(r, light.radius);
    spot = pow(max(cosAngle, real(1e-6)), light.exponent);
  }
  return spot / fall;
}

// What a light's photometric table says of the direction of a point.
AIRLIGHT_FN real airlightPhotometricShare(AIRLIGHT_IN(AirlightLight) light, real3 point)
{
#if AIRLIGHT_HAS_PHOTOMETRY
  if (light.goniometric != 0)
  {
    return airlightPhotometry(light.photometry, normalize(point - light.position));
  }
#endif
  return real(1.0);
}

#ifdef AIRLIGHT_GRID_STEPS
real3 airlightLightDepth(AirlightLight light, real3 point); // AirlightGridWay
#endif

// Optical depth on the way from a point to the light.
AIRLIGHT_FN real3 airlightDepthToLight(
  AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light, real3 point)
{
#ifdef AIRLIGHT_GRID_STEPS
  return airlightLightDepth(light, point);
#else
  return airlightIsDirectional(light)
    ? airlightSunDepths(AIRLIGHT_MEDIA_OUT point, light.position)
    : airlightDepthBetween(AIRLIGHT_MEDIA_OUT point, light.position);
#endif
}

// The integrand at t, but for what a photometric table says: of a light at a place, x from its foot
// and r from the light; of a light at infinity, which has neither. Called in few places, as the
// three below: compilers put a copy of all that it takes into each.
AIRLIGHT_FN real3 airlightIntegrand(AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light,
  AIRLIGHT_IN(AirlightRay) ray, AIRLIGHT_IN(AirlightPiece) piece, real t, real x, real r)
{
  real3 point = ray.origin + t * ray.direction;
  real3 depth = airlightDepthInPiece(AIRLIGHT_MEDIA_OUT piece, ray.origin, ray.direction, t) +
    airlightDepthToLight(AIRLIGHT_MEDIA_OUT light, point);
  bool sun = airlightIsDirectional(light);
  real cosTheta = sun ? dot(light.position, ray.direction) : -x / r;
  real3 value =
    airlightScattered(AIRLIGHT_MEDIA_OUT piece, point, cosTheta) * airlightTransmittanceOf(depth);
  return sun ? value : value * airlightFalloff(light, point, r);
}

// The integrand over v. `straight`: v is t, for lights at infinity, and for lights at a place on
// intervals so short that asinh() would give one number. Otherwise t - foot = h sinh v, which makes
// the peak near the light, of width h, as smooth as the tails: dt = r dv.
AIRLIGHT_FN real3 airlightPanelValue(AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light,
  AIRLIGHT_IN(AirlightRay) ray, AIRLIGHT_IN(AirlightPiece) piece, bool straight, real v)
{
  real tL = ray.range.x + ray.foot.tL;
  real h = ray.foot.h;
  real e = exp(straight ? real(0.0) : v);
  real x = straight ? v - tL : real(0.5) * h * (e - real(1.0) / e);
  real r = straight ? sqrt(h * h + x * x) : real(0.5) * h * (e + real(1.0) / e);
  real t = airlightIsDirectional(light) ? v : tL + x;
  return (straight ? real(1.0) : r) *
    airlightPhotometricShare(light, ray.origin + t * ray.direction) *
    airlightIntegrand(AIRLIGHT_MEDIA_OUT light, ray, piece, t, x, r);
}

// One panel by Gauss-Legendre quadrature; `errorEstimate` is how much it may be wrong by. In
// surfaces, where the way to the light can change at a stroke, it includes what lies between the
// panel's ends and its outermost nodes, where the integrand at the ends is not the nodes'
// polynomial, if `checksEnds`. The ends are in the loop of the nodes: see airlightIntegrand().
AIRLIGHT_FN real3 airlightPanel(AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light,
  AIRLIGHT_IN(AirlightRay) ray, AIRLIGHT_IN(AirlightPiece) piece, bool straight, real v0, real v1,
  bool checksEnds, AIRLIGHT_OUT(real3) errorEstimate)
{
  real3 sum = real3(real(0.0));
  real3 even = real3(real(0.0));
  real3 odd = real3(real(0.0));
#if AIRLIGHT_CHECK_ENDS
  real3 low = real3(real(0.0)); // the nodes' polynomial at the ends
  real3 high = real3(real(0.0));
  real3 gap = real3(real(0.0)); // from the integrand there
#endif
  int ends = checksEnds ? 2 * AIRLIGHT_CHECK_ENDS : 0;
  for (int k = 0; k < AIRLIGHT_ROLLED(AIRLIGHT_GAUSS_COUNT + ends); k++)
  {
    bool above = k % 2 == 0;
    bool isEnd = AIRLIGHT_CHECK_ENDS == 1 && k >= AIRLIGHT_GAUSS_COUNT;
    real2 node = isEnd ? real2(real(1.0), real(0.0)) : airlightGaussNode(k / 2);
    real share = real(0.5) + (above ? real(0.5) : real(-0.5)) * node.x;
    real3 value =
      airlightPanelValue(AIRLIGHT_MEDIA_OUT light, ray, piece, straight, v0 + share * (v1 - v0));
#if AIRLIGHT_CHECK_ENDS
    gap += isEnd ? abs(value - (above ? high : low)) : real3(real(0.0));
#endif
    // Chosen and not multiplied by 0: at an end it may be infinite.
    value = isEnd ? real3(real(0.0)) : value;
    sum += node.y * value;
    real2 rough = airlightRoughWeight(k / 2);
    even += rough.x * value;
    odd += (above ? rough.y : -rough.y) * value;
#if AIRLIGHT_CHECK_ENDS
    real2 end = airlightEndWeight(k / 2);
    low += (above ? end.y : end.x) * value;
    high += (above ? end.x : end.y) * value;
#endif
  }
  errorEstimate = airlightRough(even, odd);
#if AIRLIGHT_CHECK_ENDS
  errorEstimate += real(AIRLIGHT_GAUSS_GAP) * gap;
#endif
  errorEstimate *= real(0.5) * (v1 - v0);
  return real(0.5) * (v1 - v0) * sum;
}

AIRLIGHT_FN real airlightAsinh(real x)
{
  real a = log(abs(x) + sqrt(x * x + real(1.0)));
  return x < real(0.0) ? -a : a;
}

// How many panels a piece takes: `scale` of the variable makes one panel.
AIRLIGHT_FN int airlightPanelCount(real length, real scale)
{
  return int(clamp(length / scale, real(0.0), real(60.0))) + 1;
}
