// In a medium that is everywhere and uniform, number AIRLIGHT_EVERYWHERE, beside bounded media, in
// shaders. Where neither the ray nor the ways from it to the light meet any of those, what is
// scattered has the closed form of that medium alone.

#define AIRLIGHT_AROUND airlightMedia.item[AIRLIGHT_EVERYWHERE]

// The part of a range in which a t + b is not below 0.
real2 airlightNotBelow(real2 range, real a, real b)
{
  if (abs(a) < 1e-30)
  {
    return b >= 0.0 ? range : real2(range.y, range.x);
  }
  real end = -b / a;
  return a > 0.0 ? real2(max(range.x, end), range.y) : real2(range.x, min(range.y, end));
}

// Where on a ray its points, or their ways to the light, are in a box: one range, since the box and
// its shadow are convex together. Seen from a light at L, a point P is there if L + (P - L)/w is in
// the box for a w of at least 1; with the direction l to a light at infinity, if P + w l is for
// a w of at least 0. Both are conditions a t + b + g w >= 0, two for each pair of faces, of which w
// is eliminated: each that bounds it from below with each that bounds it from above.
real2 airlightBoxMet(
  real3 origin, real3 direction, real3 light, bool sun, real3 low, real3 high, real2 range)
{
  real3 from = sun ? origin - low : origin - light;
  real3 to = sun ? high - origin : light - origin;
  real3 gLow = sun ? light : light - low;
  real3 gHigh = sun ? -light : high - light;
  real least = sun ? 0.0 : 1.0;
  real3 rows[6];
  for (int i = 0; i < 3; i++)
  {
    rows[i] = real3(direction[i], from[i], gLow[i]);
    rows[i + 3] = real3(-direction[i], to[i], gHigh[i]);
  }
  for (int i = 0; i < AIRLIGHT_ROLLED(6); i++)
  {
    real3 row = rows[i];
    if (row.z <= 0.0)
    {
      range = airlightNotBelow(range, row.x, row.y + least * row.z);
    }
    for (int k = 0; k < AIRLIGHT_ROLLED(i); k++)
    {
      real3 other = rows[k];
      if (row.z * other.z < 0.0)
      {
        real2 both = row.z * other.xy - other.z * row.xy;
        both = row.z > 0.0 ? both : -both;
        range = airlightNotBelow(range, both.x, both.y);
      }
    }
  }
  return range;
}

// The same of all bounded media together, by boxes around them, with some margin.
real2 airlightMet(AirlightLight light, AirlightRay ray, real t0, real t1)
{
  bool sun = airlightIsDirectional(light);
  real2 met = real2(t1, t0);
  for (int i = 0; i < AIRLIGHT_DIMMING_COUNT; i++)
  {
    if (i != AIRLIGHT_EVERYWHERE)
    {
      AirlightRegion region = airlightMedia.item[i].region;
      real3 origin = ray.origin;
      real3 direction = ray.direction;
      real3 position = light.position;
      real3 reach = real3(region.radius + (airlightIsCylinder(region) ? region.halfHeight : 0.0));
      bool boxed = AIRLIGHT_REGION_KIND(region) == AIRLIGHT_REGION_BOX ||
        AIRLIGHT_REGION_KIND(region) == AIRLIGHT_REGION_SURFACE;
      real3 low = boxed ? region.boxMin : region.centre - reach;
      real3 high = boxed ? region.boxMax : region.centre + reach;
#ifdef AIRLIGHT_GRID_STEPS
      if (AIRLIGHT_IS_GRID(i))
      {
        // An image is a box in its own coordinates, in which straight ways stay straight.
        real3x3 axes = airlightMedia.item[i].grid.axes;
        real3 start = airlightMedia.item[i].grid.start;
        origin = axes * origin + start;
        direction = axes * direction;
        position = axes * position + (sun ? real3(0.0) : start);
        low = real3(0.0);
        high = airlightMedia.item[i].grid.last;
      }
#endif
      real2 range = airlightBoxMet(origin, direction, position, sun, low, high, real2(t0, t1));
      if (range.y > range.x)
      {
        met = real2(min(met.x, range.x), max(met.y, range.y));
      }
    }
  }
  // The ray's end may be infinite.
  real margin =
    1e-4 * min(met.y - met.x, abs(met.x) + abs(ray.foot.tL) + ray.foot.h);
  return met.x < met.y ? clamp(met + real2(-margin, margin), t0, t1) : real2(t1);
}

// Whether there is a closed form of the light in a uniform medium.
bool airlightHasClosedForm(AirlightLight light)
{
  bool spot = light.cosCone > 0.0 && light.exponent > 0.0;
  return airlightIsDirectional(light) ||
    (light.attenuation.x == 0.0 && light.attenuation.y == 0.0 && !spot && light.goniometric == 0);
}

// The light that an arc turns through, part by part (AirlightEquiangular.glsl). One place has a
// node: compilers take long for more, each of which has the poles of its phase function.
AirlightSpectrum airlightBesideArc(AirlightEquiangular arc)
{
  AirlightSpectrum sum = AirlightSpectrum(0.0);
  real psi = 0.0;
  for (int i = 0; i < AIRLIGHT_MAXIMUM_PANELS && psi < arc.end; i++)
  {
    real next = airlightEquiangularPanelEnd(AIRLIGHT_AROUND, arc, psi);
    real reach = 0.5 * (next - psi);
    for (int k = 0; k < AIRLIGHT_ROLLED(8); k++)
    {
      real2 node = airlightGaussNode(k / 2);
      real place = psi + reach * (k % 2 == 0 ? 1.0 - node.x : 1.0 + node.x);
      real2 halves = airlightSineCosine(0.5 * max(arc.left - place, 0.0));
      sum += reach * node.y *
        airlightEquiangularSample(AIRLIGHT_AROUND, arc, halves.x, halves.y);
    }
    psi = next;
  }
  return sum;
}

// The integral over [t0, t1], sigmaS included, beside the bounded media; `before` is the optical
// depth before t0.
real3 airlightBeside(AirlightLight light, AirlightRay ray, real t0, real3 before, real t1)
{
  real3 own = AIRLIGHT_AROUND.sigmaT * (t0 - ray.range.x);
  real3 others = airlightTransmittanceOf(max(before - own, real3(0.0)));
  if (airlightIsDirectional(light))
  {
    return others * airlightDirectionalClosed(AIRLIGHT_AROUND, light, ray, t0, t1);
  }
  AirlightEquiangular arc = airlightEquiangularRange(AIRLIGHT_AROUND, ray, t0, t1);
  return AIRLIGHT_AROUND.sigmaS * others * real3(airlightBesideArc(arc)) /
    (light.attenuation.z * ray.foot.h);
}

// The integral over [t0, t1], with the value of airlightTail3 at t0; it becomes that at t1 where it
// is the optical depth. One place has both closed forms, before and beyond the bounded media.
real3 airlightBesideAndIn(
  AirlightLight light, AirlightRay ray, real t0, inout real3 tail, real t1)
{
  real2 met = airlightHasClosedForm(light) ? airlightMet(light, ray, t0, t1) : real2(t0, t1);
  real3 before = tail;
  real3 sum = real3(0.0);
  for (int part = 0; part < AIRLIGHT_ROLLED(2); part++)
  {
    real from = part == 0 ? t0 : met.y;
    real to = part == 0 ? met.x : t1;
    if (to > from)
    {
#ifndef AIRLIGHT_GRID_STEPS
      before = airlightDepthBetween(ray.origin, ray.origin + from * ray.direction);
#endif
      sum += airlightBeside(light, ray, from, before, to);
    }
    if (part == 0 && met.y > met.x)
    {
#ifdef AIRLIGHT_GRID_STEPS
      before += AIRLIGHT_AROUND.sigmaT * (met.x - t0);
      sum += airlightGridInterval(light, ray, met.x, before, met.y);
#else
      sum += airlightQuadrature(AIRLIGHT_MEDIA_OUT light, ray, met.x, met.y);
#endif
    }
  }
#ifdef AIRLIGHT_GRID_STEPS
  tail = before + AIRLIGHT_AROUND.sigmaT * (t1 - (met.y > met.x ? met.y : t0));
#endif
  return sum;
}
