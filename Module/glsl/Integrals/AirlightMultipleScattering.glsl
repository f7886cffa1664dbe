// Light that was scattered more than once, of point lamps in one medium: along a ray, and where it
// meets a surface. By the source function of the unbounded medium (AirlightSourceFunction.glsl),
// with a factor for the faces of the medium's region. In fog that falls with height, the medium is
// that of the mean density between lamp and point, and its face is so far above as the fog there is
// deep.

// Light that a ray loses beyond so many optical lengths is left out.
#define AIRLIGHT_MULTIPLE_DEPTH 8.0
// Nodes that reach to where a channel ends which fades so much less serve all.
#define AIRLIGHT_MULTIPLE_APART 5.0

// Gauss-Legendre nodes on [-1, 1], the positive half of twelve, as (position, weight).
AIRLIGHT_FN real2 airlightMultipleNode(int k)
{
  if (k == 0)
    return real2(0.12523340851146892, 0.24914704581340279);
  if (k == 1)
    return real2(0.36783149899818019, 0.23349253653835481);
  if (k == 2)
    return real2(0.58731795428661745, 0.20316742672306592);
  if (k == 3)
    return real2(0.76990267419430469, 0.16007832854334623);
  if (k == 4)
    return real2(0.90411725637047486, 0.10693932599531843);
  return real2(0.98156063424671925, 0.047175336386511827);
}

// What is left of the source function at a point by one face of the region, behind which is a
// vacuum: the image of the lamp in the face, as the boundary condition of diffusion asks, as a
// factor. r, image: optical distances of the point from the lamp and from its image.
AIRLIGHT_FN AirlightMultipleSpectrum airlightFaceFactor(
  AIRLIGHT_MULTIPLE_IN AirlightMultipleSpectrum r, AirlightMultipleSpectrum image)
{
  AirlightMultipleSpectrum kappa = AIRLIGHT_MULTIPLE_SPECTRUM(airlightMultiple.kappa);
  image = max(image, AirlightMultipleSpectrum(real(1e-6)));
  // 1 + (gain - loss)/(gain + loss) exp(-kappa (image - r)) r/image, gain = kappa + 1/image.
  AirlightMultipleSpectrum gain = kappa * image + AirlightMultipleSpectrum(real(1.0));
  AirlightMultipleSpectrum loss = AIRLIGHT_MULTIPLE_SPECTRUM(airlightMultiple.loss) * image;
  AirlightMultipleSpectrum share = min(gain - loss, AirlightMultipleSpectrum(real(0.0))) * r /
    ((gain + loss) * image) * exp(kappa * (r - image));
  return max(AirlightMultipleSpectrum(real(1.0)) + share, AirlightMultipleSpectrum(real(0.0)));
}

// The optical distance from the lamp's image in a face, from which the point and the lamp are so
// far away.
AIRLIGHT_FN AirlightMultipleSpectrum airlightImageDistance(
  AirlightMultipleSpectrum sigmaT, real r, real point, real lamp)
{
  return sigmaT * sqrt(r * r + real(4.0) * max(point, real(0.0)) * max(lamp, real(0.0)));
}

// Of all faces of the medium's region. A curved face counts as the plane that touches it where the
// point is nearest.
AIRLIGHT_FN AirlightMultipleSpectrum airlightRegionFactor(
  AIRLIGHT_MULTIPLE_IN AIRLIGHT_IN(AirlightMedium) medium, real3 point, real3 lamp, real r)
{
  AirlightMultipleSpectrum factor = AirlightMultipleSpectrum(real(1.0));
  AirlightMultipleSpectrum sigmaT = AIRLIGHT_MULTIPLE_SPECTRUM(medium.sigmaT);
  AirlightMultipleSpectrum optical = sigmaT * r;
  if (AIRLIGHT_REGION_KIND(medium.region) == AIRLIGHT_REGION_BOX)
  {
    for (int axis = 0; axis < 3; axis++)
    {
      factor *= airlightFaceFactor(AIRLIGHT_MULTIPLE_OUT optical,
        airlightImageDistance(sigmaT, r, point[axis] - medium.region.boxMin[axis],
          lamp[axis] - medium.region.boxMin[axis]));
      factor *= airlightFaceFactor(AIRLIGHT_MULTIPLE_OUT optical,
        airlightImageDistance(sigmaT, r, medium.region.boxMax[axis] - point[axis],
          medium.region.boxMax[axis] - lamp[axis]));
    }
  }
  else if (AIRLIGHT_REGION_KIND(medium.region) == AIRLIGHT_REGION_SPHERE)
  {
    real3 outward = point - medium.region.centre;
    real away = max(length(outward), real(1e-6) * medium.region.radius);
    factor = airlightFaceFactor(AIRLIGHT_MULTIPLE_OUT optical,
      airlightImageDistance(sigmaT, r, medium.region.radius - away,
        medium.region.radius - dot(lamp - medium.region.centre, outward) / away));
  }
  return factor;
}

// The integral of density between a lamp and a point r away, which is at least the lamp's own
// distance.
AIRLIGHT_FN real airlightLampColumn(
  AIRLIGHT_IN(AirlightMedium) medium, real3 point, real3 lamp, real r)
{
  return AIRLIGHT_DENSITY_KIND(medium) == AIRLIGHT_DENSITY_HEIGHT
    ? min(airlightInsideDepth(medium, lamp, (point - lamp) / r, real(0.0), r), real(AIRLIGHT_FAR))
    : r;
}

// Of fog that falls with height: the lamp's image behind a face that is, in optical lengths, as far
// from lamp and point as the fog above them is deep.
AIRLIGHT_FN AirlightMultipleSpectrum airlightFogFactor(AIRLIGHT_MULTIPLE_IN
  AIRLIGHT_IN(AirlightMedium) medium, real3 point, real3 lamp, AirlightMultipleSpectrum optical)
{
  const AirlightMultipleSpectrum far = AirlightMultipleSpectrum(real(1e4)); // squares are finite
  AirlightMultipleSpectrum depth =
    AIRLIGHT_MULTIPLE_SPECTRUM(medium.sigmaT) / medium.inverseScaleHeight;
  AirlightMultipleSpectrum above = min(depth * airlightDensity(medium, point), far);
  AirlightMultipleSpectrum aboveLamp = min(depth * airlightDensity(medium, lamp), far);
  optical = min(optical, far);
  return airlightFaceFactor(AIRLIGHT_MULTIPLE_OUT optical,
    sqrt(optical * optical + real(4.0) * above * aboveLamp));
}

// The part of a ray in fog that falls with height on which light is scattered, but for a small
// share of its optical depth at both ends. sigma: the extinction of a channel at density 1.
AIRLIGHT_FN real2 airlightFogRange(
  AIRLIGHT_IN(AirlightMedium) medium, real3 origin, real3 direction, real2 range, real sigma)
{
  const real share = real(0.002);
  real3 start = origin + range.x * direction;
  real depth = sigma * airlightInsideDepth(medium, origin, direction, range.x, range.y);
  real begin =
    airlightFadingLength(medium, start, direction, sigma, share * min(depth, real(1.0)));
  real end = airlightFadingLength(medium, start, direction, sigma,
    min(real(AIRLIGHT_MULTIPLE_DEPTH), (real(1.0) - share) * depth));
  return min(range.x + real2(begin, end), real2(range.y));
}

// How far from the ray's entry a channel still counts: up to where the depth plus what the source
// has fallen by exceeds the least of them by AIRLIGHT_MULTIPLE_DEPTH. sigma, fall: its extinction
// and how fast its source falls, per length. tL: of the lamp's foot from the entry; h: its distance
// from the ray.
AIRLIGHT_FN real airlightMultipleReach(real sigma, real fall, real tL, real h)
{
  // t + k r(t) = least + depth, with t, tL and h as optical lengths.
  real k = fall / sigma;
  const real far = real(1e8); // squares are finite in single precision
  real foot = clamp(sigma * tL, -far, far);
  real aside = min(sigma * h, far);
  real atEye = k * sqrt(foot * foot + aside * aside);
  real least = foot > real(0.0) ? min(atEye, foot + k * aside) : atEye;
  real goal = least + real(AIRLIGHT_MULTIPLE_DEPTH);
  real a = real(1.0) - k * k;
  real b = goal - k * k * foot;
  real c = goal * goal - k * k * (foot * foot + aside * aside);
  return c / (b + sqrt(max(b * b - a * c, real(0.0)))) / sigma;
}

// A node: where the ray is e = exp(v) and 1/e, with t - foot = h sinh v.
AIRLIGHT_FN void airlightAddMultiple(AIRLIGHT_MULTIPLE_IN AIRLIGHT_IN(AirlightMedium) medium,
  real3 origin, real3 direction, real4 lamp, real2 e, real weight, real foot, real start, real h,
  AIRLIGHT_INOUT(AirlightMultipleSpectrum) several, AIRLIGHT_INOUT(AirlightMultipleSpectrum) once)
{
  real x = real(0.5) * h * (e.x - e.y);
  real r = real(0.5) * h * (e.x + e.y);
  real mu = (e.y - e.x) / (e.x + e.y);
  real depth = max(foot + x - start, real(0.0));
  real3 point = origin + (foot + x) * direction;
  real column = airlightLampColumn(medium, point, real3(lamp), r);
  AirlightMultipleSpectrum sigmaT = AIRLIGHT_MULTIPLE_SPECTRUM(medium.sigmaT);
  AirlightMultipleSpectrum optical = sigmaT * column;
  real mean = real(1.0);
  if (AIRLIGHT_DENSITY_KIND(medium) == AIRLIGHT_DENSITY_HEIGHT)
  {
    depth = airlightInsideDepth(medium, origin, direction, start, max(foot + x, start));
    weight *= airlightDensity(medium, point);
    mean = column / r;
  }
  AirlightMultipleSpectrum logarithm = airlightSourceLogarithm(AIRLIGHT_MULTIPLE_OUT
    airlightSourceX(optical), airlightSourceY(airlightMultiple.lobe, mu));
  AirlightMultipleSpectrum source =
    exp(logarithm - AIRLIGHT_MULTIPLE_SPECTRUM(airlightMultiple.kappa) * optical - sigmaT * depth);
  source *= AIRLIGHT_DENSITY_KIND(medium) == AIRLIGHT_DENSITY_HEIGHT
    ? airlightFogFactor(AIRLIGHT_MULTIPLE_OUT medium, point, real3(lamp), optical)
    : airlightRegionFactor(AIRLIGHT_MULTIPLE_OUT medium, point, real3(lamp), r);
  several += weight * mean * source;
  once += weight * airlightPhase(medium.phase, mu) / r * exp(-sigmaT * (depth + column));
}

AIRLIGHT_FN AirlightMultipleRay airlightMultipleUpTo(
  AIRLIGHT_MULTIPLE_IN AIRLIGHT_IN(AirlightMedium) medium, real3 origin, real3 direction,
  real2 range, real4 lamp, real foot, real h, real sigma, real fall)
{
  AirlightMultipleRay result;
  result.several = real3(real(0.0));
  result.once = real3(real(0.0));
  real2 part = AIRLIGHT_DENSITY_KIND(medium) == AIRLIGHT_DENSITY_HEIGHT
    ? airlightFogRange(medium, origin, direction, range, sigma)
    : real2(range.x,
        min(range.y, range.x + airlightMultipleReach(sigma, fall, foot - range.x, h)));
  // With t - foot = h sinh v, dt = r dv.
  const real far = real(1e18); // likewise
  real from = airlightAsinh(clamp((part.x - foot) / h, -far, far));
  real reach = real(0.5) * (airlightAsinh(clamp((part.y - foot) / h, -far, far)) - from);
  if (reach <= real(0.0))
  {
    return result;
  }
  // Of the nodes, two lie as far from the middle.
  real middle = exp(from + reach);
  real inverse = real(1.0) / middle;
  AirlightMultipleSpectrum several = AirlightMultipleSpectrum(real(0.0));
  AirlightMultipleSpectrum once = AirlightMultipleSpectrum(real(0.0));
  for (int k = 0; k < AIRLIGHT_ROLLED(AIRLIGHT_MULTIPLE_NODES / 2); k++)
  {
    real2 node = airlightMultipleNode(k);
    real aside = exp(reach * node.x);
    real back = real(1.0) / aside;
    airlightAddMultiple(AIRLIGHT_MULTIPLE_OUT medium, origin, direction, lamp,
      real2(middle * aside, inverse * back), reach * node.y, foot, range.x, h, several, once);
    airlightAddMultiple(AIRLIGHT_MULTIPLE_OUT medium, origin, direction, lamp,
      real2(middle * back, inverse * aside), reach * node.y, foot, range.x, h, several, once);
  }
  // 0 before infinite.
  result.several = real3(several) * medium.sigmaT * medium.sigmaT;
  result.once = real3(once) * real(0.079577471545947668) * medium.sigmaS;
  return result;
}

// The nodes serve all channels where these fade alike, within AIRLIGHT_MULTIPLE_APART; else each
// has its own.
AIRLIGHT_FN AirlightMultipleRay airlightMultipleOfLamp(
  AIRLIGHT_MULTIPLE_IN AIRLIGHT_IN(AirlightMedium) medium, real3 origin, real3 direction,
  real2 range, real4 lamp)
{
  AirlightMultipleRay sum;
  sum.several = real3(real(0.0));
  sum.once = real3(real(0.0));
  real3 toLamp = real3(lamp) - origin;
  real foot = dot(toLamp, direction);
  real h = max(length(cross(toLamp, direction)), lamp.w);
  real thin = real(AIRLIGHT_FAR);
  real slow = real(AIRLIGHT_FAR);
  real dense = real(0.0);
#if defined(AIRLIGHT_MULTIPLE_GREY) && AIRLIGHT_MULTIPLE_GREY
  thin = medium.sigmaT.x;
  slow = thin * airlightMultiple.kappa.x;
  if (thin > real(0.0))
  {
    sum = airlightMultipleUpTo(
      AIRLIGHT_MULTIPLE_OUT medium, origin, direction, range, lamp, foot, h, thin, slow);
  }
#else
  for (int channel = 0; channel < 3; channel++)
  {
    real sigma = medium.sigmaT[channel];
    thin = sigma > real(0.0) ? min(thin, sigma) : thin;
    slow = sigma > real(0.0) ? min(slow, sigma * airlightMultiple.kappa[channel]) : slow;
    dense = max(dense, sigma);
  }
  bool together = dense <= real(AIRLIGHT_MULTIPLE_APART) * thin;
  for (int channel = 0; channel < (together ? 1 : 3); channel++)
  {
    real sigma = together ? thin : medium.sigmaT[channel];
    if (sigma > real(0.0))
    {
      AirlightMultipleRay part = airlightMultipleUpTo(AIRLIGHT_MULTIPLE_OUT medium, origin,
        direction, range, lamp, foot, h, sigma,
        together ? slow : sigma * airlightMultiple.kappa[channel]);
      real3 mask = real3(together || channel == 0 ? real(1.0) : real(0.0),
        together || channel == 1 ? real(1.0) : real(0.0),
        together || channel == 2 ? real(1.0) : real(0.0));
      sum.several += mask * part.several;
      sum.once += mask * part.once;
    }
  }
#endif
  return sum;
}

// Of light i on [0, l] of a ray of unit direction: the lamps come first, then the suns.
AIRLIGHT_FN AirlightMultipleRay airlightMultipleAlong(
  AIRLIGHT_MULTIPLE_IN AIRLIGHT_MEDIA_IN int i, real3 origin, real3 direction, real l)
{
  real2 range = airlightRegionRange(airlightMedia.item[0].region, origin, direction, l);
  int lamps = AIRLIGHT_MULTIPLE_LIGHTS - AIRLIGHT_MULTIPLE_SUNS;
  if (i >= lamps)
  {
    return airlightMultipleOfSun(
      AIRLIGHT_MULTIPLE_OUT airlightMedia.item[0], origin, direction, range, i - lamps);
  }
  AirlightMultipleRay ray = airlightMultipleOfLamp(AIRLIGHT_MULTIPLE_OUT airlightMedia.item[0],
    origin, direction, range, airlightMultiple.lamp[i]);
  real4 power = airlightMultiple.power[i];
  if (AIRLIGHT_MULTIPLE_COLLISIONS)
  {
    // Of light that collided once before, what is scattered once is the second time.
    ray.several += power.w * ray.once;
    ray.once *= real(1.0) - power.w;
  }
  ray.several *= real3(power);
  ray.once *= real3(power);
  return ray;
}

// Of all light that collided once before, which is no single light's, as if nothing cast shadows.
AIRLIGHT_FN real3 airlightMultipleOfCollisions(
  AIRLIGHT_MULTIPLE_IN AIRLIGHT_MEDIA_IN real3 origin, real3 direction, real l)
{
  real3 sum = real3(real(0.0));
  for (int i = 0; i < AIRLIGHT_MULTIPLE_LIGHTS - AIRLIGHT_MULTIPLE_SUNS; i++)
  {
    if (airlightMultiple.power[i].w > real(0.5))
    {
      sum += airlightMultipleAlong(
        AIRLIGHT_MULTIPLE_OUT AIRLIGHT_MEDIA_OUT i, origin, direction, l).several;
    }
  }
  return sum;
}

// What casters leave of the light of a lamp that was scattered more than once, on a ray on which
// they leave `once` of the other: that share, and of the rest some that gets around them. How much
// is a rule, see Documentation/accuracy.md; media that scatter forward keep light in its beam. If
// several draws share a ray, one of them has the latter.
AIRLIGHT_FN real3 airlightMultipleShaded(
  AIRLIGHT_MULTIPLE_IN AIRLIGHT_IN(AirlightMultipleRay) ray, real3 once, bool getsAround)
{
  const real least = real(1e-30);
  real around = real(0.25) * (real(1.0) - airlightMultiple.lobe);
  real3 share = clamp(once / max(ray.once, real3(least)), real3(real(0.0)), real3(real(1.0)));
  share = mix(share, real3(real(1.0)), lessThan(ray.once, real3(least)));
  return ray.several *
    ((real(1.0) - around) * share + real3(getsAround ? around : real(0.0)));
}

// The irradiance that light which was scattered at least once brings to a surface of this unit
// normal: a quarter of the fluence, and half of the flux against the normal.
AIRLIGHT_FN real3 airlightMultipleIrradiance(
  AIRLIGHT_MULTIPLE_IN AIRLIGHT_MEDIA_IN real3 point, real3 normal)
{
  real3 sum = real3(real(0.0));
  AirlightMultipleSpectrum sigmaT = AIRLIGHT_MULTIPLE_SPECTRUM(airlightMedia.item[0].sigmaT);
  // Surfaces that lie in a face of the region are inside.
  real3 inward = real(1e-4) * (airlightRegionMiddle(airlightMedia.item[0].region) - point);
  if (!airlightHolds(airlightMedia.item[0].region, point + inward))
  {
    return sum;
  }
  int lamps = AIRLIGHT_MULTIPLE_LIGHTS - AIRLIGHT_MULTIPLE_SUNS;
  for (int i = 0; i < AIRLIGHT_MULTIPLE_SUNS; i++)
  {
    sum += airlightSunIrradiance(AIRLIGHT_MULTIPLE_OUT airlightMedia.item[0], point, normal, i);
  }
  for (int i = 0; i < lamps; i++)
  {
    real3 away = point - real3(airlightMultiple.lamp[i]);
    real r = max(length(away), airlightMultiple.lamp[i].w);
    real column =
      airlightLampColumn(airlightMedia.item[0], point, real3(airlightMultiple.lamp[i]), r);
    AirlightMultipleSpectrum optical = sigmaT * column;
    AirlightMultipleSpectrum x = airlightSourceX(optical);
    AirlightMultipleSpectrum fall = AIRLIGHT_MULTIPLE_SPECTRUM(airlightMultiple.kappa) * optical;
    AirlightMultipleSpectrum fluence =
      exp(airlightMomentLogarithm(AIRLIGHT_MULTIPLE_OUT 0, x) - fall);
    AirlightMultipleSpectrum flux =
      exp(airlightMomentLogarithm(AIRLIGHT_MULTIPLE_OUT AIRLIGHT_SOURCE_ROWS, x) - fall);
    AirlightMultipleSpectrum share =
      real(0.25) * fluence - real(0.5) * dot(away, normal) / r * flux;
    if (AIRLIGHT_MULTIPLE_COLLISIONS && airlightMultiple.power[i].w > real(0.5))
    {
      // And of light that collided once before, what comes directly.
      real direct = real(0.079577471545947668) * max(-dot(away, normal), real(0.0)) / (r * r * r);
      sum += real3(airlightMultiple.power[i]) * (direct * exp(-optical));
    }
    // The moments are of optical lengths: a square of them is per area, and 1/r is of them, too.
    AirlightMultipleSpectrum area = sigmaT / r;
    if (AIRLIGHT_DENSITY_KIND(airlightMedia.item[0]) == AIRLIGHT_DENSITY_HEIGHT)
    {
      area *= column / r * airlightFogFactor(AIRLIGHT_MULTIPLE_OUT airlightMedia.item[0], point,
        real3(airlightMultiple.lamp[i]), optical);
    }
    sum += real3(airlightMultiple.power[i]) *
      (max(share, AirlightMultipleSpectrum(real(0.0))) * area);
  }
  return sum;
}
