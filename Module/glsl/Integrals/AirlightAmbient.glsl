// Ambient radiance that media scatter into a ray, and what they emit: exact for one medium and for
// uniform ones, otherwise by Gauss-Legendre quadrature on panels that follow the integrand. Each
// panel is as long as its nodes serve the channel that changes fastest among those that still have
// light. Checked against adaptive quadrature: 1e-6 in single precision, 1e-9 in double.

// A channel is dark, and a density negligible, after so many e-foldings. A medium into which a ray
// falls is followed in steps of so many scale heights: its depth is an exponential of an
// exponential.
#ifdef AIRLIGHT_DOUBLE
#define AIRLIGHT_AMBIENT_DEPTH 40.0
#define AIRLIGHT_AMBIENT_HEIGHTS 36.0
#define AIRLIGHT_AMBIENT_FALL 3.0
#else
#define AIRLIGHT_AMBIENT_DEPTH 20.0
#define AIRLIGHT_AMBIENT_HEIGHTS 14.0
#define AIRLIGHT_AMBIENT_FALL 1.5
#endif
// Thirty-four were the most in 6 000 random settings; a bound for the sake of drivers.
#define AIRLIGHT_AMBIENT_PANELS 64

// x: how fast a medium changes the integrand per unit of length at t, for a channel of extinction
// sigma > 0; y: how long a panel from there may be. The ray ends at `end`.
AIRLIGHT_FN real2 airlightAmbientScale(AIRLIGHT_IN(AirlightMedium) medium, real3 origin,
  real3 direction, real sigma, real t, real end)
{
  real3 point = origin + t * direction;
  real rate = sigma * airlightDensity(medium, point);
  if (AIRLIGHT_DENSITY_KIND(medium) == AIRLIGHT_DENSITY_GRID)
  {
    return real2(
      max(rate, sigma * airlightDensity(medium, origin + end * direction)), real(AIRLIGHT_FAR));
  }
  real rise = AIRLIGHT_DENSITY_KIND(medium) == AIRLIGHT_DENSITY_HEIGHT
    ? airlightRise(medium, direction)
    : real(0.0);
  if (rise >= real(0.0))
  {
    bool counts = rise * t < real(AIRLIGHT_AMBIENT_HEIGHTS);
    return real2(counts ? rate + rise : rate, real(AIRLIGHT_FAR));
  }
  // High above the end, and above the height at which the depth begins to count, it is negligible.
  real column = log(sigma / -rise) - airlightScaleHeights(medium, point);
  real above = min((t - end) * rise, -column) - real(AIRLIGHT_AMBIENT_HEIGHTS);
  return real2(rate, max(above, real(AIRLIGHT_AMBIENT_FALL)) / -rise);
}

// How long a panel from t may be for one channel, which has light there.
AIRLIGHT_FN real airlightAmbientReach(AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightPiece) piece,
  real3 origin, real3 direction, int channel, real t, real end)
{
  real reach = end - t;
  real rate = real(0.0);
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    real sigma = airlightMedia.item[i].sigmaT[channel];
    bool shines = airlightSource(airlightMedia.item[i], direction)[channel] > real(0.0);
    if (airlightPieceHolds(piece, i) && (sigma > real(0.0) || shines))
    {
      // A density that does not dim is followed, too, where it shines.
      real2 scale = airlightAmbientScale(
        airlightMedia.item[i], origin, direction, max(sigma, real(1e-30)), t, end);
      rate += scale.x;
      reach = min(reach, scale.y);
    }
  }
  return rate * reach > real(AIRLIGHT_GAUSS_COUNT) ? real(AIRLIGHT_GAUSS_COUNT) / rate : reach;
}

// Where the panel that begins at t ends.
AIRLIGHT_FN real airlightAmbientPanelEnd(AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightPiece) piece,
  real3 origin, real3 direction, real t, real end)
{
  real3 depth = airlightDepthInPiece(AIRLIGHT_MEDIA_OUT piece, origin, direction, t);
  real reach = end - t;
  for (int channel = 0; channel < 3; channel++)
  {
    if (depth[channel] < piece.depth[channel] + real(AIRLIGHT_AMBIENT_DEPTH))
    {
      reach = min(reach,
        airlightAmbientReach(AIRLIGHT_MEDIA_OUT piece, origin, direction, channel, t, end));
    }
  }
  return reach < end - t ? t + reach : end;
}

// What is scattered on [from, to] of a piece and reaches the ray's origin.
AIRLIGHT_FN real3 airlightAmbientPanel(AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightPiece) piece,
  real3 origin, real3 direction, real from, real to)
{
  real3 sum = real3(real(0.0));
  real middle = real(0.5) * (from + to);
  real halfLength = real(0.5) * (to - from);
  for (int k = 0; k < AIRLIGHT_ROLLED(AIRLIGHT_GAUSS_COUNT); k++)
  {
    real2 node = airlightGaussNode(k / 2);
    real t = middle + (k % 2 == 0 ? halfLength : -halfLength) * node.x;
    real3 source = real3(real(0.0));
    for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
    {
      if (airlightPieceHolds(piece, i))
      {
        real3 point = origin + t * direction;
        source += airlightSourceAt(airlightMedia.item[i], point, direction) *
          airlightDensity(airlightMedia.item[i], point);
      }
    }
    real3 depth = airlightDepthInPiece(AIRLIGHT_MEDIA_OUT piece, origin, direction, t);
    sum += node.y * source * exp(-depth);
  }
  return halfLength * sum;
}

// Of a piece in which densities vary.
AIRLIGHT_FN real3 airlightAmbientByPanels(
  AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightPiece) piece, real3 origin, real3 direction)
{
  // From the piece's own beginning: far away, an opaque medium is thinner than the last place of t.
  real3 start = origin + piece.from * direction;
  AirlightPiece own = piece;
  own.from = real(0.0);
  own.to = piece.to - piece.from;
  real end = airlightNegligibleFrom(AIRLIGHT_MEDIA_OUT own, start, direction);
  real3 sum = real3(real(0.0));
  real from = real(0.0);
  for (int panel = 0; panel < AIRLIGHT_AMBIENT_PANELS && from < end; panel++)
  {
    real to = airlightAmbientPanelEnd(AIRLIGHT_MEDIA_OUT own, start, direction, from, end);
    sum += airlightAmbientPanel(AIRLIGHT_MEDIA_OUT own, start, direction, from, to);
    from = to;
  }
  return sum;
}

// Of one piece of a ray.
AIRLIGHT_FN real3 airlightAmbientInPiece(
  AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightPiece) piece, real3 origin, real3 direction)
{
  bool uniformly = true;
  real3 sigmaT = real3(real(0.0));
  real3 source = real3(real(0.0));
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    if (airlightPieceHolds(piece, i))
    {
      uniformly =
        uniformly && AIRLIGHT_DENSITY_KIND(airlightMedia.item[i]) == AIRLIGHT_DENSITY_UNIFORM;
      sigmaT += airlightMedia.item[i].sigmaT;
      source += airlightSource(airlightMedia.item[i], direction);
    }
  }
  return uniformly ? source * airlightFading3(piece.depth, sigmaT, piece.to - piece.from)
                   : airlightAmbientByPanels(AIRLIGHT_MEDIA_OUT piece, origin, direction);
}

#ifdef AIRLIGHT_GRID_STEPS // AirlightGridRay.glsl
real3 airlightAmbientInImages(inout AirlightPiece piece, real3 origin, real3 direction);
#endif

// On [0, l] of a ray. One medium alone depends on its depth only, wherever it is, but for colours.
AIRLIGHT_FN real3 airlightAmbient(AIRLIGHT_MEDIA_IN real3 origin, real3 direction, real l)
{
  real3 source = real3(real(0.0));
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    source += airlightSource(airlightMedia.item[i], direction);
  }
  if (dot(source, real3(real(1.0))) <= real(0.0))
  {
    return real3(real(0.0));
  }
  if (AIRLIGHT_MEDIUM_COUNT == 1 && !AIRLIGHT_HAS_COLOURS(airlightMedia.item[0]))
  {
    real3 sigmaT = airlightMedia.item[0].sigmaT;
    real depth = airlightPathDepth(
      airlightMedia.item[0], AIRLIGHT_IS_SURFACE(0), origin, direction, l);
    return source *
      real3(airlightOpticalLength(sigmaT.x, depth), airlightOpticalLength(sigmaT.y, depth),
        airlightOpticalLength(sigmaT.z, depth));
  }
  real3 sum = real3(real(0.0));
  real t = real(0.0);
#ifdef AIRLIGHT_GRID_STEPS
  real3 before = real3(0.0); // optical depth before t
#endif
  while (t < l)
  {
#ifdef AIRLIGHT_GRID_STEPS
    AirlightPiece piece = airlightPieceFrom(origin, direction, t, l, before);
    sum += airlightAmbientInImages(piece, origin, direction);
    before = piece.depth;
#else
    AirlightPiece piece = airlightPieceAt(AIRLIGHT_MEDIA_OUT origin, direction, t, l);
    sum += airlightAmbientInPiece(AIRLIGHT_MEDIA_OUT piece, origin, direction);
#endif
    t = piece.to;
  }
  return sum;
}
