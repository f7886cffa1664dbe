// Where a medium is. Positions are relative to an origin of the caller's choice, in single
// precision best the camera. All regions here are convex: a ray is inside on one interval.

#define AIRLIGHT_REGION_UNBOUNDED 0
#define AIRLIGHT_REGION_BOX 1
#define AIRLIGHT_REGION_SPHERE 2

// Farther than any scene; squares of it are still finite.
#define AIRLIGHT_FAR 1e18

struct AirlightRegion
{
  int kind;
  real3 boxMin;
  real3 boxMax;
  real3 centre; // of the sphere
  real radius;
};

// Clips the range (from, to) of a line to one pair of the box's planes.
AIRLIGHT_FN real2 airlightClipSlab(real2 range, real o, real d, real lo, real hi)
{
  if (abs(d) < real(1e-12))
  {
    return o >= lo && o <= hi ? range : real2(real(0.0), real(0.0));
  }
  real a = (lo - o) / d;
  real b = (hi - o) / d;
  return real2(max(range.x, min(a, b)), min(range.y, max(a, b)));
}

// The part (from, to) of [0, t1] in which the ray is inside the region; to <= from: nowhere.
AIRLIGHT_FN real2 airlightRegionRange(
  AIRLIGHT_IN(AirlightRegion) region, real3 origin, real3 direction, real t1)
{
  real2 range = real2(real(0.0), t1);
  if (region.kind == AIRLIGHT_REGION_BOX)
  {
    range = airlightClipSlab(range, origin.x, direction.x, region.boxMin.x, region.boxMax.x);
    range = airlightClipSlab(range, origin.y, direction.y, region.boxMin.y, region.boxMax.y);
    range = airlightClipSlab(range, origin.z, direction.z, region.boxMin.z, region.boxMax.z);
  }
  else if (region.kind == AIRLIGHT_REGION_SPHERE)
  {
    // From the foot of the centre on the ray, so that distant spheres keep their digits.
    real3 toCentre = region.centre - origin;
    real foot = dot(toCentre, direction);
    real h = length(cross(toCentre, direction));
    real halfChord = sqrt(max((region.radius - h) * (region.radius + h), real(0.0)));
    range = real2(max(range.x, foot - halfChord), min(range.y, foot + halfChord));
  }
  return real2(range.x, max(range.x, range.y));
}
