// Regions bounded by a closed surface of triangles, oriented outwards. A line enters and leaves it
// any number of times; nothing needs to be sorted: with hits at t_i > 0 and e_i = 1 where the line
// leaves, -1 where it enters, the length inside on [0, l] is
//
//   sum_i e_i min(t_i, l)
//
// which is continuous in every t_i. So is the depth, with the depth from 0 to min(t_i, l) in place
// of the length.
//
// The triangles lie in a tree of boxes. Texels: two for each node in depth-first order, (least
// corner, node that follows the subtree) and (greatest corner, -1; of a leaf: its triangle); then
// three for each triangle, its corners, as seen from the region's centre.

// What rounding took from the product of a and b (Dekker 1971), of numbers in which nothing
// underflows.
AIRLIGHT_FN real airlightProductError(real a, real b, real product)
{
#ifdef AIRLIGHT_DOUBLE
  const real splitter = real(134217729.0);
#else
  const real splitter = real(4097.0);
#endif
  AIRLIGHT_PRECISE real bigA = splitter * a;
  AIRLIGHT_PRECISE real highA = bigA - (bigA - a);
  AIRLIGHT_PRECISE real lowA = a - highA;
  AIRLIGHT_PRECISE real bigB = splitter * b;
  AIRLIGHT_PRECISE real highB = bigB - (bigB - b);
  AIRLIGHT_PRECISE real lowB = b - highB;
  AIRLIGHT_PRECISE real error =
    ((highA * highB - product) + highA * lowB + lowA * highB) + lowA * lowB;
  return error;
}

// p.x q.y - p.y q.x with its true sign, 0 where it is 0: without it, the triangles on a plane
// through the line would not agree on which of them the line meets. And with most of its digits
// however small it is: such a triangle is met at a mean of its corners, weighted by three of these.
AIRLIGHT_FN real airlightCross(real2 p, real2 q)
{
#ifdef AIRLIGHT_DOUBLE
  const real tolerance = real(1e-6);
#else
  const real tolerance = real(1e-2);
#endif
  AIRLIGHT_PRECISE real a = p.x * q.y;
  AIRLIGHT_PRECISE real b = p.y * q.x;
  AIRLIGHT_PRECISE real side = a - b;
  if (abs(side) <= tolerance * (abs(a) + abs(b)))
  {
    side += airlightProductError(p.x, q.y, a) - airlightProductError(p.y, q.x, b);
  }
  return side;
}

// Twice the signed area of the triangle (origin, a, b), for which the origin lies on no edge: where
// it does, it counts as moved by (e, e^2), e > 0 and infinitely small. Taken in one order of a and
// b, so that the two triangles on an edge agree to the last digit and a line through the edge meets
// exactly one.
AIRLIGHT_FN real airlightSide(real2 a, real2 b)
{
  bool swap = a.x > b.x || (a.x == b.x && a.y > b.y);
  real2 p = swap ? b : a;
  real2 q = swap ? a : b;
  real side = airlightCross(p, q);
  if (side == real(0.0))
  {
    side = q.y != p.y ? real(1e-37) * sign(p.y - q.y) : real(1e-37);
  }
  return swap ? -side : side;
}

// Where a line meets a triangle whose corners are given from the line's origin: (t, e), e = 0 where
// it does not. frame: two directions across the line and its own.
AIRLIGHT_FN real2 airlightTriangleHit(
  real3 frame0, real3 frame1, real3 direction, real3 a, real3 b, real3 c)
{
  real2 pa = real2(dot(a, frame0), dot(a, frame1));
  real2 pb = real2(dot(b, frame0), dot(b, frame1));
  real2 pc = real2(dot(c, frame0), dot(c, frame1));
  real wa = airlightSide(pb, pc);
  real wb = airlightSide(pc, pa);
  real wc = airlightSide(pa, pb);
  bool leaves = wa > real(0.0) && wb > real(0.0) && wc > real(0.0);
  bool enters = wa < real(0.0) && wb < real(0.0) && wc < real(0.0);
  if (!leaves && !enters)
  {
    return real2(real(0.0), real(0.0));
  }
  // Of one sign: a mean of the corners' distances, without cancellation.
  real3 w = real3(wa, wb, wc) / (wa + wb + wc);
  real t = dot(w, real3(dot(a, direction), dot(b, direction), dot(c, direction)));
  return real2(t, leaves ? real(1.0) : real(-1.0));
}

// Two directions across a unit vector, in such an order that the three are right-handed. Without
// square roots of small numbers for any vector (Duff et al. 2017).
AIRLIGHT_FN void airlightFrame(
  real3 direction, AIRLIGHT_OUT(real3) frame0, AIRLIGHT_OUT(real3) frame1)
{
  real s = direction.z < real(0.0) ? real(-1.0) : real(1.0);
  real a = real(-1.0) / (s + direction.z);
  real b = direction.x * direction.y * a;
  frame0 = real3(real(1.0) + s * direction.x * direction.x * a, s * b, -s * direction.x);
  frame1 = real3(b, s + direction.y * direction.y * a, -direction.y);
}

// Whether the ray from `point` can meet the box, larger by `margin`; `inverse` of its direction.
AIRLIGHT_FN bool airlightMeetsBox(
  real3 point, real3 inverse, real3 least, real3 greatest, real margin)
{
  real3 a = (least - margin - point) * inverse;
  real3 b = (greatest + margin - point) * inverse;
  real3 near = min(a, b);
  real3 far = max(a, b);
  real from = max(max(near.x, near.y), max(near.z, real(0.0)));
  return from <= min(far.x, min(far.y, far.z));
}

AIRLIGHT_FN real airlightInverse(real x)
{
  return (x < real(0.0) ? real(-1.0) : real(1.0)) / max(abs(x), real(1e-18));
}

#if AIRLIGHT_HAS_SURFACE
#ifndef AIRLIGHT_COUNT_ROUND // in shaders: see AIRLIGHT_MOST_ROUNDS
int airlightRounds = 0;
#define AIRLIGHT_COUNT_ROUND airlightRounds++
#endif

// A ray on its way through the tree of a surface.
struct AirlightTreeWalk
{
  real3 point; // origin, from the surface's centre
  real3 origin;
  real3 direction;
  real3 inverse; // of the direction
  real3 frame0;  // directions across it
  real3 frame1;
  real margin; // of boxes
  real start;  // where the surface can begin
  real l;      // see airlightSurfaceSums()
  real t;
  int node; // the next one
  real3 sums;
};

AIRLIGHT_FN void airlightTestTriangle(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_INOUT(AirlightTreeWalk) walk, int at)
{
  real4 a = AIRLIGHT_FETCH(medium.region, at);
  real4 b = AIRLIGHT_FETCH(medium.region, at + 1);
  real4 c = AIRLIGHT_FETCH(medium.region, at + 2);
  real2 hit = airlightTriangleHit(walk.frame0, walk.frame1, walk.direction,
    real3(a.x, a.y, a.z) - walk.point, real3(b.x, b.y, b.z) - walk.point,
    real3(c.x, c.y, c.z) - walk.point);
  if (hit.y != real(0.0) && hit.x > real(0.0))
  {
    real to = min(hit.x, walk.l);
    real depth = airlightFormulaDepth(
      medium, walk.origin, walk.direction, min(walk.start, to), max(walk.start, to));
    walk.sums.x += hit.y * (to > walk.start ? depth : -depth);
    walk.sums.y = hit.x > walk.t ? min(walk.sums.y, hit.x) : walk.sums.y;
    walk.sums.z += hit.x > walk.t ? hit.y : real(0.0);
  }
}

// One node: into its subtree, or past it.
AIRLIGHT_FN void airlightTestNode(
  AIRLIGHT_IN(AirlightMedium) medium, AIRLIGHT_INOUT(AirlightTreeWalk) walk)
{
  if (walk.node >= medium.region.nodes)
  {
    return;
  }
  int at = medium.region.first + 2 * walk.node;
  real4 least = AIRLIGHT_FETCH(medium.region, at);
  real4 greatest = AIRLIGHT_FETCH(medium.region, at + 1);
  bool meets = airlightMeetsBox(walk.point, walk.inverse, real3(least.x, least.y, least.z),
    real3(greatest.x, greatest.y, greatest.z), walk.margin);
  if (meets && greatest.w >= real(0.0))
  {
    int triangle = int(greatest.w + real(0.5));
    airlightTestTriangle(
      medium, walk, medium.region.first + 2 * medium.region.nodes + 3 * triangle);
  }
  walk.node = meets && greatest.w < real(0.0) ? walk.node + 1 : int(least.w + real(0.5));
}
#endif

// Of a medium inside a surface: x: integral of the density on [0, l] of a ray, of an image the
// length inside; y: the next t_i after t; z: how many times the surface holds the ray after t,
// which is 0 or 1.
AIRLIGHT_FN real3 airlightSurfaceSums(
  AIRLIGHT_IN(AirlightMedium) medium, real3 origin, real3 direction, real l, real t)
{
#if AIRLIGHT_HAS_SURFACE
  AirlightTreeWalk walk;
  airlightFrame(direction, walk.frame0, walk.frame1);
  walk.point = origin - medium.region.centre;
  walk.origin = origin;
  walk.direction = direction;
  walk.inverse = real3(
    airlightInverse(direction.x), airlightInverse(direction.y), airlightInverse(direction.z));
  // What roundings make of a triangle's place as seen from afar.
#ifdef AIRLIGHT_DOUBLE
  walk.margin = real(1e-15) * length(walk.point);
#else
  walk.margin = real(1e-6) * length(walk.point);
#endif
  // Density is summed up from where the surface can begin, not from afar, where it may be huge.
  walk.start = airlightRegionRange(medium.region, origin, direction, real(AIRLIGHT_FAR)).x;
  walk.l = l;
  walk.t = t;
  walk.node = 0;
  walk.sums = real3(real(0.0), real(AIRLIGHT_FAR), real(0.0));
  while (walk.node < medium.region.nodes)
  {
    AIRLIGHT_COUNT_ROUND; // several nodes each
    airlightTestNode(medium, walk);
    airlightTestNode(medium, walk);
    airlightTestNode(medium, walk);
  }
  // Roundings can make a ray along a triangle lose one of its hits, from which the sum is off by a
  // distance: what is inside the surface is inside its box.
  real2 range = airlightRegionRange(medium.region, origin, direction, l);
  walk.sums.x = clamp(
    walk.sums.x, real(0.0), airlightFormulaDepth(medium, origin, direction, range.x, range.y));
  return walk.sums;
#else
  return real3(real(0.0), real(AIRLIGHT_FAR), real(0.0));
#endif
}
