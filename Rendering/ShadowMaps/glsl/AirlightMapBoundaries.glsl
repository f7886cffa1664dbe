// The boundaries of a pixel from a shadow map: steps along the ray, and where light turns into
// shadow or back within a step, the place by bisection. What begins and ends within one step is
// missed.

// A step is halved so often.
const int AIRLIGHT_HALVINGS = 8;

// So many steps are looked up at once. Rays that are drawn side by side, and wait for one another,
// do so in step; what differs between them, where light ends and begins, is left for afterwards.
const int AIRLIGHT_BLOCK = 128;

AirlightMarch march;
float marchEnd;   // distance of the surface, below 0: none
int marchFirst;   // the first step's end that the block has
int marchNext;    // the step's end to be looked at; one more than the last: the surface
bool marchLit;    // and whether those before it are lit
uvec4 marchBlock; // a bit for each of the block's

// Whether light reaches the ends of a block's steps.
void airlightMarchBlock(int first)
{
  marchFirst = first;
  marchBlock = uvec4(0u);
  float h = march.ray.foot.h;
  float angle = march.turn / float(marchSteps);
  mat2 turn = mat2(cos(angle), -sin(angle), sin(angle), cos(angle));
  float start = float(first) * angle;
  // Their ratio times h is the distance from the foot.
  vec2 along = mat2(cos(start), -sin(start), sin(start), cos(start)) * vec2(march.from, h);
  float zero = march.point ? march.ray.range.x + march.ray.foot.tL : 0.0;
  vec3 base = march.ray.origin - mapOrigin + zero * march.ray.direction;
  for (int word = 0; word < 4 && first + 32 * word <= marchSteps; word++)
  {
    uint bits = 0u;
    for (int bit = 0; bit < 32 && first + 32 * word + bit <= marchSteps; bit++)
    {
      float x = march.point
        ? clamp(h * along.x / max(along.y, 1e-30), march.from, march.to)
        : airlightMarchDistance(march, float(first + 32 * word + bit) / float(marchSteps));
      bits |= airlightMapIsLit(base + x * march.ray.direction) ? 1u << uint(bit) : 0u;
      along = turn * along;
    }
    marchBlock[word] = bits;
  }
}

// The first step's end from marchNext on that is not as those before; one more than the last if
// there is none.
int airlightMarchChange()
{
  while (marchNext <= marchSteps)
  {
    if (marchNext >= marchFirst + AIRLIGHT_BLOCK)
    {
      airlightMarchBlock(marchNext);
    }
    int place = marchNext - marchFirst;
    uint other = marchBlock[place / 32] ^ (marchLit ? 0xffffffffu : 0u);
    other &= 0xffffffffu << uint(place % 32);
    int found = marchFirst + place / 32 * 32 + (other != 0u ? findLSB(other) : 32);
    marchNext = min(found, marchSteps + 1);
    if (other != 0u)
    {
      break;
    }
  }
  return marchNext;
}

bool airlightOpenBoundaries(ivec2 pixel, float unit, float surface)
{
  marchEnd = unit * surface;
  return true;
}

void airlightBeginBoundaries(AirlightRay ray, inout float from, inout int shadows)
{
  march = airlightMarch(ray, true);
  marchLit = true;
  marchFirst = 0;
  marchNext = marchSteps + 1;
  // Nothing to march over where all is lit.
  if (mapKind != 0 && march.to > march.from)
  {
    airlightMarchBlock(0);
    marchNext = 1;
    // What is outside the map is lit.
    marchLit = (!march.point && march.from > ray.lit.x) || (marchBlock[0] & 1u) != 0u;
  }
  else if (mapKind != 0 && (march.point || march.from <= ray.lit.x))
  {
    marchLit = airlightIsLit(airlightMarchPoint(march, airlightMarchStep(march, 0)));
  }
  shadows = marchLit ? 0 : 1;
}

int airlightNextBoundary(out float t, out int weight)
{
  t = 0.0;
  weight = marchLit ? 1 : -1;
  int change = airlightMarchChange();
  if (change <= marchSteps)
  {
    float a = airlightMarchStep(march, change - 1);
    float b = airlightMarchStep(march, change);
    for (int i = 0; i < AIRLIGHT_HALVINGS; i++)
    {
      float middle = airlightMarchMiddle(march, a, b);
      bool same = airlightIsLit(airlightMarchPoint(march, middle)) == marchLit;
      a = same ? middle : a;
      b = same ? b : middle;
    }
    t = airlightMarchDistance(march, airlightMarchMiddle(march, a, b));
    marchLit = !marchLit;
    marchNext = change + 1;
    return AIRLIGHT_MORE;
  }
  if (change == marchSteps + 1 && marchEnd >= 0.0)
  {
    marchNext++;
    t = marchEnd;
    if (airlightIsSurfaceLit(march.ray.origin + t * march.ray.direction) != marchLit)
    {
      marchLit = !marchLit;
      return AIRLIGHT_MORE;
    }
  }
  return AIRLIGHT_END;
}

void airlightCloseBoundaries(ivec2 pixel, int state, float from, int shadows) {}
