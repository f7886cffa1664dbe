// What a light scatters into a ray, for every kind of light. A ray's lit intervals are summed one
// by one:
//
//   real3 tail = airlightTail3(medium, light, ray, entry);      // once per boundary
//   sum += airlightInterval3(medium, light, ray, entry, tail, exit, airlightTail3(..., exit));

#define AIRLIGHT_POINT_CLOSED 0     // inverse square, inside the medium's region: closed form
#define AIRLIGHT_POINT_QUADRATURE 1 // other attenuation, or outside the region
#define AIRLIGHT_DIRECTIONAL 2      // unbounded medium: arrives unattenuated

struct AirlightLight
{
  int kind;
  real3 position;    // directional: unit vector towards the light
  real3 intensity;   // radiant intensity; directional: irradiance
  real3 attenuation; // (a, b, c) of 1/(a + b r + c r^2)
  real radius;       // least distance to the ray, above 0
};

struct AirlightRay
{
  real3 origin;
  real3 direction;
  real2 range;       // inside the medium, as distances from the origin
  AirlightFoot foot; // of the light, from where the ray enters the medium
};

// The foot of the perpendicular from a point to the ray.
AIRLIGHT_FN AirlightRay airlightRay(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightLight) light, real3 origin, real3 direction, real t1)
{
  AirlightRay ray;
  ray.origin = origin;
  ray.direction = direction;
  ray.range = airlightRegionRange(medium.region, origin, direction, t1);
  real3 toLight = light.position - origin;
  ray.foot.tL = dot(toLight, direction) - ray.range.x;
  ray.foot.h = max(length(cross(toLight, direction)), light.radius);
  return ray;
}

// The integral from t to infinity per unit sigmaS I, for each channel; t from the ray's origin.
AIRLIGHT_FN real3 airlightTail3(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray, real t)
{
  if (light.kind != AIRLIGHT_POINT_CLOSED)
  {
    return real3(real(0.0));
  }
  real x = t - ray.range.x;
  real red = airlightTail(medium.phase, medium.sigmaT.x, ray.foot, x);
  if (airlightIsGrey(medium))
  {
    return real3(red);
  }
  return real3(red, airlightTail(medium.phase, medium.sigmaT.y, ray.foot, x),
    airlightTail(medium.phase, medium.sigmaT.z, ray.foot, x));
}

// The closed form's interval for each channel.
AIRLIGHT_FN real3 airlightClosedInterval(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightRay) ray, real t0, real3 tail0, real t1, real3 tail1)
{
  real x0 = t0 - ray.range.x;
  real x1 = t1 - ray.range.x;
  real red = airlightSegmentFromTails(
    medium.phase, medium.sigmaT.x, ray.foot, x0, tail0.x, x1, tail1.x);
  if (airlightIsGrey(medium))
  {
    return real3(red);
  }
  return real3(red,
    airlightSegmentFromTails(
      medium.phase, medium.sigmaT.y, ray.foot, x0, tail0.y, x1, tail1.y),
    airlightSegmentFromTails(
      medium.phase, medium.sigmaT.z, ray.foot, x0, tail0.z, x1, tail1.z));
}

// A directional light, unattenuated: one exponential.
AIRLIGHT_FN real3 airlightDirectionalInterval(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
  real l = t1 - t0;
  return airlightPhase(medium.phase, dot(-light.position, -ray.direction)) *
    exp(-medium.sigmaT * (t0 - ray.range.x)) *
    real3(airlightOpticalLength(medium.sigmaT.x, l), airlightOpticalLength(medium.sigmaT.y, l),
      airlightOpticalLength(medium.sigmaT.z, l));
}

// The integrand at distance x from the light's foot and r from the light, without sigmaS I.
AIRLIGHT_FN real3 airlightIntegrand(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray, real x, real r)
{
  real view = ray.foot.tL + x;
  real3 point = ray.origin + (ray.range.x + view) * ray.direction;
  real leg = medium.region.kind == AIRLIGHT_REGION_UNBOUNDED
    ? r
    : airlightInsideLength(medium.region, point, light.position);
  real fall = light.attenuation.x + r * (light.attenuation.y + r * light.attenuation.z);
  return exp(-medium.sigmaT * (view + leg)) * airlightPhase(medium.phase, -x / r) / fall;
}

// Gauss-Legendre quadrature on [v0, v1] after x = h sinh v, which makes the peak near the light,
// of width h, as smooth as the tails: dx = r dv.
AIRLIGHT_FN real3 airlightQuadraturePanel(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray, real v0, real v1)
{
  real middle = real(0.5) * (v0 + v1);
  real reach = real(0.5) * (v1 - v0);
  real3 sum = real3(real(0.0));
  for (int k = 0; k < AIRLIGHT_GAUSS_COUNT; k++)
  {
    real2 node = airlightGaussNode(k / 2);
    real v = middle + (k % 2 == 0 ? reach : -reach) * node.x;
    real e = exp(v);
    real r = real(0.5) * ray.foot.h * (e + real(1.0) / e);
    real x = real(0.5) * ray.foot.h * (e - real(1.0) / e);
    sum += node.y * r * airlightIntegrand(medium, light, ray, x, r);
  }
  return reach * sum;
}

// The same without substitution, for intervals so short that v0 and v1 would be one number.
AIRLIGHT_FN real3 airlightStraightPanel(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray, real x0, real x1)
{
  real3 sum = real3(real(0.0));
  for (int k = 0; k < AIRLIGHT_GAUSS_COUNT; k++)
  {
    real2 node = airlightGaussNode(k / 2);
    real share = real(0.5) + (k % 2 == 0 ? real(0.5) : real(-0.5)) * node.x;
    real x = x0 + share * (x1 - x0);
    real r = sqrt(ray.foot.h * ray.foot.h + x * x);
    sum += node.y * airlightIntegrand(medium, light, ray, x, r);
  }
  return real(0.5) * (x1 - x0) * sum;
}

AIRLIGHT_FN real airlightAsinh(real x)
{
  real a = log(abs(x) + sqrt(x * x + real(1.0)));
  return x < real(0.0) ? -a : a;
}

// The far end of what matters of [t0, t1]: beyond it the channel that fades least has faded.
AIRLIGHT_FN real airlightQuadratureEnd(AIRLIGHT_IN(AirlightMedium) medium, real t0, real t1)
{
#ifdef AIRLIGHT_DOUBLE
  const real depth = real(40.0);
#else
  const real depth = real(20.0);
#endif
  // A clear channel scatters nothing and has no say.
  real x = medium.sigmaT.x > real(0.0) ? medium.sigmaT.x : real(AIRLIGHT_FAR);
  real y = medium.sigmaT.y > real(0.0) ? medium.sigmaT.y : real(AIRLIGHT_FAR);
  real z = medium.sigmaT.z > real(0.0) ? medium.sigmaT.z : real(AIRLIGHT_FAR);
  return min(t1, t0 + depth / min(x, min(y, z)));
}

AIRLIGHT_FN real3 airlightQuadrature(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
  real x0 = t0 - ray.range.x - ray.foot.tL;
  real x1 = airlightQuadratureEnd(medium, t0, t1) - ray.range.x - ray.foot.tL;
  if (x1 - x0 < real(0.05) * max(abs(x0), ray.foot.h))
  {
    return airlightStraightPanel(medium, light, ray, x0, x1);
  }
  real v0 = airlightAsinh(x0 / ray.foot.h);
  real v1 = airlightAsinh(x1 / ray.foot.h);
  int panels = int(clamp((v1 - v0) / real(1.5), real(0.0), real(30.0))) + 1;
  real3 sum = real3(real(0.0));
  for (int i = 0; i < panels; i++)
  {
    real a = v0 + (v1 - v0) * real(i) / real(panels);
    real b = v0 + (v1 - v0) * real(i + 1) / real(panels);
    sum += airlightQuadraturePanel(medium, light, ray, a, b);
  }
  return sum;
}

// Radiance scattered into the ray on [t0, t1], which lies inside ray.range; tail0 and tail1 are
// the values of airlightTail3 at its ends.
AIRLIGHT_FN real3 airlightInterval3(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray, real t0, real3 tail0, real t1,
  real3 tail1)
{
  real3 integral;
  if (light.kind == AIRLIGHT_POINT_CLOSED)
  {
    integral = airlightClosedInterval(medium, ray, t0, tail0, t1, tail1);
  }
  else if (light.kind == AIRLIGHT_DIRECTIONAL)
  {
    integral = airlightDirectionalInterval(medium, light, ray, t0, t1);
  }
  else
  {
    integral = airlightQuadrature(medium, light, ray, t0, t1);
  }
  return medium.sigmaS * light.intensity * integral;
}
