// A ray's way from cell to cell of all images that it is in, in shaders.

// No ray has more kinks for each medium: twelve edges of the region and of the image.
#define AIRLIGHT_MOST_KINKS 24

// Beyond this optical depth nothing counts.
#define AIRLIGHT_GRID_DARK 20.0

struct AirlightSteps
{
  AirlightWalk walk[AIRLIGHT_MEDIUM_COUNT]; // of media with images
  AirlightCell cell[AIRLIGHT_MEDIUM_COUNT]; // where airlightWalkToFilled() has stopped
  real t;
  bool first; // no image has been walked yet
  int most;   // more steps are on no ray
};

// Colours along a ray in a cell: at its ends, and at a third and two thirds of it.
struct AirlightColours
{
  real3 place[4];
};

// A part of a ray in one cell of each image that it is in.
struct AirlightStep
{
  real from;
  real to;
  int inside; // bit i: medium i is there
  int inImages; // bit i: in its image
  real4 cubic[AIRLIGHT_MEDIUM_COUNT]; // the density there
#if AIRLIGHT_ALBEDO_MEDIA
  AirlightColours albedo[AIRLIGHT_MEDIUM_COUNT]; // of those that have such arrays
#endif
#if AIRLIGHT_GLOW_MEDIA
  AirlightColours glow[AIRLIGHT_MEDIUM_COUNT]; // factors of the emission
#endif
  real rate;  // the largest of extinctions there
  real rise;  // the most scale heights that a medium falls or rises per unit of length
};

// Whether medium i is there. One alone is, wherever a step is looked at.
bool airlightIsInside(AirlightStep part, int i)
{
  return AIRLIGHT_DIMMING_COUNT == 1 || ((part.inside >> i) & 1) != 0;
}

bool airlightIsInImage(AirlightStep part, int i)
{
  return ((part.inImages >> i) & 1) != 0;
}

// Walks on to a cell of image i that has something, and reads it, or to the end.
void airlightFindFilled(inout AirlightSteps steps, int i)
{
  int first = airlightMedia.item[i].grid.first;
  AirlightWalk walk = steps.walk[i];
  int3 block = int3(-1);
  bool found = false;
  int most = airlightMostCells(walk);
  for (int k = 0; k < most && !found; k++)
  {
    airlightLeaveEmptyBlocks(first, walk, block);
    if (walk.t >= walk.end)
    {
      break;
    }
    steps.cell[i] = airlightCell(first, walk.size, walk.cell);
    found = airlightMostInCell(steps.cell[i]) > 0.0;
    if (!found)
    {
      airlightEnterNext(walk, airlightCellEnd(walk));
    }
  }
  steps.walk[i] = walk;
}

AirlightSteps airlightSteps(AirlightPiece piece, real3 origin, real3 direction)
{
  AirlightSteps steps;
  steps.t = piece.from;
  steps.first = true;
  steps.most = 2 * AIRLIGHT_MOST_KINKS * (AIRLIGHT_DIMMING_COUNT - AIRLIGHT_MEDIUM_COUNT);
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    steps.most += 2 * AIRLIGHT_MOST_KINKS;
    if (AIRLIGHT_IS_GRID(i))
    {
      real to = airlightPieceHolds(piece, i) ? piece.to : piece.from;
      steps.walk[i] = airlightWalk(airlightMedia.item[i].grid, origin, direction, piece.from, to);
      steps.most += airlightMostCells(steps.walk[i]);
    }
  }
  return steps;
}

// From steps.t on; without its densities.
AirlightStep airlightStepAt(AirlightSteps steps, AirlightPiece piece)
{
  AirlightStep result;
  result.from = steps.t;
  result.to = piece.to;
  result.inside = piece.inside & ~AIRLIGHT_GRID_MEDIA;
  result.inImages = 0;
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    if (AIRLIGHT_IS_GRID(i) && steps.walk[i].t < steps.walk[i].end)
    {
      bool there = steps.walk[i].t <= steps.t;
      result.inImages |= there ? 1 << i : 0;
      result.to = min(result.to, there ? airlightCellEnd(steps.walk[i]) : steps.walk[i].t);
    }
  }
  result.inside |= result.inImages;
  return result;
}

void airlightLeaveStep(inout AirlightSteps steps, AirlightStep part)
{
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    if (AIRLIGHT_IS_GRID(i) && airlightIsInImage(part, i))
    {
      airlightEnterNext(steps.walk[i], part.to);
    }
  }
  steps.t = part.to;
}

// Walks on to where an image has something, or the piece ends. Clouds are mostly empty, and the air
// between them needs no cells. Images that are not there yet have been walked before. Functions
// have it in their loop alone: compilers take longer where it is before that, too.
void airlightWalkToFilled(inout AirlightSteps steps, AirlightPiece piece)
{
  real next = piece.to;
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    if (AIRLIGHT_IS_GRID(i))
    {
      if (steps.first || steps.walk[i].t <= steps.t)
      {
        airlightFindFilled(steps, i);
      }
      next = steps.walk[i].t < steps.walk[i].end ? min(next, steps.walk[i].t) : next;
    }
  }
  steps.t = max(steps.t, next);
  steps.first = false;
}

// Between an array's colours at the corners of a cell.
real3 airlightColourInCell(int first, int3 size, int3 cell, real3 f)
{
  real3 sum = real3(0.0);
  for (int corner = 0; corner < 8; corner++)
  {
    int3 far = int3(corner & 1, (corner >> 1) & 1, corner >> 2);
    real3 share = mix(1.0 - f, f, real3(far));
    int3 at = cell + far;
    sum += share.x * share.y * share.z *
      texelFetch(airlightData, first + at.x + (size.x + 1) * (at.y + (size.y + 1) * at.z)).rgb;
  }
  return sum;
}

// On a ray from place a to b of a cell.
AirlightColours airlightCellColours(int first, AirlightWalk walk, real3 a, real3 b)
{
  AirlightColours colours;
  for (int k = 0; k < 4; k++)
  {
    colours.place[k] =
      airlightColourInCell(first, walk.size, walk.cell, mix(a, b, real(k) / 3.0));
  }
  return colours;
}

// The cubic through the four places.
real3 airlightColourAt(AirlightColours colours, real u)
{
  real a = u - 1.0 / 3.0;
  real b = u - 2.0 / 3.0;
  real c = u - 1.0;
  return max(-4.5 * a * b * c * colours.place[0] + 13.5 * u * b * c * colours.place[1] -
      13.5 * u * a * c * colours.place[2] + 4.5 * u * a * b * colours.place[3],
    real3(0.0));
}

// The densities of a step, in the cells that are read.
void airlightFindDensities(
  AirlightSteps steps, real3 origin, real3 direction, inout AirlightStep part)
{
  part.rate = 0.0;
  part.rise = 0.0;
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    real largest = 0.0;
    part.cubic[i] = real4(0.0);
    if (AIRLIGHT_IS_GRID(i))
    {
      if (airlightIsInImage(part, i))
      {
        AirlightWalk walk = steps.walk[i];
        largest = airlightMostInCell(steps.cell[i]);
        real3 corner = walk.origin - real3(walk.cell);
        real3 a = corner + part.from * walk.slope;
        real3 b = corner + part.to * walk.slope;
        part.cubic[i] = airlightCellCubic(steps.cell[i], a, b);
#if AIRLIGHT_ALBEDO_MEDIA
        if (AIRLIGHT_HAS_ALBEDO(i))
        {
          part.albedo[i] = airlightCellColours(airlightMedia.item[i].albedoFirst, walk, a, b);
        }
#endif
#if AIRLIGHT_GLOW_MEDIA
        if (AIRLIGHT_HAS_GLOW(i))
        {
          part.glow[i] = airlightCellColours(airlightMedia.item[i].glowFirst, walk, a, b);
        }
#endif
      }
    }
    else if (airlightIsInside(part, i))
    {
      largest = max(airlightDensity(airlightMedia.item[i], origin + part.from * direction),
        airlightDensity(airlightMedia.item[i], origin + part.to * direction));
      part.rise = max(part.rise, abs(airlightRise(airlightMedia.item[i], direction)));
    }
    real3 sigmaT = airlightMedia.item[i].sigmaT;
    part.rate += largest * max(sigmaT.x, max(sigmaT.y, sigmaT.z));
  }
}

// The integral of a cubic from 0 to u.
real airlightCubicIntegral(real4 c, real u)
{
  return u * (c.x + u * (0.5 * c.y + u * (c.z / 3.0 + u * 0.25 * c.w)));
}

// The density of medium i at t in a step, and its integral before t.
real2 airlightStepDensity(int i, AirlightStep part, real3 origin, real3 direction, real t)
{
  if (AIRLIGHT_IS_GRID(i))
  {
    real width = part.to - part.from;
    real u = clamp((t - part.from) / width, 0.0, 1.0);
    real4 c = part.cubic[i];
    return real2(max(c.x + u * (c.y + u * (c.z + u * c.w)), 0.0),
      width * airlightCubicIntegral(c, u));
  }
  return real2(airlightDensity(airlightMedia.item[i], origin + t * direction),
    airlightInsideDepth(airlightMedia.item[i], origin, direction, part.from, max(t, part.from)));
}

// The scattering coefficient of medium i at t in a step, and what shines there, at density 1.
real3 airlightStepScattering(int i, AirlightStep part, real t)
{
#if AIRLIGHT_ALBEDO_MEDIA
  if (AIRLIGHT_HAS_ALBEDO(i))
  {
    real u = clamp((t - part.from) / (part.to - part.from), 0.0, 1.0);
    return airlightMedia.item[i].sigmaS * airlightColourAt(part.albedo[i], u);
  }
#endif
  return airlightMedia.item[i].sigmaS;
}

real3 airlightStepSource(int i, AirlightStep part, real3 direction, real t)
{
  real3 emission = airlightMedia.item[i].emission;
#if AIRLIGHT_GLOW_MEDIA
  if (AIRLIGHT_HAS_GLOW(i))
  {
    real u = clamp((t - part.from) / (part.to - part.from), 0.0, 1.0);
    emission *= airlightColourAt(part.glow[i], u);
  }
#endif
  return airlightStepScattering(i, part, t) *
    airlightAmbientRadiance(airlightMedia.item[i], direction) + emission;
}

real3 airlightStepDepth(AirlightStep part, real3 origin, real3 direction, real t)
{
  real3 depth = real3(0.0);
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    if (airlightIsInside(part, i))
    {
      depth += airlightMedia.item[i].sigmaT *
        airlightStepDensity(i, part, origin, direction, t).y;
    }
  }
  return depth;
}

// 1 for channels in which nothing is scattered nor emitted: they have no say in what counts.
real3 airlightClearChannels()
{
  real3 sum = real3(0.0);
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    sum += airlightMedia.item[i].sigmaT + airlightMedia.item[i].emission;
  }
  return real3(lessThanEqual(sum, real3(0.0)));
}

// Whether nothing beyond the depth counts.
bool airlightIsDark(real3 depth, real3 clear)
{
  real3 d = depth + AIRLIGHT_FAR * clear;
  return min(d.x, min(d.y, d.z)) > AIRLIGHT_GRID_DARK;
}
