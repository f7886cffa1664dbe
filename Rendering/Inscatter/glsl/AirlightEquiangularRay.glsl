// A ray between the boundaries of shadows by AirlightEquiangular.glsl.

#ifdef AIRLIGHT_ISOTROPIC

// From boundary to boundary. One loop, in which each pass ends at a boundary or where the nodes
// end: loops in loops take software renderers longer than what is in them, as all that they leave
// as it is has to be kept for the pixels that have left.
void airlightEquiangularRay(AirlightRay ray, inout AirlightEquiangularPixel pixel)
{
  AirlightEquiangular arc = airlightEquiangularFrom(airlightMedia.item[0], ray, ray.lit.x);
  float least = airlightLeastDepthPerTangent(airlightMedia.item[0], arc.h);
  float reach = airlightHalfAngleReach(arc, ray, ray.lit.y);
  AirlightRayShadows shadows = airlightBeginEquiangular(ray, pixel);
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
    bool shines = shadows.lit && least * done <= AIRLIGHT_NEGLIGIBLE_DEPTH;
    float next =
      shines ? min(done + airlightHalfAngleStep(airlightMedia.item[0], arc, done), to) : to;
    sum += shines && !open ? airlightHalfAnglePanel(arc, done, next) : AirlightSpectrum(0.0);
    done = open ? done : next;
    more = !open && !(ends && next >= to);
    if (!ends && next >= to)
    {
      airlightCross(ray, t, weight, shadows);
      ends = airlightNextBoundary(boundary, weight) == AIRLIGHT_END;
    }
  }
  sum *= airlightPhaseHalves(airlightMedia.item[0].phase, 0.5, 0.5);
  if (open && shadows.lit)
  {
    sum += airlightEquiangularRest(airlightMedia.item[0], arc, done);
  }
#if AIRLIGHT_WHOLE
  AirlightSpectrum all = airlightEquiangular(airlightMedia.item[0], ray, ray.lit.x, ray.lit.y);
#else
  AirlightSpectrum all = AirlightSpectrum(0.0);
#endif
  airlightFinishEquiangular(ray, shadows, all, sum, pixel);
}

#else

// Part by part, and in each its boundaries.
void airlightEquiangularRay(AirlightRay ray, inout AirlightEquiangularPixel pixel)
{
  AirlightEquiangular arc =
    airlightEquiangularRange(airlightMedia.item[0], ray, ray.lit.x, ray.lit.y);
  AirlightRayShadows shadows = airlightBeginEquiangular(ray, pixel);
  AirlightSpectrum all = AirlightSpectrum(0.0);
  AirlightSpectrum sum = AirlightSpectrum(0.0);
  float psi = 0.0;
  float t;
  AirlightCounts weight;
  bool ends = airlightNextBoundary(t, weight) == AIRLIGHT_END;
  float at = airlightAngleAt(arc, ray, t);
  for (int i = 0; i < AIRLIGHT_MAXIMUM_PANELS && psi < arc.end; i++)
  {
    float end = airlightEquiangularPanelEnd(airlightMedia.item[0], arc, psi);
    AirlightEquiangularPanel part = airlightEquiangularPanel(airlightMedia.item[0], arc, psi, end);
    psi = end;
    // The last part takes what lies beyond the ray's end, too.
    while (!ends && (at <= end || end >= arc.end))
    {
      bool was = shadows.lit;
      airlightCross(ray, t, weight, shadows);
      float turns = was == shadows.lit ? 0.0 : shadows.lit ? -1.0 : 1.0;
      sum += turns * airlightEquiangularPanelTo(part, at);
      ends = airlightNextBoundary(t, weight) == AIRLIGHT_END;
      at = airlightAngleAt(arc, ray, t);
    }
    AirlightSpectrum full = part.whole + part.whole;
    all += full;
    sum += shadows.lit ? full : AirlightSpectrum(0.0);
  }
  airlightFinishEquiangular(ray, shadows, all, sum, pixel);
}

#endif
