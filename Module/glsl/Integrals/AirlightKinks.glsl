// Where along a ray the way to the light begins to leave a region through another face, or to touch
// it at all: there the integrand has a kink, at which quadrature is cut.

// A ray and its light: origin and direction seen from a light at a place, else from the world's
// origin, with the direction towards the light.
struct AirlightWay
{
  real3 origin;
  real3 direction;
  real3 light; // position or direction
  bool directional;
};

AIRLIGHT_FN AirlightWay airlightWay(
  AIRLIGHT_IN(AirlightLight) light, AIRLIGHT_IN(AirlightRay) ray)
{
  AirlightWay way;
  way.directional = airlightIsDirectional(light);
  way.origin = way.directional ? ray.origin : ray.origin - light.position;
  way.direction = ray.direction;
  way.light = light.position;
  return way;
}

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

// The first kink in (t0, t1), a little after t0 at least, else t1. A way that begins in a sphere
// alone in the world leaves it without.
AIRLIGHT_FN real airlightNextKink(AIRLIGHT_IN(AirlightMedia) media, AIRLIGHT_IN(AirlightWay) way,
  real t0, real t1)
{
  t0 += real(1e-6) * (t1 - t0);
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    if (AIRLIGHT_REGION_KIND(media.item[i].region) == AIRLIGHT_REGION_BOX)
    {
      t1 = airlightBoxKink(media.item[i].region, way, t0, t1);
    }
    else if (AIRLIGHT_REGION_KIND(media.item[i].region) == AIRLIGHT_REGION_SPHERE &&
      AIRLIGHT_MEDIUM_COUNT > 1)
    {
      t1 = airlightSphereKink(media.item[i].region, way, t0, t1);
    }
  }
  return t1;
}
