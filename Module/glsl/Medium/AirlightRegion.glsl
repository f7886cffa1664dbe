// Where a medium is. Positions are relative to an origin of the caller's choice, in single
// precision best the camera. A ray is inside on one interval, but for closed surfaces
// (AirlightClosedSurface.glsl), whose box is what is said of them here.

#define AIRLIGHT_REGION_UNBOUNDED 0
#define AIRLIGHT_REGION_BOX 1
#define AIRLIGHT_REGION_SPHERE 2
#define AIRLIGHT_REGION_SURFACE 3

// Farther than any scene; squares of it are still finite.
#define AIRLIGHT_FAR 1e18

struct AirlightRegion
{
  int kind;
  real3 boxMin; // of a surface, too
  real3 boxMax;
  real3 centre; // of the sphere; where a surface's triangles have their origin
  real radius;
  AIRLIGHT_DATA_MEMBER
  int first; // texel of a surface's tree
  int nodes; // of the tree
};

// What all media have in common is known when a shader is compiled, and the rest falls away:
// software renderers run both sides of every branch.
#ifndef AIRLIGHT_REGION_KIND
#define AIRLIGHT_REGION_KIND(region) (region).kind
#endif

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

// The part (from, to) of [0, t1] in which the ray is inside the region, of a surface inside its
// box; to <= from: nowhere.
AIRLIGHT_FN real2 airlightRegionRange(
  AIRLIGHT_IN(AirlightRegion) region, real3 origin, real3 direction, real t1)
{
  real2 range = real2(real(0.0), t1);
  if (AIRLIGHT_REGION_KIND(region) == AIRLIGHT_REGION_BOX ||
    AIRLIGHT_REGION_KIND(region) == AIRLIGHT_REGION_SURFACE)
  {
    range = airlightClipSlab(range, origin.x, direction.x, region.boxMin.x, region.boxMax.x);
    range = airlightClipSlab(range, origin.y, direction.y, region.boxMin.y, region.boxMax.y);
    range = airlightClipSlab(range, origin.z, direction.z, region.boxMin.z, region.boxMax.z);
  }
  else if (AIRLIGHT_REGION_KIND(region) == AIRLIGHT_REGION_SPHERE)
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

// Whether the region, of a surface its box, holds a point.
AIRLIGHT_FN bool airlightHolds(AIRLIGHT_IN(AirlightRegion) region, real3 point)
{
  return AIRLIGHT_REGION_KIND(region) == AIRLIGHT_REGION_SPHERE
    ? length(point - region.centre) <= region.radius
    : AIRLIGHT_REGION_KIND(region) == AIRLIGHT_REGION_UNBOUNDED ||
      (all(greaterThanEqual(point, region.boxMin)) && all(lessThanEqual(point, region.boxMax)));
}
