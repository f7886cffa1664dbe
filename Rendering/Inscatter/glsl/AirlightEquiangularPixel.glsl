// A point light's airlight before a pixel, by AirlightEquiangular.glsl or
// AirlightHeightFogLamp.glsl.

// Whether multiple scattering takes what would be scattered without shadows from the ray, which is
// closer than that of its nodes. In height fog these are off for both kinds of light alike, and
// their ratio is closer.
#if AIRLIGHT_MULTIPLE_LAMP >= 0 && !defined(AIRLIGHT_HEIGHT_FOG)
#define AIRLIGHT_MULTIPLE_OF_WHOLE 1
#else
#define AIRLIGHT_MULTIPLE_OF_WHOLE 0
#endif
// Whether that is needed.
#if defined(AIRLIGHT_RECORD) || AIRLIGHT_MULTIPLE_OF_WHOLE
#define AIRLIGHT_WHOLE 1
#else
#define AIRLIGHT_WHOLE 0
#endif

struct AirlightEquiangularPixel
{
  vec3 sum;   // what is lit, as radiance
  vec3 whole; // what would be without shadows, if AIRLIGHT_WHOLE
  vec3 direction; // of the ray
  float end;      // where the ray ends
  float litLength;
  int boundaries;
  bool surfaceLit;
};

// What is known of a ray up to a boundary.
struct AirlightRayShadows
{
  AirlightCounts counts;
  bool lit;
  float litLength; // less where it is lit from
};

AirlightRayShadows airlightBeginEquiangular(AirlightRay ray, inout AirlightEquiangularPixel pixel)
{
  AirlightRayShadows shadows;
  float from = ray.lit.x;
  shadows.counts = airlightStartCounts();
  airlightBeginBoundaries(ray, from, shadows.counts);
  shadows.lit = airlightPassing(shadows.counts);
  shadows.litLength = shadows.lit ? -from : 0.0;
  pixel.boundaries = airlightBoundaryCount;
  pixel.surfaceLit = airlightPassing(airlightAdd(shadows.counts, airlightBoundaryWeights));
  return shadows;
}

void airlightCross(AirlightRay ray, float boundary, AirlightCounts weight,
  inout AirlightRayShadows shadows)
{
  float t = clamp(boundary, ray.lit.x, ray.lit.y);
  bool was = shadows.lit;
  shadows.counts = airlightAdd(shadows.counts, weight);
  shadows.lit = airlightPassing(shadows.counts);
  shadows.litLength += was == shadows.lit ? 0.0 : shadows.lit ? -t : t;
}

// `all`, `sum`: of all of the ray, and of what is lit.
void airlightFinishEquiangular(AirlightRay ray, AirlightRayShadows shadows, AirlightSpectrum all,
  AirlightSpectrum sum, inout AirlightEquiangularPixel pixel)
{
  pixel.litLength = max(shadows.litLength + (shadows.lit ? ray.lit.y : 0.0), 0.0);
  pixel.whole = airlightEquiangularLight(light, ray, all);
  pixel.sum = airlightEquiangularLight(light, ray, max(sum, AirlightSpectrum(0.0)));
}

// AirlightEquiangularRay.glsl, or AirlightSteppedRay.glsl.
void airlightEquiangularRay(AirlightRay ray, inout AirlightEquiangularPixel pixel);

// Of pixel p, whose ray ends at `surface` on the unit of airlightDirection(); below 0: nowhere.
// False where the pixel is another draw's.
bool airlightEquiangularPixel(vec2 p, float unit, float surface, out AirlightEquiangularPixel pixel)
{
  pixel = AirlightEquiangularPixel(vec3(0.0), vec3(0.0), vec3(0.0), 0.0, 0.0, 0, false);
  if (!airlightOpenBoundaries(ivec2(p), unit, surface))
  {
    return false;
  }
  vec3 origin = airlightOrigin(p);
  vec3 direction = airlightDirection(p) / unit;
  pixel.direction = direction;
  pixel.end = surface >= 0.0 ? unit * surface : AIRLIGHT_FAR;
  AirlightRay ray = airlightRayBeside(light, origin, direction, pixel.end,
    airlightOwnMoment(0, p, unit, light, origin, direction));
  airlightEquiangularRay(ray, pixel);
  return true;
}
