// A point light's airlight along a ray by AirlightTurn.glsl: part by part of the ray, and in each its
// boundaries. Returns what is lit; `whole` what would be without shadows, both as radiance.

// The boundaries' distances have this unit.
vec3 airlightTurnedRay(ivec2 pixel, AirlightRay ray, float unit, out vec3 whole, out float litLength,
  out int boundaries, out bool surfaceLit)
{
  AirlightTurn turn = airlightTurn(media.item[0], ray, ray.lit.x, ray.lit.y);
  boundaries = slotCount;
  surfaceLit = startCount + slotsTotal <= 0;
  int shadows = startCount;
  bool lit = shadows <= 0;
  litLength = lit ? -ray.lit.x : 0.0;
  AirlightShade all = AirlightShade(0.0);
  AirlightShade sum = AirlightShade(0.0);
  float psi = 0.0;
  uint key = airlightNextKey();
  float t = unit * airlightKeyDistance(key);
  float at = airlightTurned(turn, ray, t);
  for (int i = 0; i < AIRLIGHT_TURN_PARTS && psi < turn.end; i++)
  {
    float end = airlightTurnPartEnd(media.item[0], turn, psi);
    AirlightTurnPart part = airlightTurnPart(media.item[0], turn, psi, end);
    psi = end;
    // The last part takes what lies beyond the ray's end, too.
    while (slotCount >= 0 && (at <= end || end >= turn.end))
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
  litLength = max(litLength + (lit ? ray.lit.y : 0.0), 0.0);
  vec3 factor = light.intensity / turn.h;
  whole = factor * all;
  return factor * max(sum, AirlightShade(0.0));
}
