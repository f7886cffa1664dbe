// Airlight in one medium whose density is an image, in shaders: cell by cell, with Gauss and
// Legendre's three nodes on parts of a cell so short that they are good for 1e-5. What a light
// loses on its way is the mean density between, interpolated from a coarser grid
// (AirlightLightGrid.h), times the length.

// Of a part: of what it changes the optical depth by, of its length over the distance from the
// light, and of v = asinh(x/h) near the light. The scattering angle changes by no more than the
// latter two, and tables can have bumps of a degree.
#define AIRLIGHT_PART_DEPTH 1.0
#if AIRLIGHT_HAS_TABLE
#define AIRLIGHT_PART_SLANT 0.05
#define AIRLIGHT_PANEL_ANGLE 0.05
#define AIRLIGHT_MOST_PARTS 200.0
#else
#define AIRLIGHT_PART_SLANT 0.3
#define AIRLIGHT_PANEL_ANGLE 0.8
#define AIRLIGHT_MOST_PARTS 40.0
#endif

// No ray has more: twelve edges of the region and of the image.
#define AIRLIGHT_MOST_KINKS 24

// Beyond this optical depth nothing counts.
#define AIRLIGHT_GRID_DARK 20.0

// The depth, per unit extinction, between a point inside the medium and the light.
real airlightToLight(AirlightMedium medium, AirlightLight light, real3 point)
{
  real3 way = light.position;
  real l = AIRLIGHT_FAR;
  if (!airlightIsDirectional(light))
  {
    way = light.position - point;
    l = max(length(way), 1e-30);
    way /= l;
  }
  real2 range = airlightRegionRange(medium.region, point, way, l);
  range = airlightGridRange(medium.grid, point, way, range.x, range.y);
  real3 position = (medium.grid.start + medium.grid.axes * point) / medium.grid.last;
  real mean = airlightInterpolated(
    light.gridFirst, light.gridSize, clamp(position, 0.0, 1.0) * light.gridSize);
  return max(mean, 0.0) * max(range.y - range.x, 0.0);
}

real3 airlightLightDepth(AirlightMedia media, AirlightLight light, real3 point)
{
  return media.item[0].sigmaT * airlightToLight(media.item[0], light, point);
}

// The next boundary often lies a little further on the same ray: what is known of it is kept.
real3 airlightCachedOrigin = real3(0.0);
real3 airlightCachedDirection = real3(0.0);
real airlightCachedTo = -1.0;
real airlightCachedDepth = 0.0;

// Integral of the density on the ray up to t.
real airlightGridDepthTo(AirlightMedium medium, AirlightRay ray, real t)
{
  bool known = airlightCachedTo >= ray.range.x && airlightCachedTo <= t &&
    airlightCachedOrigin == ray.origin && airlightCachedDirection == ray.direction;
  real from = known ? airlightCachedTo : ray.range.x;
  real before = known ? airlightCachedDepth : 0.0;
  airlightCachedOrigin = ray.origin;
  airlightCachedDirection = ray.direction;
  airlightCachedTo = t;
  airlightCachedDepth =
    before + airlightGridDepth(medium.grid, ray.origin, ray.direction, from, t);
  return airlightCachedDepth;
}

// What is scattered at t, per unit sigmaS and density, with the depth before it on the ray.
real3 airlightGridIntegrand(
  AirlightMedium medium, AirlightLight light, AirlightRay ray, real t, real before)
{
  real3 point = ray.origin + t * ray.direction;
  real3 passes = exp(-medium.sigmaT * (before + airlightToLight(medium, light, point)));
  if (airlightIsDirectional(light))
  {
    return airlightPhase(medium.phase, dot(light.position, ray.direction)) * passes;
  }
  real x = t - ray.range.x - ray.foot.tL;
  real r = sqrt(ray.foot.h * ray.foot.h + x * x);
  return airlightPhase(medium.phase, -x / r) * airlightFalloff(light, point, r) *
    airlightPhotometricShare(light, point) * passes;
}

// The integral over [a, b], the part of the ray in one cell; `depth` is before a.
real3 airlightInterval3InCell(AirlightMedium medium, AirlightLight light, AirlightRay ray,
  real4 cubic, real steepest, real a, real b, real depth)
{
  // Straight, or over v with x = h sinh v.
  real tL = ray.range.x + ray.foot.tL;
  real nearest = a > tL ? a - tL : max(tL - b, 0.0);
  nearest = max(nearest, ray.foot.h);
  bool straight = airlightIsDirectional(light) || b - a <= AIRLIGHT_PART_SLANT * nearest;
  real v0 = straight ? a : airlightAsinh((a - tL) / ray.foot.h);
  real v1 = straight ? b : airlightAsinh((b - tL) / ray.foot.h);
  real count = 2.0 * steepest * (b - a) / AIRLIGHT_PART_DEPTH;
  count = straight ? count : max(count, (v1 - v0) / AIRLIGHT_PANEL_ANGLE);
  int parts = int(clamp(ceil(count), 1.0, AIRLIGHT_MOST_PARTS));
  real width = (v1 - v0) / real(parts);
  real3 sum = real3(0.0);
  for (int i = 0; i < 3 * parts; i++)
  {
    int k = i % 3;
    real node = k == 0 ? 0.11270166537925831 : k == 1 ? 0.5 : 0.88729833462074169;
    real v = v0 + (real(i / 3) + node) * width;
    real e = straight ? 1.0 : exp(v);
    real t = straight ? v : tL + 0.5 * ray.foot.h * (e - 1.0 / e);
    real u = clamp((t - a) / (b - a), 0.0, 1.0);
    real density = cubic.x + u * (cubic.y + u * (cubic.z + u * cubic.w));
    real before = (b - a) * u *
      (cubic.x + u * (0.5 * cubic.y + u * (cubic.z / 3.0 + u * 0.25 * cubic.w)));
    real weight = k == 1 ? 0.44444444444444444 : 0.27777777777777778;
    weight *= straight ? 1.0 : 0.5 * ray.foot.h * (e + 1.0 / e);
    sum += weight * max(density, 0.0) *
      airlightGridIntegrand(medium, light, ray, t, depth + before);
  }
  return width * sum;
}

// Where after t the way to the light begins to leave region or image through another face, else t1.
// An image is a box in its own coordinates, in which straight ways stay straight.
real airlightNextGridKink(
  AirlightMedia media, AirlightLight light, AirlightRay ray, real t, real t1)
{
  AirlightGrid grid = media.item[0].grid;
  AirlightRegion box = media.item[0].region;
  bool directional = airlightIsDirectional(light);
  real3 there = grid.axes * light.position + (directional ? real3(0.0) : grid.start);
  if (!directional && airlightHolds(box, light.position) &&
    all(greaterThanEqual(there, real3(0.0))) && all(lessThanEqual(there, grid.last)))
  {
    return t1;
  }
  AirlightWay way = airlightWay(light, ray);
  t1 = airlightNextKink(media, way, t, t1);
  way.origin = grid.axes * way.origin + (directional ? grid.start : real3(0.0));
  way.direction = grid.axes * way.direction;
  way.light = there;
  box.boxMin = real3(0.0);
  box.boxMax = grid.last;
  return airlightBoxKink(box, way, t + 1e-6 * (t1 - t), t1);
}

// The integral over [t0, t1], sigmaS included; `before` is the density's integral up to t0.
real3 airlightGridInterval(
  AirlightMedia media, AirlightLight light, AirlightRay ray, real t0, real before, real t1)
{
  AirlightMedium medium = media.item[0];
  AirlightWalk walk = airlightWalk(medium.grid, ray.origin, ray.direction, t0, t1);
  real3 sum = real3(0.0);
  real most = max(medium.sigmaT.x, max(medium.sigmaT.y, medium.sigmaT.z));
  real dark = AIRLIGHT_GRID_DARK / airlightLeastExtinction(medium);
  int cells = airlightMostCells(walk) + AIRLIGHT_MOST_KINKS;
  real kink = airlightNextGridKink(media, light, ray, walk.t, walk.end);
  for (int i = 0; i < cells && walk.t < walk.end && before < dark; i++)
  {
    real end = min(airlightCellEnd(walk), kink);
    AirlightCell cell = airlightCell(medium.grid.first, walk.size, walk.cell);
    real4 larger = max(cell.low, cell.high);
    real largest = max(max(larger.x, larger.y), max(larger.z, larger.w));
    if (end > walk.t && largest > 0.0)
    {
      real3 corner = walk.origin - real3(walk.cell);
      real4 cubic =
        airlightCellCubic(cell, corner + walk.t * walk.slope, corner + end * walk.slope);
      sum += airlightInterval3InCell(
        medium, light, ray, cubic, most * largest, walk.t, end, before);
      before += (end - walk.t) *
        (cubic.x + 0.5 * cubic.y + cubic.z / 3.0 + 0.25 * cubic.w);
    }
    airlightEnterNext(walk, end);
    if (walk.t >= kink)
    {
      kink = airlightNextGridKink(media, light, ray, walk.t, walk.end);
    }
  }
  return medium.sigmaS * sum;
}
