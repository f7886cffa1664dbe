// Airlight in media of which some have their density from an image, in shaders: step by step
// (AirlightGridSteps.glsl), with Gauss and Legendre's three nodes on parts of a step so short that
// they are good for 1e-5.

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
#define AIRLIGHT_MOST_PARTS 64.0
#endif
// By such a share may a step with one node change what is scattered.
#define AIRLIGHT_SINGLE_CHANGE 0.02
// Colours are cubics in a step, as the density is; ways to the light have kinks at the edges of a
// surface.
#if AIRLIGHT_ALBEDO_MEDIA || AIRLIGHT_GLOW_MEDIA || AIRLIGHT_HAS_SURFACE
#define AIRLIGHT_LEAST_PARTS 2.0
#else
#define AIRLIGHT_LEAST_PARTS 1.0
#endif

// The optical depth on [from, to] of a ray.
real3 airlightDepthOn(real3 origin, real3 direction, real from, real to)
{
  real3 depth = real3(0.0);
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    AirlightMedium medium = airlightMedia.item[i];
    bool surface = AIRLIGHT_IS_SURFACE(i);
    depth += medium.sigmaT *
      (AIRLIGHT_IS_GRID(i)
          ? airlightGridDepthInRegion(medium, surface, origin, direction, from, to)
          : airlightPathDepth(medium, surface, origin + from * direction, direction, to - from));
  }
  return depth;
}

// Whether what is scattered in a step changes so little beside the density that one node does, at
// the density's centre: by how much its optical depth, its share of the distance from the light,
// and `bends`, which are counted in parts, change it. In images of many cells most steps are such.
bool airlightIsSingle(
  AirlightLight light, AirlightRay ray, AirlightStep part, real reach, real nearest, real bends)
{
#if AIRLIGHT_HAS_TABLE || AIRLIGHT_ALBEDO_MEDIA || AIRLIGHT_GLOW_MEDIA || AIRLIGHT_HAS_SURFACE
  return false;
#else
  real slant = airlightIsDirectional(light) ? 0.0 : reach / nearest;
  real most = max(max(part.rate, part.rise) * reach, max(slant, bends)) / AIRLIGHT_SINGLE_CHANGE;
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    if (AIRLIGHT_IS_GRID(i) && airlightIsInImage(part, i))
    {
      real3 moved = abs(real3x3(light.gridCells[i]) * (reach * ray.direction));
      most = max(most, max(moved.x, max(moved.y, moved.z)));
    }
  }
  return most <= 1.0;
#endif
}

// The centre of mass of a step's density, in [0, 1].
real airlightStepCentre(AirlightStep part)
{
  real2 sum = real2(0.0);
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    if (AIRLIGHT_IS_GRID(i))
    {
      real4 c = airlightMedia.item[i].sigmaT.y * part.cubic[i];
      sum += real2(airlightCubicIntegral(c, 1.0),
        0.5 * c.x + c.y / 3.0 + 0.25 * c.z + 0.2 * c.w);
    }
  }
  return sum.x > 0.0 ? clamp(sum.y / sum.x, 0.0, 1.0) : 0.5;
}

// What is scattered at t, with the optical depth before it on the ray; single: with the mean
// densities of images in the step.
real3 airlightStepIntegrand(AirlightLight light, AirlightRay ray, AirlightStep part, real t,
  bool single, real3 before, AirlightOutside outside)
{
  real3 point = ray.origin + t * ray.direction;
  bool sun = airlightIsDirectional(light);
  real x = t - ray.range.x - ray.foot.tL;
  real r = sqrt(ray.foot.h * ray.foot.h + x * x);
  real cosTheta = sun ? dot(light.position, ray.direction) : -x / r;
  real3 scattered = real3(0.0);
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    if (airlightIsInside(part, i))
    {
      real2 density = airlightStepDensity(i, part, ray.origin, ray.direction, t);
      density.x =
        single && AIRLIGHT_IS_GRID(i) ? airlightCubicIntegral(part.cubic[i], 1.0) : density.x;
      scattered += airlightStepScattering(i, part, t) *
        airlightPhase(airlightMedia.item[i].phase, cosTheta) * density.x;
      before += airlightMedia.item[i].sigmaT * density.y;
    }
  }
  scattered *= airlightTransmittanceOf(before + airlightInsideLightDepth(light, point, outside));
  return sun
    ? scattered
    : scattered * airlightFalloff(light, point, r) * airlightPhotometricShare(light, point);
}

// The integral over a step; `before` is the depth before it.
real3 airlightStepIntegral(AirlightLight light, AirlightRay ray, AirlightStep part, real3 before)
{
  // Straight, or over v with x = h sinh v.
  real a = part.from;
  real b = part.to;
  real tL = ray.range.x + ray.foot.tL;
  real nearest = a > tL ? a - tL : max(tL - b, 0.0);
  nearest = max(nearest, ray.foot.h);
  bool straight = airlightIsDirectional(light) || b - a <= AIRLIGHT_PART_SLANT * nearest;
  real v0 = straight ? a : airlightAsinh((a - tL) / ray.foot.h);
  real v1 = straight ? b : airlightAsinh((b - tL) / ray.foot.h);
  real bends = airlightBehindImages(light, ray, part.inImages, a, b);
  bool single = airlightIsSingle(light, ray, part, b - a, nearest, bends);
  real count = 2.0 * part.rate * (b - a) / AIRLIGHT_PART_DEPTH;
  count = straight ? count : max(count, (v1 - v0) / AIRLIGHT_PANEL_ANGLE);
  count = max(count, bends);
  count = max(count, max(part.rise * (b - a), AIRLIGHT_LEAST_PARTS));
  int parts = int(clamp(ceil(count), 1.0, AIRLIGHT_MOST_PARTS));
  real width = (v1 - v0) / real(parts);
  AirlightOutside first;
  AirlightOutside last;
#if AIRLIGHT_HAS_SURFACE
  // Where the ray's walks through trees have taken many rounds, between the step's ends: steps are
  // short in images of many cells.
  bool each = AIRLIGHT_FEW_ROUNDS;
  for (int i = 0; i < (each ? 0 : 2); i++)
  {
    last = airlightOutsideAt(light, ray.origin + (i == 0 ? a : b) * ray.direction);
    if (i == 0)
    {
      first = last;
    }
  }
#endif
  real3 sum = real3(0.0);
  real centre = single ? airlightStepCentre(part) : 0.5;
  for (int i = 0; i < (single ? 1 : 3 * parts); i++)
  {
    int k = single ? 1 : i % 3;
    real node = k == 0 ? 0.11270166537925831 : k == 1 ? centre : 0.88729833462074169;
    real v = v0 + (real(i / 3) + node) * width;
    real e = straight ? 1.0 : exp(v);
    real t = straight ? v : tL + 0.5 * ray.foot.h * (e - 1.0 / e);
    real weight = single ? 1.0 : k == 1 ? 0.44444444444444444 : 0.27777777777777778;
    weight *= straight ? 1.0 : 0.5 * ray.foot.h * (e + 1.0 / e);
    AirlightOutside outside = airlightMixOutside(first, last, (t - a) / (b - a));
#if AIRLIGHT_HAS_SURFACE
    if (each)
    {
      outside = airlightOutsideAt(light, ray.origin + t * ray.direction);
    }
#endif
    sum += weight * airlightStepIntegrand(light, ray, part, t, single, before, outside);
  }
  return width * sum;
}

// Where a part of the air between filled cells that begins at `from` is cut, as AirlightPieces.glsl
// cuts pieces; `lengths`: of channels, from where the air begins. It is not halved where it is
// rough: the details of a cloud's shadow have no end.
real airlightAirPartEnd(
  AirlightLight light, AirlightRay ray, AirlightPiece air, real3 lengths, real from, real end)
{
  real t = airlightNextLayerEnd(ray.origin, ray.direction, real2(air.from, end),
    airlightToSun(light), from, end);
  return airlightNextChannelEnd(air, lengths, from, t);
}

// The integral over a piece; piece.depth becomes what is before its end. Each round adds a part: a
// step in filled cells or, from `open` on, some of the air before it. One place integrates both:
// software renderers go through all branches.
real3 airlightGridPiece(
  AirlightLight light, AirlightRay ray, AirlightWay way, inout AirlightPiece piece)
{
  AirlightSteps steps = airlightSteps(piece, ray.origin, ray.direction);
  real3 clear = airlightClearChannels();
  real3 sum = real3(0.0);
  real kink = piece.from;
  real open = piece.from;
  int others = piece.inside & ~AIRLIGHT_GRID_MEDIA;
  AirlightPiece air;
  bool walks = true;
  for (int i = 0; i < steps.most && open < piece.to && !airlightIsDark(piece.depth, clear); i++)
  {
    if (walks)
    {
      airlightWalkToFilled(steps, piece);
      open = others == 0 ? steps.t : open;
      air = AirlightPiece(open, steps.t, others, piece.depth);
    }
    AirlightStep part = airlightStepAt(steps, piece);
    bool isOpen = open < steps.t;
    bool counts = true;
    if (open >= kink)
    {
      kink = airlightNextKink(way, open, piece.to);
    }
#if AIRLIGHT_DIMMING_COUNT > 1
    if (isOpen)
    {
      part.from = open;
      part.inImages = 0;
      part.inside = others;
      // What lies beyond the longest of the lengths no longer counts; thin fog would go on forever.
      real3 lengths = airlightChannelLengths(air, ray.origin, ray.direction);
      real end = min(air.to, air.from + max(lengths.x, max(lengths.y, lengths.z)));
      counts = open < end;
      part.to = counts ? airlightAirPartEnd(light, ray, air, lengths, open, end) : air.to;
    }
#endif
    part.to = counts ? min(part.to, kink) : part.to;
    if (part.to > part.from)
    {
      airlightFindDensities(steps, ray.origin, ray.direction, part);
      if (counts)
      {
        sum += airlightStepIntegral(light, ray, part, piece.depth);
      }
      piece.depth += airlightStepDepth(part, ray.origin, ray.direction, part.to);
    }
    open = part.to;
    walks = !isOpen;
    if (walks)
    {
      airlightLeaveStep(steps, part);
    }
  }
  return sum;
}

// The integral over [t0, t1], sigmaS included; `before` is the optical depth before t0, and becomes
// that before t1, or what is dark.
real3 airlightGridInterval(
  AirlightLight light, AirlightRay ray, real t0, inout real3 before, real t1)
{
  AirlightWay way = airlightWay(light, ray);
#if AIRLIGHT_DIMMING_COUNT == 1 && !AIRLIGHT_HAS_SURFACE
  // Its region is convex: all of the interval is inside.
  AirlightPiece whole = AirlightPiece(t0, t1, 1, before);
  real3 sum = airlightGridPiece(light, ray, way, whole);
  before = whole.depth;
  return sum;
#else
  real3 clear = airlightClearChannels();
  real3 sum = real3(0.0);
  while (t0 < t1 && !airlightIsDark(before, clear))
  {
    AirlightPiece piece = airlightPieceFrom(ray.origin, ray.direction, t0, t1, before);
    if (piece.inside != 0)
    {
      sum += airlightGridPiece(light, ray, way, piece);
    }
    before = piece.depth;
    t0 = piece.to;
  }
  return sum;
#endif
}

// ---- Ambient radiance -------------------------------------------------------------------------

// Over a step.
real3 airlightAmbientInStep(AirlightStep part, real3 origin, real3 direction, real3 before)
{
  real parts = clamp(ceil(2.0 * part.rate * (part.to - part.from) / AIRLIGHT_PART_DEPTH),
    AIRLIGHT_LEAST_PARTS, AIRLIGHT_MOST_PARTS);
  real width = (part.to - part.from) / parts;
  real3 sum = real3(0.0);
  for (int node = 0; node < 3 * int(parts); node++)
  {
    int k = node % 3;
    real share = k == 0 ? 0.11270166537925831 : k == 1 ? 0.5 : 0.88729833462074169;
    real t = part.from + (real(node / 3) + share) * width;
    real3 source = real3(0.0);
    for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
    {
      if (airlightIsInside(part, i))
      {
        source += airlightStepSource(i, part, direction, t) *
          airlightStepDensity(i, part, origin, direction, t).x;
      }
    }
    sum += (k == 1 ? 0.44444444444444444 : 0.27777777777777778) * source *
      airlightTransmittanceOf(before + airlightStepDepth(part, origin, direction, t));
  }
  return width * sum;
}

// piece.depth becomes what is before its end.
real3 airlightAmbientInImages(inout AirlightPiece piece, real3 origin, real3 direction)
{
  AirlightSteps steps = airlightSteps(piece, origin, direction);
  real3 clear = airlightClearChannels();
  real3 sum = real3(0.0);
  int others = piece.inside & ~AIRLIGHT_GRID_MEDIA;
  for (int i = 0; i < steps.most && steps.t < piece.to && !airlightIsDark(piece.depth, clear);
       i++)
  {
    AirlightPiece between = AirlightPiece(steps.t, steps.t, others, piece.depth);
    airlightWalkToFilled(steps, piece);
    between.to = steps.t;
    if (others != 0 && between.to > between.from)
    {
      sum += airlightAmbientInPiece(between, origin, direction);
      piece.depth = airlightDepthInPiece(between, origin, direction, between.to);
    }
    AirlightStep part = airlightStepAt(steps, piece);
    if (part.to > part.from)
    {
      airlightFindDensities(steps, origin, direction, part);
      sum += airlightAmbientInStep(part, origin, direction, piece.depth);
      piece.depth += airlightStepDepth(part, origin, direction, part.to);
    }
    airlightLeaveStep(steps, part);
  }
  return sum;
}
