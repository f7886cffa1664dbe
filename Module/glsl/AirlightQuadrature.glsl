// Airlight by quadrature, for what has no closed form: other attenuations than the inverse square,
// spots with an exponent, lights outside the region, varying density, several media.

// What medium i scatters of a light at x from the ray's start, without the light's way.
AIRLIGHT_FN real3 airlightScatteredBy(AIRLIGHT_IN(AirlightMedia) media, int i, real3 origin,
  real3 direction, real t, real cosTheta)
{
  real2 range = airlightRegionRange(media.item[i].region, origin, direction, real(AIRLIGHT_FAR));
  if (t < range.x || t > range.y)
  {
    return real3(real(0.0));
  }
  return media.item[i].sigmaS * airlightPhase(media.item[i].phase, cosTheta) *
    airlightDensity(media.item[i], origin + t * direction);
}

AIRLIGHT_FN real3 airlightScattered(AIRLIGHT_IN(AirlightMedia) media, real3 origin,
  real3 direction, real t, real cosTheta)
{
  real3 sum = real3(real(0.0));
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    sum += airlightScatteredBy(media, i, origin, direction, t, cosTheta);
  }
  return sum;
}

// Fall-off and cone of a light at a place, in the direction of a point r away.
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

// The integrand for a light at a place: x from the light's foot, r from the light.
AIRLIGHT_FN real3 airlightPointIntegrand(AIRLIGHT_IN(AirlightMedia) media,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray, real x, real r)
{
  real t = ray.range.x + ray.foot.tL + x;
  real3 point = ray.origin + t * ray.direction;
  real3 depth = airlightDepth(media, ray.origin, ray.direction, t) +
    airlightDepthBetween(media, point, light.position);
  return airlightScattered(media, ray.origin, ray.direction, t, -x / r) * exp(-depth) *
    airlightFalloff(light, point, r);
}

// The integrand for a light at infinity.
AIRLIGHT_FN real3 airlightSunIntegrand(AIRLIGHT_IN(AirlightMedia) media,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray, real t)
{
  real3 point = ray.origin + t * ray.direction;
  real3 depth = airlightDepth(media, ray.origin, ray.direction, t) +
    airlightSunDepths(media, point, light.position);
  return airlightScattered(
           media, ray.origin, ray.direction, t, dot(light.position, ray.direction)) *
    exp(-depth);
}

// Gauss-Legendre quadrature on [v0, v1] after x = h sinh v, which makes the peak near the light,
// of width h, as smooth as the tails: dx = r dv.
AIRLIGHT_FN real3 airlightPointPanel(AIRLIGHT_IN(AirlightMedia) media,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray, real v0, real v1)
{
  real middle = real(0.5) * (v0 + v1);
  real reach = real(0.5) * (v1 - v0);
  real3 sum = real3(real(0.0));
  for (int k = 0; k < AIRLIGHT_GAUSS_COUNT; k++)
  {
    real2 node = airlightGaussNode(k / 2);
    real e = exp(middle + (k % 2 == 0 ? reach : -reach) * node.x);
    real r = real(0.5) * ray.foot.h * (e + real(1.0) / e);
    real x = real(0.5) * ray.foot.h * (e - real(1.0) / e);
    sum += node.y * r * airlightPointIntegrand(media, light, ray, x, r);
  }
  return reach * sum;
}

// Gauss-Legendre quadrature on [t0, t1] as it is: for lights at infinity, and for lights at a place
// on intervals so short that v0 and v1 would be one number.
AIRLIGHT_FN real3 airlightStraightPanel(AIRLIGHT_IN(AirlightMedia) media,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
  real3 sum = real3(real(0.0));
  for (int k = 0; k < AIRLIGHT_GAUSS_COUNT; k++)
  {
    real2 node = airlightGaussNode(k / 2);
    real share = real(0.5) + (k % 2 == 0 ? real(0.5) : real(-0.5)) * node.x;
    real t = t0 + share * (t1 - t0);
    if (airlightIsDirectional(light))
    {
      sum += node.y * airlightSunIntegrand(media, light, ray, t);
    }
    else
    {
      real x = t - ray.range.x - ray.foot.tL;
      real r = sqrt(ray.foot.h * ray.foot.h + x * x);
      sum += node.y * airlightPointIntegrand(media, light, ray, x, r);
    }
  }
  return real(0.5) * (t1 - t0) * sum;
}

AIRLIGHT_FN real airlightAsinh(real x)
{
  real a = log(abs(x) + sqrt(x * x + real(1.0)));
  return x < real(0.0) ? -a : a;
}

// Extinction, at density 1, of the channel that fades least among those that fade: the far end of
// what matters depends on it.
AIRLIGHT_FN real airlightLeastExtinction(AIRLIGHT_IN(AirlightMedium) medium)
{
  // A clear channel scatters nothing and has no say.
  real x = medium.sigmaT.x > real(0.0) ? medium.sigmaT.x : real(AIRLIGHT_FAR);
  real y = medium.sigmaT.y > real(0.0) ? medium.sigmaT.y : real(AIRLIGHT_FAR);
  real z = medium.sigmaT.z > real(0.0) ? medium.sigmaT.z : real(AIRLIGHT_FAR);
  return min(x, min(y, z));
}

// The far end of what matters of [t0, t1] after the next place where a medium begins or ends:
// x is that place, within t1; y is where the light there has faded, within x.
AIRLIGHT_FN real2 airlightNextPiece(
  AIRLIGHT_IN(AirlightMedia) media, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
#ifdef AIRLIGHT_DOUBLE
  const real depth = real(40.0);
#else
  const real depth = real(20.0);
#endif
  real end = t1;
  real least = real(AIRLIGHT_FAR);
  // Ends closer than this are one end.
  real skip = t0 + real(1e-6) * abs(t0);
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    real2 range = airlightRegionRange(
      media.item[i].region, ray.origin, ray.direction, real(AIRLIGHT_FAR));
    if (range.y > range.x)
    {
      end = range.x > skip ? min(end, range.x) : end;
      end = range.y > skip ? min(end, range.y) : end;
      if (range.x <= skip && range.y > skip)
      {
        // Where density falls with height, light fades over at least one scale height.
        real extinction = airlightLeastExtinction(media.item[i]) *
          (media.item[i].density == AIRLIGHT_DENSITY_UNIFORM
              ? real(1.0)
              : airlightDensity(media.item[i], ray.origin + t0 * ray.direction));
        least = min(least, extinction);
      }
    }
  }
  return real2(end, min(end, t0 + depth / max(least, real(1e-15))));
}

// How many panels a piece takes: `scale` of the variable makes one panel.
AIRLIGHT_FN int airlightPanelCount(real length, real scale)
{
  return int(clamp(length / scale, real(0.0), real(60.0))) + 1;
}

// Whether the light's way may leave a region through one face or another, which gives the integrand
// kinks and boundary layers.
AIRLIGHT_FN bool airlightHasFaces(AIRLIGHT_IN(AirlightMedia) media)
{
  bool faces = false;
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    faces = faces || media.item[i].region.kind != AIRLIGHT_REGION_UNBOUNDED;
  }
  return faces;
}

// One piece without ends of media in it.
AIRLIGHT_FN real3 airlightQuadraturePiece(AIRLIGHT_IN(AirlightMedia) media,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
  real x0 = t0 - ray.range.x - ray.foot.tL;
  real x1 = t1 - ray.range.x - ray.foot.tL;
  bool straight = airlightIsDirectional(light) ||
    x1 - x0 < real(0.05) * max(abs(x0), ray.foot.h);
  real v0 = straight ? t0 : airlightAsinh(x0 / ray.foot.h);
  real v1 = straight ? t1 : airlightAsinh(x1 / ray.foot.h);
  bool faces = airlightHasFaces(media);
  int panels = airlightIsDirectional(light) ? 12 : (faces ? 4 : 1);
  if (!straight)
  {
    panels = airlightPanelCount(v1 - v0, faces ? real(0.2) : real(1.0));
  }
  real3 sum = real3(real(0.0));
  for (int i = 0; i < panels; i++)
  {
    real a = v0 + (v1 - v0) * real(i) / real(panels);
    real b = v0 + (v1 - v0) * real(i + 1) / real(panels);
    if (straight)
    {
      sum += airlightStraightPanel(media, light, ray, a, b);
    }
    else
    {
      sum += airlightPointPanel(media, light, ray, a, b);
    }
  }
  return sum;
}

// The integral over [t0, t1], sigmaS included.
AIRLIGHT_FN real3 airlightQuadrature(AIRLIGHT_IN(AirlightMedia) media,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
  real3 sum = real3(real(0.0));
  // Every medium has two ends.
  for (int i = 0; i <= 2 * AIRLIGHT_MEDIUM_COUNT && t0 < t1; i++)
  {
    real2 piece = airlightNextPiece(media, ray, t0, t1);
    sum += airlightQuadraturePiece(media, light, ray, t0, piece.y);
    t0 = piece.x;
  }
  return sum;
}
