// The usual ray march, for comparison: the same steps as with a shadow map's boundaries, the
// integrand taken in the middle of each.

#ifdef AIRLIGHT_TRANSLUCENT_FRAGMENTS
// Of AirlightResolveTranslucent.glsl.
void addStepToFragments(float from, float to, vec3 sum, vec3 part);
void lightFragments(AirlightRay ray);
#endif

// The light that a step scatters into the ray, from parameter a to b.
vec3 airlightMarchedStep(AirlightMarch march, float middle, float t, float a, float b)
{
  AirlightPiece piece = airlightPieceAt(march.ray.origin, march.ray.direction, t, t);
  float h = march.ray.foot.h;
  float r2 = h * h + middle * middle;
  vec3 value = airlightIntegrand(light, march.ray, piece, t, middle, sqrt(r2));
  if (!march.point)
  {
    return (airlightMarchDistance(march, b) - airlightMarchDistance(march, a)) * value;
  }
  // In equal angles: dt = r^2/h dphi.
  vec3 point = march.ray.origin + t * march.ray.direction;
  return march.turn / float(marchSteps) * (r2 / h) * airlightPhotometricShare(light, point) * value;
}

vec3 airlightMarched(
  AirlightRay ray, float surface, out float litLength, out int boundaries, out bool lit)
{
  AirlightMarch march = airlightMarch(ray);
  vec3 sum = vec3(0.0);
  litLength = 0.0;
  boundaries = 0;
  lit = true;
  for (int step = 0; step < marchSteps && march.to > march.from; step++)
  {
    float a = airlightMarchStep(march, step);
    float b = airlightMarchStep(march, step + 1);
    float middle = airlightMarchMiddle(march, a, b);
    float t = airlightMarchDistance(march, middle);
    bool wasLit = lit;
    lit = airlightIsLit(march.ray.origin + t * march.ray.direction);
    boundaries += step > 0 && lit != wasLit ? 1 : 0;
#ifdef AIRLIGHT_TRANSLUCENT_FRAGMENTS
    vec3 before = sum;
#endif
    if (lit)
    {
      sum += airlightMarchedStep(march, middle, t, a, b);
#ifdef AIRLIGHT_RECORD
      litLength += airlightLengthInside(ray.origin, ray.direction,
        airlightMarchDistance(march, a), airlightMarchDistance(march, b));
#endif
    }
#ifdef AIRLIGHT_TRANSLUCENT_FRAGMENTS
    addStepToFragments(airlightMarchDistance(march, a), airlightMarchDistance(march, b),
      light.intensity * before, light.intensity * (sum - before));
#endif
  }
#ifdef AIRLIGHT_TRANSLUCENT_FRAGMENTS
  lightFragments(ray);
#endif
  lit = surface < 0.0 || airlightIsSurfaceLit(ray.origin + surface * ray.direction);
  return light.intensity * sum;
}
