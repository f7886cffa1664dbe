// Where a medium is. Positions are relative to an origin of the caller's choice, in single
// precision best the camera. A ray is inside on one interval, but for closed surfaces
// (AirlightClosedSurface.glsl), whose box is what is said of them here.
//
// A kind of region is a number, its fields, and a case in each of the functions
// airlightRegionRange(), airlightHolds(), airlightRegionMiddle(), airlightHasEdges() and
// airlightRegionKink(). Its row in Region/AirlightRegionKinds.cxx fills the fields. The numbers are
// those of vtkParticipatingMedium::RegionType.

#define AIRLIGHT_REGION_UNBOUNDED 0
#define AIRLIGHT_REGION_BOX 1
#define AIRLIGHT_REGION_SPHERE 2
#define AIRLIGHT_REGION_SURFACE 3
#define AIRLIGHT_REGION_CYLINDER 4

// Farther than any scene; squares of it are still finite.
#define AIRLIGHT_FAR 1e18

struct AirlightRegion
{
  int kind;
  real3 boxMin; // of a surface, too
  real3 boxMax;
  real3 centre; // of the sphere or cylinder; where a surface's triangles have their origin
  real radius;
  real3 axis; // of the cylinder, of length 1
  real halfHeight;
  AIRLIGHT_DATA_MEMBER
  int first; // texel of a surface's tree
  int nodes; // of the tree
};

// What all media have in common is known when a shader is compiled, and the rest falls away:
// software renderers run both sides of every branch.
#ifndef AIRLIGHT_REGION_KIND
#define AIRLIGHT_REGION_KIND(region) (region).kind
#endif
#ifndef AIRLIGHT_REGION_KINDS
#define AIRLIGHT_REGION_KINDS 0xff // bit i: a region is of kind i
#endif
#define AIRLIGHT_HAS_REGION(kind) (((AIRLIGHT_REGION_KINDS >> kind) & 1) != 0)

AIRLIGHT_FN bool airlightIsCylinder(AIRLIGHT_IN(AirlightRegion) region)
{
  return AIRLIGHT_HAS_REGION(AIRLIGHT_REGION_CYLINDER) &&
    AIRLIGHT_REGION_KIND(region) == AIRLIGHT_REGION_CYLINDER;
}

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

// The component of a vector perpendicular to the cylinder's axis.
AIRLIGHT_FN real3 airlightAcrossAxis(AIRLIGHT_IN(AirlightRegion) region, real3 v)
{
  return v - dot(v, region.axis) * region.axis;
}

// Clips the range of a line to a cylinder: to the slab between its ends, and to its wall.
AIRLIGHT_FN real2 airlightClipCylinder(
  AIRLIGHT_IN(AirlightRegion) region, real2 range, real3 origin, real3 direction)
{
  real3 toCentre = region.centre - origin;
  real h = region.halfHeight;
  range =
    airlightClipSlab(range, -dot(toCentre, region.axis), dot(direction, region.axis), -h, h);
  real3 aside = airlightAcrossAxis(region, toCentre);
  real3 across = airlightAcrossAxis(region, direction);
  real slope = length(across);
  if (slope < real(1e-12))
  {
    return length(aside) <= region.radius ? range : real2(real(0.0), real(0.0));
  }
  // From the foot of the axis on the ray, as for spheres.
  real foot = dot(aside, across) / (slope * slope);
  real apart = length(cross(aside, across)) / slope;
  real halfChord =
    sqrt(max((region.radius - apart) * (region.radius + apart), real(0.0))) / slope;
  return real2(max(range.x, foot - halfChord), min(range.y, foot + halfChord));
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
  else if (airlightIsCylinder(region))
  {
    range = airlightClipCylinder(region, range, origin, direction);
  }
  return real2(range.x, max(range.x, range.y));
}

// Whether the region, of a surface its box, holds a point.
AIRLIGHT_FN bool airlightHolds(AIRLIGHT_IN(AirlightRegion) region, real3 point)
{
  if (airlightIsCylinder(region))
  {
    real3 fromCentre = point - region.centre;
    return abs(dot(fromCentre, region.axis)) <= region.halfHeight &&
      length(airlightAcrossAxis(region, fromCentre)) <= region.radius;
  }
  return AIRLIGHT_REGION_KIND(region) == AIRLIGHT_REGION_SPHERE
    ? length(point - region.centre) <= region.radius
    : AIRLIGHT_REGION_KIND(region) == AIRLIGHT_REGION_UNBOUNDED ||
      (all(greaterThanEqual(point, region.boxMin)) && all(lessThanEqual(point, region.boxMax)));
}

// The centre of the region, of a surface its box.
AIRLIGHT_FN real3 airlightRegionMiddle(AIRLIGHT_IN(AirlightRegion) region)
{
  return AIRLIGHT_REGION_KIND(region) == AIRLIGHT_REGION_SPHERE || airlightIsCylinder(region)
    ? region.centre
    : real(0.5) * (region.boxMin + region.boxMax);
}

// Whether the length of a way from inside the region has kinks as its direction changes.
AIRLIGHT_FN bool airlightHasEdges(AIRLIGHT_IN(AirlightRegion) region)
{
  return AIRLIGHT_REGION_KIND(region) == AIRLIGHT_REGION_BOX || airlightIsCylinder(region);
}

// ---- Kinks ------------------------------------------------------------------------------------

// Where along a ray the way to the light begins to leave a region through another face, or to touch
// it at all, the integrand has a kink.

// A ray and its light: origin and direction seen from a light at a place, else from the world's
// origin, with the direction towards the light.
struct AirlightWay
{
  real3 origin;
  real3 direction;
  real3 light; // position or direction
  bool directional;
};

// The edge of a box where the planes at `plane` of axes a and b meet: the t whose way to the light
// meets it, if that is between t0 and t1, else t1. With q the point of the ray seen from the light
// and e the edge, e_a q_b = e_b q_a, which is linear in t.
AIRLIGHT_FN real airlightEdgeKink(AIRLIGHT_IN(AirlightRegion) region, AIRLIGHT_IN(AirlightWay) way,
  int a, int b, real2 plane, real t0, real t1)
{
  int c = 3 - a - b;
  real2 o = real2(way.origin[a], way.origin[b]);
  real2 d = real2(way.direction[a], way.direction[b]);
  real2 l = real2(way.light[a], way.light[b]);
  real2 e = way.directional ? plane - o : plane - l;
  real slope = way.directional ? d.x * l.y - d.y * l.x : e.x * d.y - e.y * d.x;
  real t = (way.directional ? e.x * l.y - e.y * l.x : e.y * o.x - e.x * o.y) / slope;
  if (!(t > t0 && t < t1))
  {
    return t1;
  }
  // Whether the edge is met between point and light, and is the box's there.
  real2 q = o + t * d;
  real third = way.origin[c] + t * way.direction[c];
  bool met;
  if (way.directional)
  {
    bool x = abs(l.x) > abs(l.y);
    real along = x ? (plane.x - q.x) / l.x : (plane.y - q.y) / l.y;
    third += along * way.light[c];
    met = along > real(0.0);
  }
  else
  {
    bool x = abs(q.x) > abs(q.y);
    real share = x ? e.x / q.x : e.y / q.y;
    third = way.light[c] + share * third;
    met = share > real(0.0) && share < real(1.0);
  }
  return met && third >= region.boxMin[c] && third <= region.boxMax[c] ? t : t1;
}

AIRLIGHT_FN real airlightBoxKink(AIRLIGHT_IN(AirlightRegion) region, AIRLIGHT_IN(AirlightWay) way,
  real t0, real t1)
{
  for (int a = 0; a < 2; a++)
  {
    for (int b = a + 1; b < 3; b++)
    {
      for (int corner = 0; corner < 4; corner++)
      {
        real2 plane = real2(corner % 2 == 0 ? region.boxMin[a] : region.boxMax[a],
          corner / 2 == 0 ? region.boxMin[b] : region.boxMax[b]);
        t1 = airlightEdgeKink(region, way, a, b, plane, t0, t1);
      }
    }
  }
  return t1;
}

// The first root in (t0, t1) of a t^2 + 2 b t + c, else t1.
AIRLIGHT_FN real airlightFirstRoot(real a, real b, real c, real t0, real t1)
{
  real discriminant = b * b - a * c;
  if (discriminant <= real(0.0))
  {
    return t1;
  }
  real s = sqrt(discriminant);
  real q = b > real(0.0) ? -(b + s) : s - b;
  real first = q / a;
  real second = c / q;
  t1 = first > t0 && first < t1 ? first : t1;
  return second > t0 && second < t1 ? second : t1;
}

// Where the way to the light is tangent to a sphere. A cut too many does no harm: the tangent point
// may lie beyond the point or the light.
AIRLIGHT_FN real airlightSphereKink(AIRLIGHT_IN(AirlightRegion) region,
  AIRLIGHT_IN(AirlightWay) way, real t0, real t1)
{
  real3 axis = way.directional ? way.light : region.centre - way.light;
  real3 o = cross(way.directional ? way.origin - region.centre : way.origin, axis);
  real3 d = cross(way.direction, axis);
  real r2 = region.radius * region.radius;
  return way.directional
    ? airlightFirstRoot(dot(d, d), dot(o, d), dot(o, o) - r2, t0, t1)
    : airlightFirstRoot(dot(d, d) - r2, dot(o, d) - r2 * dot(way.origin, way.direction),
        dot(o, o) - r2 * dot(way.origin, way.origin), t0, t1);
}

// The t in (t0, t1) whose way to the light goes through the point p of a cylinder's rim, else t1. p
// is seen from a light at a place, else from the way's origin; the plane of ray and light has the
// normal n.
AIRLIGHT_FN real airlightRimPointKink(
  AIRLIGHT_IN(AirlightWay) way, real3 n, real3 p, real t0, real t1)
{
  real t;
  bool met;
  if (way.directional)
  {
    t = dot(cross(way.light, p), n) / dot(n, n);
    met = dot(p - t * way.direction, way.light) > real(0.0);
  }
  else
  {
    t = -dot(cross(p, way.origin), n) / dot(cross(p, way.direction), n);
    real3 q = way.origin + t * way.direction;
    real share = dot(p, q);
    met = share > real(0.0) && share < dot(q, q);
  }
  return met && t > t0 && t < t1 ? t : t1;
}

// Where the way to the light passes from a cylinder's wall to the end with the centre `end`: the
// plane of ray and light meets the rim in two points.
AIRLIGHT_FN real airlightRimKink(AIRLIGHT_IN(AirlightRegion) region, AIRLIGHT_IN(AirlightWay) way,
  real3 end, real t0, real t1)
{
  real3 n = cross(way.directional ? way.light : way.origin, way.direction);
  real3 q = end - (way.directional ? way.origin : way.light);
  real3 across = airlightAcrossAxis(region, n);
  real across2 = dot(across, across);
  real3 nearest = -dot(n, q) / across2 * across;
  real rest = region.radius * region.radius - dot(nearest, nearest);
  if (!(rest > real(0.0)))
  {
    return t1;
  }
  real3 aside = sqrt(rest / across2) * cross(region.axis, across);
  t1 = airlightRimPointKink(way, n, q + nearest + aside, t0, t1);
  return airlightRimPointKink(way, n, q + nearest - aside, t0, t1);
}

// Where the way to the light is tangent to the wall, as to a sphere, seen along the axis.
AIRLIGHT_FN real airlightWallKink(AIRLIGHT_IN(AirlightRegion) region,
  AIRLIGHT_IN(AirlightWay) way, real t0, real t1)
{
  real3 origin =
    airlightAcrossAxis(region, way.directional ? way.origin - region.centre : way.origin);
  real3 direction = airlightAcrossAxis(region, way.direction);
  real3 to =
    airlightAcrossAxis(region, way.directional ? way.light : region.centre - way.light);
  real3 o = cross(origin, to);
  real3 d = cross(direction, to);
  real r2 = region.radius * region.radius;
  return way.directional
    ? airlightFirstRoot(dot(d, d), dot(o, d), dot(o, o) - r2 * dot(to, to), t0, t1)
    : airlightFirstRoot(dot(d, d) - r2 * dot(direction, direction),
        dot(o, d) - r2 * dot(origin, direction), dot(o, o) - r2 * dot(origin, origin), t0, t1);
}

// The first kink in (t0, t1), else t1. `outside`: whether the ray and its light may be outside the
// region; a way that begins in a sphere leaves it without a kink.
AIRLIGHT_FN real airlightRegionKink(AIRLIGHT_IN(AirlightRegion) region,
  AIRLIGHT_IN(AirlightWay) way, bool outside, real t0, real t1)
{
  if (AIRLIGHT_REGION_KIND(region) == AIRLIGHT_REGION_BOX)
  {
    return airlightBoxKink(region, way, t0, t1);
  }
  if (airlightIsCylinder(region))
  {
    real3 toEnd = region.halfHeight * region.axis;
    t1 = airlightRimKink(region, way, region.centre - toEnd, t0, t1);
    t1 = airlightRimKink(region, way, region.centre + toEnd, t0, t1);
    return outside ? airlightWallKink(region, way, t0, t1) : t1;
  }
  return AIRLIGHT_REGION_KIND(region) == AIRLIGHT_REGION_SPHERE && outside
    ? airlightSphereKink(region, way, t0, t1)
    : t1;
}
