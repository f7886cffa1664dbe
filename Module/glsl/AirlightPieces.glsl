// Quadrature piece by piece of a ray.

// A part of a piece without kinks.
AIRLIGHT_FN real3 airlightQuadraturePart(AIRLIGHT_IN(AirlightMedia) media,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray,
  AIRLIGHT_IN(AirlightPiece) piece, real t0, real t1)
{
  real x0 = t0 - ray.range.x - ray.foot.tL;
  real x1 = t1 - ray.range.x - ray.foot.tL;
  bool straight = airlightIsDirectional(light) ||
    x1 - x0 < real(0.05) * max(abs(x0), ray.foot.h);
  real v0 = straight ? t0 : airlightAsinh(x0 / ray.foot.h);
  real v1 = straight ? t1 : airlightAsinh(x1 / ray.foot.h);
#if AIRLIGHT_HAS_PHOTOMETRY
  if (light.goniometric != 0)
  {
    return airlightGoniometricPiece(media, light, ray, piece, straight, v0, v1);
  }
#endif
  int panels = straight ? 2 : airlightPanelCount(v1 - v0, real(1.0));
#if AIRLIGHT_HAS_SURFACE
  // The way to the light can pass a corner of a surface on so short a part of the ray that no node
  // of larger panels sees it.
  panels = AIRLIGHT_FEW_ROUNDS ? panels * AIRLIGHT_SURFACE_PANELS : 1;
#endif
  real3 sum = real3(real(0.0));
  real3 doubt = real3(real(0.0));
  for (int i = 0; i < panels; i++)
  {
    real a = v0 + (v1 - v0) * real(i) / real(panels);
    real b = v0 + (v1 - v0) * real(i + 1) / real(panels);
    real3 part;
    sum += airlightPanel(media, light, ray, piece, straight, a, b, part);
    doubt += part;
  }
  return any(greaterThan(doubt, real(2.0 * AIRLIGHT_PANEL_TOLERANCE) * sum))
    ? airlightHalvedPanels(media, light, ray, piece, straight, v0, v1, panels, sum)
    : sum;
}

// In dense media light may fade so fast, on the ray or before it, that no node of a part without kinks
// would see any: what counts then lies at one of its ends.
struct AirlightSkin
{
  bool atEnd;  // of the part, not at its beginning
  real3 depth; // of each channel, as a length
};

// Optical depths that are seen by the nodes of a part, and of a skin.
#define AIRLIGHT_SEEN_DEPTH 200.0
#define AIRLIGHT_SKIN_DEPTH 100.0

AIRLIGHT_FN AirlightSkin airlightSkin(AIRLIGHT_IN(AirlightMedia) media,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray,
  AIRLIGHT_IN(AirlightPiece) piece, real t0, real t1)
{
  AirlightSkin skin;
  skin.atEnd = false;
  skin.depth = real3(t1 - t0);
  real3 least = real3(real(0.0));
  real length = t1 - t0;
  // At t0, at t1, and nearer and nearer to the less deep of them.
  for (int i = 0; i < 24 && AIRLIGHT_FEW_ROUNDS; i++)
  {
    real t = i == 0 ? t0 : (skin.atEnd ? t1 - length : t0 + length);
    real3 point = ray.origin + t * ray.direction;
    real3 depth = airlightDepthInPiece(media, piece, ray.origin, ray.direction, t) +
      (airlightIsDirectional(light) ? AIRLIGHT_SUN_DEPTH(media, light, point)
                                    : AIRLIGHT_LAMP_DEPTH(media, light, point));
    real3 more = depth - least;
    if (i == 0)
    {
      least = depth;
      continue;
    }
    if (i == 1 && more.x + more.y + more.z < real(0.0))
    {
      skin.atEnd = true;
      least = depth;
      more = -more;
    }
    skin.depth = mix(skin.depth, real3(length), greaterThan(more, real3(real(AIRLIGHT_SKIN_DEPTH))));
    if (!any(greaterThan(more, real3(real(AIRLIGHT_SEEN_DEPTH)))))
    {
      break;
    }
    length *= real(0.25);
  }
  return skin;
}

// The first end of a channel's skin after t, in the part that ends at t1 and began at t0, else t1.
AIRLIGHT_FN real airlightSkinEnd(AIRLIGHT_IN(AirlightSkin) skin, real t0, real t, real t1)
{
  real3 ends = skin.atEnd ? real3(t1) - skin.depth : real3(t0) + skin.depth;
  real end = t1;
  for (int i = 0; i < 3; i++)
  {
    end = ends[i] > t && ends[i] < end ? ends[i] : end;
  }
  return end;
}

// The integral over [t0, t1], sigmaS included.
AIRLIGHT_FN real3 airlightQuadrature(AIRLIGHT_IN(AirlightMedia) media,
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
  AirlightWay way = airlightWay(light, ray);
  real3 sum = real3(real(0.0));
  while (t0 < t1)
  {
    AirlightPiece piece = airlightPieceAt(media, ray.origin, ray.direction, t0, t1);
    if (piece.inside != 0)
    {
      // What lies beyond no longer counts.
      real end = airlightFadedAt(media, piece, ray.origin, ray.direction);
      real from = piece.from;
      while (from < end)
      {
        real to = airlightNextKink(media, way, from, end);
        to = airlightNextLayerEnd(media, ray.origin, ray.direction, real2(piece.from, end),
          airlightToSun(light), from, to);
        AirlightSkin skin = airlightSkin(media, light, ray, piece, from, to);
        for (real t = from; t < to;)
        {
          real next = airlightSkinEnd(skin, from, t, to);
          sum += airlightQuadraturePart(media, light, ray, piece, t, next);
          t = next;
        }
        from = to;
      }
    }
    t0 = piece.to;
  }
  return sum;
}
