// A point light's airlight before a pixel by AirlightTurn.glsl.

struct AirlightTurnedPixel
{
  vec3 sum;   // what is lit, as radiance
  vec3 whole; // what would be without shadows; where that is recorded
  float litLength;
  int boundaries;
  bool surfaceLit;
};

// Below, the boundaries' distances have this unit; what of the pixel hangs on the boundaries alone is there.
#ifdef AIRLIGHT_ISOTROPIC

// From boundary to boundary. One loop, in which each pass ends at a boundary or where the nodes end: loops
// in loops take software renderers longer than what is in them, as all that they leave as it is has to be
// kept for the pixels that have left.
void airlightTurnedRay(AirlightRay ray, float unit, inout AirlightTurnedPixel pixel)
{
  AirlightTurn turn = airlightTurnFrom(media.item[0], ray, ray.lit.x);
  float least = airlightTurnLeastFading(media.item[0], turn.h);
  float reach = airlightTurnReach(turn, ray, ray.lit.y);
  int shadows = startCount;
  bool lit = shadows <= 0;
  float litLength = lit ? -ray.lit.x : 0.0;
  AirlightShade sum = AirlightShade(0.0);
  float done = 0.0;
  bool open = false; // what is left is taken in closed form
  bool more = true;
  uint boundary = airlightNextPacked();
  for (int left = pixel.boundaries + AIRLIGHT_TURN_PARTS; more && left > 0; left--)
  {
    bool ends = packedLeft < 0;
    float t = ends ? ray.lit.y : clamp(unit * airlightPackedDistance(boundary), ray.lit.x, ray.lit.y);
    float to = clamp(airlightTurnReach(turn, ray, t), done, reach);
    open = ends && least * (to - done) > AIRLIGHT_TURN_FADED;
    bool shines = lit && least * done <= AIRLIGHT_TURN_FADED;
    float next = shines ? min(done + airlightTurnStep(media.item[0], turn, done), to) : to;
    sum += shines && !open ? airlightTurnStraight(turn, done, next) : AirlightShade(0.0);
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
    sum += airlightTurnRest(media.item[0], turn, done);
  }
  pixel.litLength = max(litLength + (lit ? ray.lit.y : 0.0), 0.0);
#ifdef AIRLIGHT_RECORD
  AirlightShade all = airlightTurnAll(media.item[0], ray, ray.lit.x, ray.lit.y);
#else
  AirlightShade all = AirlightShade(0.0);
#endif
  pixel.whole = airlightTurnLight(light, ray, all);
  pixel.sum = airlightTurnLight(light, ray, max(sum, AirlightShade(0.0)));
}

#else

// Part by part, and in each its boundaries.
void airlightTurnedRay(AirlightRay ray, float unit, inout AirlightTurnedPixel pixel)
{
  AirlightTurn turn = airlightTurn(media.item[0], ray, ray.lit.x, ray.lit.y);
  int shadows = startCount;
  bool lit = shadows <= 0;
  float litLength = lit ? -ray.lit.x : 0.0;
  AirlightShade all = AirlightShade(0.0);
  AirlightShade sum = AirlightShade(0.0);
  float psi = 0.0;
  uint boundary = airlightNextPacked();
  float t = unit * airlightPackedDistance(boundary);
  float at = airlightTurned(turn, ray, t);
  for (int i = 0; i < AIRLIGHT_TURN_PARTS && psi < turn.end; i++)
  {
    float end = airlightTurnPartEnd(media.item[0], turn, psi);
    AirlightTurnPart part = airlightTurnPart(media.item[0], turn, psi, end);
    psi = end;
    // The last part takes what lies beyond the ray's end, too.
    while (packedLeft >= 0 && (at <= end || end >= turn.end))
    {
      shadows += airlightPackedWeight(boundary);
      bool next = shadows <= 0;
      AirlightShade before = airlightTurnBefore(part, at);
      float place = clamp(t, ray.lit.x, ray.lit.y);
      float turns = lit == next ? 0.0 : next ? -1.0 : 1.0;
      sum += turns * before;
      litLength += turns * place;
      lit = next;
      boundary = airlightNextPacked();
      t = unit * airlightPackedDistance(boundary);
      at = airlightTurned(turn, ray, t);
    }
    AirlightShade full = part.whole + part.whole;
    all += full;
    sum += lit ? full : AirlightShade(0.0);
  }
  pixel.litLength = max(litLength + (lit ? ray.lit.y : 0.0), 0.0);
  pixel.whole = airlightTurnLight(light, ray, all);
  pixel.sum = airlightTurnLight(light, ray, max(sum, AirlightShade(0.0)));
}

#endif

// Of pixel p, whose ray ends at `surface` on the boundaries' unit, where that is not below 0. False where
// its boundaries are elsewhere.
bool airlightTurnPixel(vec2 p, float unit, float surface, out AirlightTurnedPixel pixel)
{
  pixel = AirlightTurnedPixel(vec3(0.0), vec3(0.0), 0.0, 0, false);
  if (!airlightOpenPacked(ivec2(p), surface >= 0.0 ? surface : 1e37))
  {
    return false;
  }
  pixel.boundaries = packedLeft;
  pixel.surfaceLit = startCount + packedWeights <= 0;
  vec3 origin = airlightOrigin(p);
  vec3 direction = airlightDirection(p) / unit;
  AirlightRay ray =
    airlightRayBeside(media, light, origin, direction, surface >= 0.0 ? unit * surface : AIRLIGHT_FAR,
      airlightOwnMoment(0, p, unit, light, origin, direction));
  airlightTurnedRay(ray, unit, pixel);
  return true;
}
