// All media of a scene. Where they overlap, their coefficients add.

struct AirlightMedia
{
  AirlightMedium item[AIRLIGHT_MAX_MEDIA];
  int count;
};

// Where the number of media is known when a shader is compiled, its loops unroll.
#ifndef AIRLIGHT_MEDIUM_COUNT
#define AIRLIGHT_MEDIUM_COUNT media.count
#endif

// Optical depth of the straight way [0, l] of a ray, per channel.
AIRLIGHT_FN real3 airlightDepth(
  AIRLIGHT_IN(AirlightMedia) media, real3 origin, real3 direction, real l)
{
  real3 depth = real3(real(0.0));
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    depth +=
      media.item[i].sigmaT * airlightPathDepth(media.item[i], origin, direction, l);
  }
  return depth;
}

// Optical depth between two points.
AIRLIGHT_FN real3 airlightDepthBetween(AIRLIGHT_IN(AirlightMedia) media, real3 a, real3 b)
{
  real l = length(b - a);
  return l > real(0.0) ? airlightDepth(media, a, (b - a) / l, l) : real3(real(0.0));
}

// Optical depth on the way to a light at infinity.
AIRLIGHT_FN real3 airlightSunDepths(
  AIRLIGHT_IN(AirlightMedia) media, real3 point, real3 toLight)
{
  real3 depth = real3(real(0.0));
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    depth += media.item[i].sigmaT * airlightSunDepth(media.item[i], point, toLight);
  }
  return depth;
}

// Ambient radiance that medium i scatters into a ray on [0, l], per unit of what it would be
// without the others: sigmaS integral of density exp(-depth). Gauss-Legendre where others overlap
// it; exact where it is alone.
AIRLIGHT_FN real3 airlightAmbientOf(AIRLIGHT_IN(AirlightMedia) media, int i, real3 origin,
  real3 direction, real l)
{
  real2 range = airlightRegionRange(media.item[i].region, origin, direction, l);
  real3 sigmaT = media.item[i].sigmaT;
  if (AIRLIGHT_MEDIUM_COUNT == 1)
  {
    real depth = airlightInsideDepth(media.item[i], origin, direction, range.x, range.y);
    return real3(airlightOpticalLength(sigmaT.x, depth), airlightOpticalLength(sigmaT.y, depth),
      airlightOpticalLength(sigmaT.z, depth));
  }
  // In the share of the medium's own depth, which is bounded where the range is not.
  real3 sum = real3(real(0.0));
  real strongest = max(sigmaT.x, max(sigmaT.y, sigmaT.z));
  real to = range.x + min(range.y - range.x, real(60.0) / max(strongest, real(1e-15)));
  const int panels = 6;
  for (int k = 0; k < panels * AIRLIGHT_GAUSS_COUNT; k++)
  {
    real2 node = airlightGaussNode((k % AIRLIGHT_GAUSS_COUNT) / 2);
    real position = k % 2 == 0 ? node.x : -node.x;
    real share = (real(k / AIRLIGHT_GAUSS_COUNT) + real(0.5) + real(0.5) * position) / real(panels);
    // Squared: most of what matters is near the eye.
    real t = range.x + (to - range.x) * share * share;
    sum += node.y * share * airlightDensity(media.item[i], origin + t * direction) *
      exp(-airlightDepth(media, origin, direction, t));
  }
  return sum * (to - range.x) / real(panels);
}

AIRLIGHT_FN real3 airlightAmbient(
  AIRLIGHT_IN(AirlightMedia) media, real3 origin, real3 direction, real l)
{
  real3 sum = real3(real(0.0));
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    // Without ambient radiance there is nothing to integrate.
    if (dot(media.item[i].ambient, real3(real(1.0))) > real(0.0))
    {
      sum += media.item[i].sigmaS * media.item[i].ambient *
        airlightAmbientOf(media, i, origin, direction, l);
    }
  }
  return sum;
}
