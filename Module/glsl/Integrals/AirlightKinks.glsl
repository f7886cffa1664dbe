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

// The first kink in (t0, t1), a little after t0 at least, else t1.
AIRLIGHT_FN real airlightNextKink(AIRLIGHT_IN(AirlightMedia) media, AIRLIGHT_IN(AirlightWay) way,
  real t0, real t1)
{
  t0 += real(1e-6) * (t1 - t0);
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    t1 = airlightRegionKink(media.item[i].region, way, AIRLIGHT_MEDIUM_COUNT > 1, t0, t1);
  }
  return t1;
}
