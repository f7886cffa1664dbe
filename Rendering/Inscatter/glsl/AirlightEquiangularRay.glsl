// A ray between the boundaries of shadows by AirlightEquiangular.glsl.

#ifdef AIRLIGHT_ISOTROPIC

// From boundary to boundary. One loop, in which each pass ends at a boundary or where the nodes
// end: loops in loops take software renderers longer than what is in them, as all that they leave
// as it is has to be kept for the pixels that have left.
void airlightEquiangularRay(AirlightRay ray, inout AirlightEquiangularPixel pixel)
{
  AirlightEquiangular arc = airlightEquiangularFrom(media.item[0], ray, ray.lit.x);
  float least = airlightLeastDepthPerTangent(media.item[0], arc.h);
  float reach = airlightHalfAngleReach(arc, ray, ray.lit.y);
  float from = ray.lit.x;
  AirlightCounts shadows = airlightStartCounts();
  airlightBeginEquiangular(ray, from, shadows, pixel);
  bool lit = airlightPassing(shadows);
  float litLength = lit ? -from : 0.0;
  AirlightSpectrum sum = AirlightSpectrum(0.0);
  float done = 0.0;
  bool open = false; // what is left is taken in closed form
  bool more = true;
  float boundary;
  AirlightCounts weight;
  bool ends = airlightNextBoundary(boundary, weight) == AIRLIGHT_END;
  for (int left = pixel.boundaries + AIRLIGHT_MAXIMUM_PANELS; more && left > 0; left--)
  {
    float t = ends ? ray.lit.y : clamp(boundary, ray.lit.x, ray.lit.y);
    float to = clamp(airlightHalfAngleReach(arc, ray, t), done, reach);
    open = ends && least * (to - done) > AIRLIGHT_NEGLIGIBLE_DEPTH;
    bool shines = lit && least * done <= AIRLIGHT_NEGLIGIBLE_DEPTH;
    float next = shines ? min(done + airlightHalfAngleStep(media.item[0], arc, done), to) : to;
    sum += shines && !open ? airlightHalfAnglePanel(arc, done, next) : AirlightSpectrum(0.0);
    done = open ? done : next;
    more = !open && !(ends && next >= to);
    if (!ends && next >= to)
    {
      shadows = airlightAdd(shadows, weight);
      bool was = lit;
      lit = airlightPassing(shadows);
      litLength += was == lit ? 0.0 : lit ? -t : t;
      ends = airlightNextBoundary(boundary, weight) == AIRLIGHT_END;
    }
  }
  sum *= airlightPhaseHalves(media.item[0].phase, 0.5, 0.5);
  if (open && lit)
  {
    sum += airlightEquiangularRest(media.item[0], arc, done);
  }
  pixel.litLength = max(litLength + (lit ? ray.lit.y : 0.0), 0.0);
#if AIRLIGHT_WHOLE
  AirlightSpectrum all = airlightEquiangular(media.item[0], ray, ray.lit.x, ray.lit.y);
#else
  AirlightSpectrum all = AirlightSpectrum(0.0);
#endif
  pixel.whole = airlightEquiangularLight(light, ray, all);
  pixel.sum = airlightEquiangularLight(light, ray, max(sum, AirlightSpectrum(0.0)));
}

#else

// Part by part, and in each its boundaries.
void airlightEquiangularRay(AirlightRay ray, inout AirlightEquiangularPixel pixel)
{
  AirlightEquiangular arc = airlightEquiangularRange(media.item[0], ray, ray.lit.x, ray.lit.y);
  float from = ray.lit.x;
  AirlightCounts shadows = airlightStartCounts();
  airlightBeginEquiangular(ray, from, shadows, pixel);
  bool lit = airlightPassing(shadows);
  float litLength = lit ? -from : 0.0;
  AirlightSpectrum all = AirlightSpectrum(0.0);
  AirlightSpectrum sum = AirlightSpectrum(0.0);
  float psi = 0.0;
  float t;
  AirlightCounts weight;
  bool ends = airlightNextBoundary(t, weight) == AIRLIGHT_END;
  float at = airlightAngleAt(arc, ray, t);
  for (int i = 0; i < AIRLIGHT_MAXIMUM_PANELS && psi < arc.end; i++)
  {
    float end = airlightEquiangularPanelEnd(media.item[0], arc, psi);
    AirlightEquiangularPanel part = airlightEquiangularPanel(media.item[0], arc, psi, end);
    psi = end;
    // The last part takes what lies beyond the ray's end, too.
    while (!ends && (at <= end || end >= arc.end))
    {
      shadows = airlightAdd(shadows, weight);
      bool next = airlightPassing(shadows);
      AirlightSpectrum before = airlightEquiangularPanelTo(part, at);
      float parameter = clamp(t, ray.lit.x, ray.lit.y);
      float turns = lit == next ? 0.0 : next ? -1.0 : 1.0;
      sum += turns * before;
      litLength += turns * parameter;
      lit = next;
      ends = airlightNextBoundary(t, weight) == AIRLIGHT_END;
      at = airlightAngleAt(arc, ray, t);
    }
    AirlightSpectrum full = part.whole + part.whole;
    all += full;
    sum += lit ? full : AirlightSpectrum(0.0);
  }
  pixel.litLength = max(litLength + (lit ? ray.lit.y : 0.0), 0.0);
  pixel.whole = airlightEquiangularLight(light, ray, all);
  pixel.sum = airlightEquiangularLight(light, ray, max(sum, AirlightSpectrum(0.0)));
}

#endif
