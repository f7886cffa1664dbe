// The boundaries of a pixel from a shadow map: steps along the ray, and where light turns into
// shadow or back within a step, the place by bisection. What begins and ends within one step is
// missed.

// A step is halved so often.
const int AIRLIGHT_HALVINGS = 8;

AirlightMarch march;
float marchEnd; // distance of the surface, below 0: none
int marchNext;  // step; one more than the last: the surface
float marchAt;  // where the last step ended
bool marchLit;  // and whether that is lit

bool airlightOpenBoundaries(ivec2 pixel, float unit, float surface)
{
  marchEnd = unit * surface;
  return true;
}

void airlightBeginBoundaries(AirlightRay ray, inout float from, inout int shadows)
{
  march = airlightMarch(ray, true);
  // Nothing to march over where all is lit.
  marchNext = march.to > march.from && mapKind != 0 ? 1 : marchSteps + 1;
  marchAt = airlightMarchStep(march, 0);
  // What is outside the map is lit.
  marchLit = (!march.point && march.from > ray.lit.x) || mapKind == 0 ||
    airlightIsLit(airlightMarchPoint(march, marchAt));
  shadows = marchLit ? 0 : 1;
}

int airlightNextBoundary(out float t, out int weight)
{
  t = 0.0;
  weight = marchLit ? 1 : -1;
  while (marchNext <= marchSteps)
  {
    float a = marchAt;
    float b = airlightMarchStep(march, marchNext);
    marchNext++;
    marchAt = b;
    if (airlightIsLit(airlightMarchPoint(march, b)) == marchLit)
    {
      continue;
    }
    for (int i = 0; i < AIRLIGHT_HALVINGS; i++)
    {
      float middle = airlightMarchMiddle(march, a, b);
      bool same = airlightIsLit(airlightMarchPoint(march, middle)) == marchLit;
      a = same ? middle : a;
      b = same ? b : middle;
    }
    t = airlightMarchDistance(march, airlightMarchMiddle(march, a, b));
    marchLit = !marchLit;
    return AIRLIGHT_MORE;
  }
  if (marchNext == marchSteps + 1 && marchEnd >= 0.0)
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
