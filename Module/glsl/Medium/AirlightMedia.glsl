// All media of a scene. Where they overlap, their coefficients add. After them come volumes that
// cast shadows: images that take away light on its way from the lights, and are not seen.

struct AirlightMedia
{
  AirlightMedium item[AIRLIGHT_MAX_MEDIA];
  int count;
  int volumes; // items after `count`
  AIRLIGHT_MULTIPLE_MEMBER
};
AIRLIGHT_MEDIA_UNIFORM

// Where the number of media is known when a shader is compiled, its loops unroll.
#ifndef AIRLIGHT_MEDIUM_COUNT
#define AIRLIGHT_MEDIUM_COUNT airlightMedia.count
#endif

// Media and volumes: what is on the way of lights. Double precision knows of media alone.
#ifndef AIRLIGHT_DIMMING_COUNT
#define AIRLIGHT_DIMMING_COUNT AIRLIGHT_MEDIUM_COUNT
#endif

// Optical depth of the straight way [0, l] of a ray, per channel.
AIRLIGHT_FN real3 airlightDepth(AIRLIGHT_MEDIA_IN real3 origin, real3 direction, real l)
{
  real3 depth = real3(real(0.0));
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    depth += airlightMedia.item[i].sigmaT *
      airlightPathDepth(airlightMedia.item[i], AIRLIGHT_IS_SURFACE(i), origin, direction, l);
  }
  return depth;
}

// Optical depth between a point and a light.
AIRLIGHT_FN real3 airlightDepthBetween(AIRLIGHT_MEDIA_IN real3 a, real3 b)
{
  real l = length(b - a);
  real3 depth =
    l > real(0.0) ? airlightDepth(AIRLIGHT_MEDIA_OUT a, (b - a) / l, l) : real3(real(0.0));
#ifdef AIRLIGHT_HAS_VOLUMES
  for (int i = AIRLIGHT_MEDIUM_COUNT; i < AIRLIGHT_DIMMING_COUNT; i++)
  {
    depth += l > real(0.0)
      ? airlightMedia.item[i].sigmaT *
        airlightPathDepth(airlightMedia.item[i], false, a, (b - a) / l, l)
      : real3(real(0.0));
  }
#endif
  return depth;
}

// Optical depth on the way to a light at infinity.
AIRLIGHT_FN real3 airlightSunDepths(AIRLIGHT_MEDIA_IN real3 point, real3 toLight)
{
  real3 depth = real3(real(0.0));
  for (int i = 0; i < AIRLIGHT_DIMMING_COUNT; i++)
  {
    depth += airlightMedia.item[i].sigmaT *
      airlightSunDepth(airlightMedia.item[i], AIRLIGHT_IS_SURFACE(i), point, toLight);
  }
  return depth;
}

// A part of a ray in which no medium begins or ends.
struct AirlightPiece
{
  real from;
  real to;
  int inside;  // bit i: medium i is there
  real3 depth; // optical depth before it
};

AIRLIGHT_FN bool airlightPieceHolds(AIRLIGHT_IN(AirlightPiece) piece, int i)
{
  return ((piece.inside >> i) & 1) != 0;
}

// The piece that begins at t0, at most up to t1; if it is asked for, with the depth before it.
AIRLIGHT_FN AirlightPiece airlightMakePiece(
  AIRLIGHT_MEDIA_IN real3 origin, real3 direction, real t0, real t1, bool hasDepth)
{
  real after = airlightAfter(t0);
  AirlightPiece piece;
  piece.from = t0;
  piece.to = t1;
  piece.inside = 0;
  piece.depth = real3(real(0.0));
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    real3 at = airlightPathAt(
      airlightMedia.item[i], AIRLIGHT_IS_SURFACE(i), origin, direction, t0, after, hasDepth);
    piece.depth += airlightMedia.item[i].sigmaT * at.x;
    piece.to = min(piece.to, at.y);
    piece.inside = at.z > real(0.5) ? piece.inside | (1 << i) : piece.inside;
  }
#ifdef AIRLIGHT_HAS_VOLUMES
  // From there on a volume is on the way to lights.
  for (int i = AIRLIGHT_MEDIUM_COUNT; i < AIRLIGHT_DIMMING_COUNT; i++)
  {
    real3 at =
      airlightPathAt(airlightMedia.item[i], false, origin, direction, t0, after, false);
    piece.to = min(piece.to, at.y);
  }
#endif
  return piece;
}

AIRLIGHT_FN AirlightPiece airlightPieceAt(
  AIRLIGHT_MEDIA_IN real3 origin, real3 direction, real t0, real t1)
{
  return airlightMakePiece(AIRLIGHT_MEDIA_OUT origin, direction, t0, t1, true);
}

// The same where the optical depth before t0 is known.
AIRLIGHT_FN AirlightPiece airlightPieceFrom(
  AIRLIGHT_MEDIA_IN real3 origin, real3 direction, real t0, real t1, real3 depth)
{
  AirlightPiece piece = airlightMakePiece(AIRLIGHT_MEDIA_OUT origin, direction, t0, t1, false);
  piece.depth = depth;
  return piece;
}

// The length of [t0, t1] of a ray that is inside media, all of it where there is one convex region:
// then the ray's range is that region's.
AIRLIGHT_FN real airlightLengthInside(
  AIRLIGHT_MEDIA_IN real3 origin, real3 direction, real t0, real t1)
{
  if (AIRLIGHT_MEDIUM_COUNT == 1 && !AIRLIGHT_IS_SURFACE(0))
  {
    return t1 - t0;
  }
  real sum = real(0.0);
  while (t0 < t1)
  {
    AirlightPiece piece =
      airlightMakePiece(AIRLIGHT_MEDIA_OUT origin, direction, t0, t1, false);
    sum += piece.inside != 0 ? piece.to - piece.from : real(0.0);
    t0 = piece.to;
  }
  return sum;
}

// How far from the piece's beginning each channel counts: until nothing is left of its light in any
// medium, or of every medium that it sees.
AIRLIGHT_FN real3 airlightChannelLengths(
  AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightPiece) piece, real3 origin, real3 direction)
{
#ifdef AIRLIGHT_DOUBLE
  const real depth = real(40.0);
#else
  const real depth = real(20.0);
#endif
  real3 point = origin + piece.from * direction;
  real3 faded = real3(real(AIRLIGHT_FAR));
  real3 thinned = real3(real(0.0)); // a channel that is clear and dark adds nothing
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    bool holds = airlightPieceHolds(piece, i);
    if (holds && AIRLIGHT_DENSITY_KIND(airlightMedia.item[i]) == AIRLIGHT_DENSITY_GRID)
    {
      // It may be clear here and dense further on.
      return real3(piece.to - piece.from);
    }
    for (int channel = 0; channel < 3 && holds; channel++)
    {
      real sigma = airlightMedia.item[i].sigmaT[channel];
      if (sigma > real(0.0) || airlightMedia.item[i].emission[channel] > real(0.0))
      {
        faded[channel] = min(faded[channel],
          airlightFadingLength(airlightMedia.item[i], point, direction, sigma, depth));
        thinned[channel] = max(thinned[channel],
          airlightThinningLength(airlightMedia.item[i], point, direction, sigma));
      }
    }
  }
  return min(faded, thinned);
}

// Where in the piece no channel counts any more, or the piece's end.
AIRLIGHT_FN real airlightNegligibleFrom(
  AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightPiece) piece, real3 origin, real3 direction)
{
  real3 lengths = airlightChannelLengths(AIRLIGHT_MEDIA_OUT piece, origin, direction);
  return min(piece.to, piece.from + max(lengths.x, max(lengths.y, lengths.z)));
}

// The first t in (t0, t1), else t1, at which a channel ends that counts on a small part of it only:
// panels for the others would not see it.
AIRLIGHT_FN real airlightNextChannelEnd(
  AIRLIGHT_IN(AirlightPiece) piece, real3 lengths, real t0, real t1)
{
  real reach = t1 - t0;
  for (int channel = 0; channel < 3; channel++)
  {
    real t = piece.from + lengths[channel];
    t1 = t > t0 && t < t1 && t - t0 < real(0.125) * reach ? t : t1;
  }
  return t1;
}

// Optical depth before t, which lies in the piece, but for rounding: dense fog makes a large depth
// below 0 of a length below 0.
AIRLIGHT_FN real3 airlightDepthInPiece(
  AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightPiece) piece, real3 origin, real3 direction, real t)
{
  real3 depth = piece.depth;
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    if (airlightPieceHolds(piece, i))
    {
      depth += airlightMedia.item[i].sigmaT *
        airlightInsideDepth(
          airlightMedia.item[i], origin, direction, piece.from, max(t, piece.from));
    }
  }
  return depth;
}

// The first t in (t0, t1), else t1, at which a ray enters or leaves what counts of a medium whose
// density falls with height (airlightLayerEnd); toLight: (0, 0, 0) for lights at a place.
AIRLIGHT_FN real airlightNextLayerEnd(
  AIRLIGHT_MEDIA_IN real3 origin, real3 direction, real2 part, real3 toLight, real t0, real t1)
{
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    real dim = airlightDimHeight(airlightMedia.item[i], toLight);
    t1 = airlightLayerEnd(airlightMedia.item[i], origin, direction, part, dim, t0, t1);
  }
  return t1;
}
