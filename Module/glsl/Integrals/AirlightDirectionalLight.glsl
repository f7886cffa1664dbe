// What a directional light scatters into a ray, in closed form.

// The light's way inside the box from a point of the ray, as a function of t: the least of three
// straight lines, one for each pair of faces. Component i of the result: line i at t = 0, its
// slope.
AIRLIGHT_FN real2 airlightSunLine(real o, real d, real l, real lo, real hi)
{
  if (abs(l) < real(1e-12))
  {
    return real2(real(AIRLIGHT_FAR), real(0.0));
  }
  return real2(((l > real(0.0) ? hi : lo) - o) / l, -d / l);
}

// A directional light in a uniform box, or unattenuated in an unbounded medium: on each of at most
// three pieces the optical depth is linear, which leaves exponentials.
AIRLIGHT_FN real3 airlightDirectionalClosed(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
  real2 line[3];
  line[0] = real2(real(0.0), real(0.0));
  line[1] = line[0];
  line[2] = line[0];
  if (AIRLIGHT_REGION_KIND(medium.region) == AIRLIGHT_REGION_BOX)
  {
    real3 o = ray.origin;
    real3 d = ray.direction;
    real3 l = light.position;
    line[0] = airlightSunLine(o.x, d.x, l.x, medium.region.boxMin.x, medium.region.boxMax.x);
    line[1] = airlightSunLine(o.y, d.y, l.y, medium.region.boxMin.y, medium.region.boxMax.y);
    line[2] = airlightSunLine(o.z, d.z, l.z, medium.region.boxMin.z, medium.region.boxMax.z);
  }
  // The lowest line at t0.
  int k = 0;
  for (int i = 1; i < 3; i++)
  {
    real gap = (line[i].x - line[k].x) + t0 * (line[i].y - line[k].y);
    k = gap < real(0.0) ? i : k;
  }
  real3 sum = real3(real(0.0));
  for (int piece = 0; piece < 3 && t0 < t1; piece++)
  {
    // Up to where a line of lesser slope undercuts it, which is then the lowest.
    real end = t1;
    int next = k;
    for (int i = 0; i < 3; i++)
    {
      if (line[i].y < line[k].y)
      {
        real crossing = max((line[i].x - line[k].x) / (line[k].y - line[i].y), t0);
        next = crossing < end ? i : next;
        end = min(end, crossing);
      }
    }
    real way = max(line[k].x + t0 * line[k].y, real(0.0));
    sum += airlightFading3(medium.sigmaT * (t0 - ray.range.x + way),
      medium.sigmaT * (real(1.0) + line[k].y), end - t0);
    t0 = end;
    k = next;
  }
  return medium.sigmaS * sum *
    airlightPhase(medium.phase, dot(light.position, ray.direction));
}

// A directional light in an unbounded medium whose density falls exponentially with height: the
// whole depth at t, view and light, is an exponential in t, so that one more exponential remains:
// d(depth)/dt = density sigmaT (1 - m/mu), m and mu the slopes of the ray and of the light's way.
AIRLIGHT_FN real3 airlightDirectionalHeight(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
  real m = dot(medium.up, ray.direction);
  real mu = dot(medium.up, light.position);
  // Light from the horizon or below comes through infinitely much.
  if (mu <= real(1e-18))
  {
    return real3(real(0.0));
  }
  // From the end of lesser depth. The other end's depth less the difference would round to
  // something below 0 where both are large, and exp() would grow beyond all numbers.
  real slope = real(1.0) - m / mu;
  real end = slope >= real(0.0) ? t0 : t1;
  real depth = airlightInsideDepth(medium, ray.origin, ray.direction, ray.range.x, end) +
    airlightSunDepth(medium, false, ray.origin + end * ray.direction, light.position);
  real inside = airlightInsideDepth(medium, ray.origin, ray.direction, t0, t1);
  return medium.sigmaS * airlightPhase(medium.phase, dot(light.position, ray.direction)) *
    airlightFading3(medium.sigmaT * depth, medium.sigmaT * abs(slope), inside);
}
