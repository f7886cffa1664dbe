// Quadrature is cut where the way from a ray to the light has a kink (airlightRegionKink()).

AIRLIGHT_FN AirlightWay airlightWay(
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray)
{
  AirlightWay way;
  way.directional = airlightIsDirectional(light);
  way.origin = way.directional ? ray.origin : ray.origin - light.position;
  way.direction = ray.direction;
  way.light = light.position;
  return way;
}

#ifdef AIRLIGHT_GRID_STEPS
// Of an image. It is a box in its own coordinates, in which straight ways stay straight.
real airlightGridKink(AirlightMedium medium, AirlightWay way, real t0, real t1)
{
  real3x3 axes = medium.grid.axes;
  bool held = airlightHolds(medium.region, way.light);
  way.origin = axes * way.origin + (way.directional ? medium.grid.start : real3(0.0));
  way.direction = axes * way.direction;
  way.light = axes * way.light + (way.directional ? real3(0.0) : medium.grid.start);
#if AIRLIGHT_DIMMING_COUNT == 1
  // No way from inside to inside leaves it.
  if (!way.directional && held && all(greaterThanEqual(way.light, real3(0.0))) &&
    all(lessThanEqual(way.light, medium.grid.last)))
  {
    return t1;
  }
#endif
  AirlightRegion box = medium.region;
  box.boxMin = real3(0.0);
  box.boxMax = medium.grid.last;
  return airlightBoxKink(box, way, t0, t1);
}
#endif

// The first kink in (t0, t1), a little after t0 at least, else t1.
AIRLIGHT_FN real airlightNextKink(AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightWay) way, real t0, real t1)
{
  t0 += real(1e-6) * (t1 - t0);
  for (int i = 0; i < AIRLIGHT_DIMMING_COUNT; i++)
  {
    t1 = airlightRegionKink(airlightMedia.item[i].region, way, AIRLIGHT_DIMMING_COUNT > 1, t0, t1);
#ifdef AIRLIGHT_GRID_STEPS
    if (AIRLIGHT_IS_GRID(i))
    {
      t1 = airlightGridKink(airlightMedia.item[i], way, t0, t1);
    }
#endif
  }
  return t1;
}
