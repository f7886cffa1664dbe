// A point light's airlight before a pixel by AirlightTurn.glsl: part by part of the ray, and in each its
// boundaries.

struct AirlightTurnedPixel
{
  vec3 sum; // what is lit, and what would be without shadows, as radiance
  vec3 whole;
  float litLength;
  int boundaries;
  bool surfaceLit;
};

// The boundaries' distances have this unit.
AirlightTurnedPixel airlightTurnedRay(AirlightRay ray, float unit)
{
  AirlightTurnedPixel pixel;
  AirlightTurn turn = airlightTurn(media.item[0], ray, ray.lit.x, ray.lit.y);
  pixel.boundaries = keysLeft;
  pixel.surfaceLit = startCount + keysTotal <= 0;
  int shadows = startCount;
  bool lit = shadows <= 0;
  float litLength = lit ? -ray.lit.x : 0.0;
  AirlightShade all = AirlightShade(0.0);
  AirlightShade sum = AirlightShade(0.0);
  float psi = 0.0;
  uint key = airlightNextKey();
  float t = unit * airlightKeyDistance(key);
  float at = airlightTurned(turn, ray, t);
  bool closes = AIRLIGHT_TURN_CLOSES && turn.open;
  for (int i = 0; i < AIRLIGHT_TURN_PARTS && psi < turn.end && !(closes && keysLeft < 0); i++)
  {
    float end = airlightTurnPartEnd(media.item[0], turn, psi);
    AirlightTurnPart part = airlightTurnPart(media.item[0], turn, psi, end);
    psi = end;
    // The last part takes what lies beyond the ray's end, too.
    while (keysLeft >= 0 && (at <= end || end >= turn.end))
    {
      shadows += airlightKeyWeight(key);
      bool next = shadows <= 0;
      AirlightShade before = airlightTurnBefore(part, at);
      float place = clamp(t, ray.lit.x, ray.lit.y);
      float turns = lit == next ? 0.0 : next ? -1.0 : 1.0;
      sum += turns * before;
      litLength += turns * place;
      lit = next;
      key = airlightNextKey();
      t = unit * airlightKeyDistance(key);
      at = airlightTurned(turn, ray, t);
    }
    AirlightShade full = part.whole + part.whole;
    all += full;
    sum += lit ? full : AirlightShade(0.0);
  }
  // A loop, which software renderers leave where no pixel of a group is in it.
  for (int i = closes && psi < turn.end ? 1 : 0; i > 0; i--)
  {
    AirlightShade rest = airlightTurnRest(media.item[0], turn, psi);
    all += rest;
    sum += lit ? rest : AirlightShade(0.0);
  }
  pixel.litLength = max(litLength + (lit ? ray.lit.y : 0.0), 0.0);
  // A channel that does not scatter is dark, whatever the limit of its integral.
  vec3 factor = mix(vec3(0.0), light.intensity / turn.h, greaterThan(light.intensity, vec3(0.0)));
  pixel.whole = factor * all;
  pixel.sum = factor * max(sum, AirlightShade(0.0));
  return pixel;
}

// Of pixel p, whose ray ends at `surface` on the boundaries' unit, where that is not below 0. False where
// its boundaries are elsewhere.
bool airlightTurnPixel(vec2 p, float unit, float surface, out AirlightTurnedPixel pixel)
{
  pixel = AirlightTurnedPixel(vec3(0.0), vec3(0.0), 0.0, 0, false);
  if (!airlightOpenKeys(ivec2(p), surface >= 0.0 ? surface : 1e37))
  {
    return false;
  }
  vec3 origin = airlightOrigin(p);
  vec3 direction = airlightDirection(p) / unit;
  AirlightRay ray =
    airlightRayBeside(media, light, origin, direction, surface >= 0.0 ? unit * surface : AIRLIGHT_FAR,
      airlightOwnMoment(0, p, unit, light, origin, direction));
  pixel = airlightTurnedRay(ray, unit);
  return true;
}
