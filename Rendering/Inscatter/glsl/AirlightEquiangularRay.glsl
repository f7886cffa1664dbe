// A point light's airlight before a pixel by AirlightEquiangular.glsl.

struct AirlightEquiangularPixel
{
  vec3 sum;   // what is lit, as radiance
  vec3 whole; // what would be without shadows; where that is recorded
  float litLength;
  int boundaries;
  bool surfaceLit;
};

// Below, the boundaries' distances have this unit; all that depends on the pixel's boundaries
// alone is there.
#ifdef AIRLIGHT_ISOTROPIC

// From boundary to boundary. One loop, in which each pass ends at a boundary or where the nodes
// end: loops in loops take software renderers longer than what is in them, as all that they leave
// as it is has to be kept for the pixels that have left.
void airlightEquiangularRay(AirlightRay ray, float unit, inout AirlightEquiangularPixel pixel)
{
  AirlightEquiangular arc = airlightEquiangularFrom(media.item[0], ray, ray.lit.x);
  float least = airlightLeastDepthPerTangent(media.item[0], arc.h);
  float reach = airlightHalfAngleReach(arc, ray, ray.lit.y);
  int shadows = startCount;
  bool lit = shadows <= 0;
  float litLength = lit ? -ray.lit.x : 0.0;
  AirlightSpectrum sum = AirlightSpectrum(0.0);
  float done = 0.0;
  bool open = false; // what is left is taken in closed form
  bool more = true;
  uint boundary = airlightNextPacked();
  for (int left = pixel.boundaries + AIRLIGHT_MAXIMUM_PANELS; more && left > 0; left--)
  {
    bool ends = packedLeft < 0;
    float t =
      ends ? ray.lit.y : clamp(unit * airlightPackedDistance(boundary), ray.lit.x, ray.lit.y);
    float to = clamp(airlightHalfAngleReach(arc, ray, t), done, reach);
    open = ends && least * (to - done) > AIRLIGHT_NEGLIGIBLE_DEPTH;
    bool shines = lit && least * done <= AIRLIGHT_NEGLIGIBLE_DEPTH;
    float next = shines ? min(done + airlightHalfAngleStep(media.item[0], arc, done), to) : to;
    sum += shines && !open ? airlightHalfAnglePanel(arc, done, next) : AirlightSpectrum(0.0);
    done = open ? done : next;
    more = !open && !(ends && next >= to);
    if (!ends && next >= to)
    {
      shadows += airlightPackedWeight(boundary);
      bool was = lit;
      lit = shadows <= 0;
      litLength += was == lit ? 0.0 : lit ? -t : t;
      boundary = airlightNextPacked();
    }
  }
  sum *= airlightPhaseHalves(media.item[0].phase, 0.5, 0.5);
  if (open && lit)
  {
    sum += airlightEquiangularRest(media.item[0], arc, done);
  }
  pixel.litLength = max(litLength + (lit ? ray.lit.y : 0.0), 0.0);
#ifdef AIRLIGHT_RECORD
  AirlightSpectrum all = airlightEquiangular(media.item[0], ray, ray.lit.x, ray.lit.y);
#else
  AirlightSpectrum all = AirlightSpectrum(0.0);
#endif
  pixel.whole = airlightEquiangularLight(light, ray, all);
  pixel.sum = airlightEquiangularLight(light, ray, max(sum, AirlightSpectrum(0.0)));
}

#else

// Part by part, and in each its boundaries.
void airlightEquiangularRay(AirlightRay ray, float unit, inout AirlightEquiangularPixel pixel)
{
  AirlightEquiangular arc = airlightEquiangularRange(media.item[0], ray, ray.lit.x, ray.lit.y);
  int shadows = startCount;
  bool lit = shadows <= 0;
  float litLength = lit ? -ray.lit.x : 0.0;
  AirlightSpectrum all = AirlightSpectrum(0.0);
  AirlightSpectrum sum = AirlightSpectrum(0.0);
  float psi = 0.0;
  uint boundary = airlightNextPacked();
  float t = unit * airlightPackedDistance(boundary);
  float at = airlightAngleAt(arc, ray, t);
  for (int i = 0; i < AIRLIGHT_MAXIMUM_PANELS && psi < arc.end; i++)
  {
    float end = airlightEquiangularPanelEnd(media.item[0], arc, psi);
    AirlightEquiangularPanel part = airlightEquiangularPanel(media.item[0], arc, psi, end);
    psi = end;
    // The last part takes what lies beyond the ray's end, too.
    while (packedLeft >= 0 && (at <= end || end >= arc.end))
    {
      shadows += airlightPackedWeight(boundary);
      bool next = shadows <= 0;
      AirlightSpectrum before = airlightEquiangularPanelTo(part, at);
      float parameter = clamp(t, ray.lit.x, ray.lit.y);
      float turns = lit == next ? 0.0 : next ? -1.0 : 1.0;
      sum += turns * before;
      litLength += turns * parameter;
      lit = next;
      boundary = airlightNextPacked();
      t = unit * airlightPackedDistance(boundary);
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

// Of pixel p, whose ray ends at `surface` on the boundaries' unit, where that is not below 0. False
// where its boundaries are elsewhere.
bool airlightEquiangularPixel(vec2 p, float unit, float surface, out AirlightEquiangularPixel pixel)
{
  pixel = AirlightEquiangularPixel(vec3(0.0), vec3(0.0), 0.0, 0, false);
  if (!airlightOpenPacked(ivec2(p), surface >= 0.0 ? surface : 1e37))
  {
    return false;
  }
  pixel.boundaries = packedLeft;
  pixel.surfaceLit = startCount + packedWeights <= 0;
  vec3 origin = airlightOrigin(p);
  vec3 direction = airlightDirection(p) / unit;
  AirlightRay ray = airlightRayBeside(media, light, origin, direction,
    surface >= 0.0 ? unit * surface : AIRLIGHT_FAR,
    airlightOwnMoment(0, p, unit, light, origin, direction));
  airlightEquiangularRay(ray, unit, pixel);
  return true;
}
