// Quadrature piece by piece of a ray.

// How many panels a part has at first, by what one of them covers of v, and of a straight part. In
// shaders eight nodes find out themselves where these are too few; not of what a panel may miss
// altogether, the peak of a spot or a corner of a surface.
#if defined(AIRLIGHT_NO_CONE) && !AIRLIGHT_HAS_SURFACE
#define AIRLIGHT_PANEL_WIDTH 1.5
#define AIRLIGHT_STRAIGHT_PANELS 1
#else
#define AIRLIGHT_PANEL_WIDTH 1.0
#define AIRLIGHT_STRAIGHT_PANELS 2
#endif

// The panels from v0 to v1; where their sum turns out not to be good enough, again, and a panel
// whose nodes are too few is then halved, which finds the kinks.
AIRLIGHT_FN real3 airlightPanels(AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light,
  AIRLIGHT_IN(AirlightRay) ray, AIRLIGHT_IN(AirlightPiece) piece, bool straight, real v0, real v1,
  int panels)
{
  real width = (v1 - v0) / real(panels);
  real3 limit = real3(real(0.0)); // of a panel's error, the second time
  real3 sum = real3(real(0.0));
  // Bounded, so that every driver ends: at first there are at most 122 panels, and where nothing is
  // halved any more as many reach the end.
  int most = panels;
  for (int pass = 0; pass < AIRLIGHT_ROLLED(2); pass++)
  {
    real3 errorEstimate = real3(real(0.0));
    real step = width;
    real a = v0;
    sum = real3(real(0.0));
    for (int i = 0; i < most && a < v1; i++)
    {
      // The last one may be a rounding error wide.
      bool ends = v1 - a < real(1.01) * step || (pass == 0 && i == most - 1);
      real b = ends ? v1 : a + step;
      real3 part;
      real3 value = airlightPanel(AIRLIGHT_MEDIA_OUT light, ray, piece, straight, a, b, true, part);
      // Written so that what is not a number ends it, too.
      if (pass > 0 && any(greaterThan(part, limit)) && step > width * real(1.0 / 512.0) &&
        step > real(AIRLIGHT_NARROWEST) * abs(a) && AIRLIGHT_MAY_TRY)
      {
        step *= real(0.5);
      }
      else
      {
        sum += value;
        errorEstimate += part;
        a = b;
        step = min(real(2.0) * step, width);
      }
    }
    if (!any(greaterThan(errorEstimate, real(2.0 * AIRLIGHT_PANEL_TOLERANCE) * sum)))
    {
      return sum;
    }
    limit = real(AIRLIGHT_PANEL_TOLERANCE) * sum;
    most = AIRLIGHT_MOST_TRIES + 150;
  }
  return sum;
}

// A part of a piece without kinks.
AIRLIGHT_FN real3 airlightQuadraturePart(AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light,
  AIRLIGHT_IN(AirlightRay) ray, AIRLIGHT_IN(AirlightPiece) piece, real t0, real t1)
{
  real x0 = airlightFromFoot(ray, t0);
  real x1 = airlightFromFoot(ray, t1);
  bool straight = airlightIsDirectional(light) ||
    x1 - x0 < real(0.05) * max(abs(x0), ray.foot.h);
  real v0 = straight ? t0 : airlightAsinh(x0 / ray.foot.h);
  real v1 = straight ? t1 : airlightAsinh(x1 / ray.foot.h);
#if AIRLIGHT_HAS_PHOTOMETRY
  if (light.goniometric != 0)
  {
    return airlightGoniometricPiece(AIRLIGHT_MEDIA_OUT light, ray, piece, straight, v0, v1);
  }
#endif
  int panels = straight ? AIRLIGHT_STRAIGHT_PANELS
                        : airlightPanelCount(v1 - v0, real(AIRLIGHT_PANEL_WIDTH));
#if AIRLIGHT_HAS_SURFACE
  // The way to the light can pass a corner of a surface on so short a part of the ray that no node
  // of larger panels sees it.
  panels = AIRLIGHT_FEW_ROUNDS ? panels * AIRLIGHT_SURFACE_PANELS : 1;
#endif
  return airlightPanels(AIRLIGHT_MEDIA_OUT light, ray, piece, straight, v0, v1, panels);
}

// The integral over [t0, t1], sigmaS included.
AIRLIGHT_FN real3 airlightQuadrature(AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light,
  AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
  AirlightWay way = airlightWay(light, ray);
  real3 sum = real3(real(0.0));
  while (t0 < t1)
  {
    AirlightPiece piece = airlightPieceAt(AIRLIGHT_MEDIA_OUT ray.origin, ray.direction, t0, t1);
    if (piece.inside != 0)
    {
      // What lies beyond no longer counts.
      real3 lengths = airlightChannelLengths(AIRLIGHT_MEDIA_OUT piece, ray.origin, ray.direction);
      real end = min(piece.to, piece.from + max(lengths.x, max(lengths.y, lengths.z)));
      real from = piece.from;
      while (from < end)
      {
        real to = airlightNextKink(AIRLIGHT_MEDIA_OUT way, from, end);
        to = airlightNextLayerEnd(AIRLIGHT_MEDIA_OUT ray.origin, ray.direction,
          real2(piece.from, end), airlightToSun(light), from, to);
        to = airlightNextChannelEnd(piece, lengths, from, to);
        sum += airlightQuadraturePart(AIRLIGHT_MEDIA_OUT light, ray, piece, from, to);
        from = to;
      }
    }
    t0 = piece.to;
  }
  return sum;
}
