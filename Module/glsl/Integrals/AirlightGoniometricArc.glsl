// A point light with a photometric table in one uniform medium: what it scatters into a ray, in the
// angle psi seen from the light (AirlightEquiangular.glsl), from one cell of the table to the next.
//
// Seen from the light, the ray is half a great circle. With the angle left to its direction, a, the
// unit vector to a point of it is sin(a) across + cos(a) along. Its cosine with the table's pole is
// therefore amplitude cos(a - a0): it nears the pole, or the pole's opposite, up to one turn, and
// leaves it from there on, and each cone of the table is crossed where an arccosine says. Around
// the pole it moves in one sense, less than half a circle, and crosses the plane of each angle once
// at most. So the cell after a crossing is the neighbour, which takes no search. In a cell the
// intensity is smooth, and three nodes of Gauss and Legendre give what is scattered; where nothing
// is cut there are about as many parts as cells.

#if AIRLIGHT_HAS_PHOTOMETRY

struct AirlightGoniometricArc
{
  // Components towards the pole, and across it towards the planes at 0 and at a right angle.
  real3 across;
  real3 along;
  real amplitude;
  real width;   // sine of the least angle between the great circle and the pole's axis
  real turn;    // psi there
  real towards; // 1: it nears the pole, -1: its opposite
  bool leaves;  // psi is beyond that turn
  bool upwards; // the angle around the pole grows
  int cones;    // numbers of intervals of the table
  int planes;
  int ring; // of the intervals around the pole, a dark one among them if the table leaves a gap
  int firstCorner; // texels
  int firstCone;
  int firstPlane;
  bool transposed;
  // The cell: 0 and cones + 1 lie outside the table, as does a last one of the ring.
  int cone;
  int plane;
  int ends; // what ends where airlightGoniometricEnd() says: 0 neither, 1 the cone, 2 the plane
  real4 coneCell;
  real4 planeCell;
  real4 corners;
};

// Any unit vector perpendicular to a direction.
AIRLIGHT_FN real3 airlightAnyAcross(real3 direction)
{
  return normalize(cross(direction,
    abs(direction.x) < real(0.5) ? real3(real(1.0), real(0.0), real(0.0))
                                 : real3(real(0.0), real(1.0), real(0.0))));
}

// Where half the angle that is left has this sine and cosine.
AIRLIGHT_FN real3 airlightGoniometricDirection(
  AIRLIGHT_IN(AirlightGoniometricArc) walk, real sine, real cosine)
{
  return (real(2.0) * sine * cosine) * walk.across +
    ((cosine - sine) * (cosine + sine)) * walk.along;
}

// The cell at the beginning of the ray.
AIRLIGHT_FN void airlightGoniometricBegin(AIRLIGHT_IN(AirlightPhotometry) photometry,
  AIRLIGHT_IN(AirlightEquiangular) arc, int type, int firstPlane,
  AIRLIGHT_INOUT(AirlightGoniometricArc) walk)
{
  real2 halfLeft = airlightSineCosine(real(0.5) * arc.left);
  real3 start = airlightGoniometricDirection(walk, halfLeft.x, halfLeft.y);
  real angle = airlightAngle(length(real2(start.y, start.z)), start.x);
  int i;
  real4 cell =
    airlightPhotometryInterval(photometry, walk.firstCone + 1, walk.cones + 1, angle, i);
  walk.cone = angle < cell.x ? 0 : i + 1;
  angle = airlightSignedAngle(start.z, start.y);
  if (type == 1)
  {
    angle += angle < AIRLIGHT_FETCH(photometry, firstPlane).x ? real(6.283185307179586) : real(0.0);
  }
  cell = airlightPhotometryInterval(photometry, firstPlane, walk.planes, angle, i);
  walk.plane = type != 1 && (angle < cell.x || angle > cell.y) ? walk.planes : i;
}

AIRLIGHT_FN AirlightGoniometricArc airlightGoniometricArc(
  AIRLIGHT_IN(AirlightPhotometry) photometry, AIRLIGHT_IN(AirlightRay) ray,
  AIRLIGHT_IN(AirlightEquiangular) arc)
{
  real4 head = AIRLIGHT_FETCH(photometry, photometry.first);
  int rows = int(head.x);
  int columns = int(head.y);
  int type = int(head.z);
  AirlightGoniometricArc walk;
  walk.transposed = type == 2;
  walk.cones = walk.transposed ? columns : rows;
  walk.planes = walk.transposed ? rows : columns;
  walk.ring = type == 1 ? walk.planes : walk.planes + 1;
  walk.firstCorner = photometry.first + 1 + rows + columns;
  walk.firstCone = walk.firstCorner + rows * columns;
  walk.firstPlane = walk.firstCone + walk.cones + 2;
  real3 right = cross(photometry.axis, photometry.up);
  real3 pole = type == 1 ? photometry.axis : -(type == 2 ? right : photometry.up);
  real3 first = type == 1 ? photometry.up : photometry.axis;
  real3 second = type == 1 ? -right : (type == 2 ? photometry.up : right);
  real beside = length(ray.across);
  real3 across = beside > real(1e-30) ? ray.across / beside : airlightAnyAcross(ray.direction);
  walk.across = real3(dot(across, pole), dot(across, first), dot(across, second));
  walk.along =
    real3(dot(ray.direction, pole), dot(ray.direction, first), dot(ray.direction, second));
  walk.amplitude = max(length(real2(walk.across.x, walk.along.x)), real(1e-12));
  real sense = walk.across.y * walk.along.z - walk.across.z * walk.along.y;
  walk.upwards = sense > real(0.0);
  walk.width = abs(sense);
  walk.towards = walk.across.x < real(0.0) ? real(-1.0) : real(1.0);
  walk.turn = arc.left - airlightAngle(abs(walk.across.x), walk.towards * walk.along.x);
  walk.leaves = walk.turn <= real(0.0);
  walk.ends = 0;
  airlightGoniometricBegin(
    photometry, arc, type, photometry.first + 1 + (walk.transposed ? 0 : rows), walk);
  return walk;
}

// Where the ray, at psi, leaves the cell by a cone.
AIRLIGHT_FN real airlightGoniometricConeEnd(AIRLIGHT_INOUT(AirlightGoniometricArc) walk)
{
  real2 cosines = (walk.towards / walk.amplitude) *
    (walk.towards > real(0.0) ? real2(walk.coneCell.z, walk.coneCell.w)
                              : real2(walk.coneCell.w, walk.coneCell.z));
  walk.leaves = walk.leaves || cosines.x >= real(1.0);
  real cosine = walk.leaves ? cosines.y : cosines.x;
  real sine = sqrt(max((real(1.0) - cosine) * (real(1.0) + cosine), real(0.0)));
  real away = airlightAngle(sine, clamp(cosine, real(-1.0), real(1.0)));
  return walk.leaves ? (cosine > real(-1.0) ? walk.turn + away : real(AIRLIGHT_FAR))
                     : walk.turn - away;
}

// And by a plane.
AIRLIGHT_FN real airlightGoniometricPlaneEnd(AIRLIGHT_IN(AirlightPhotometry) photometry,
  AIRLIGHT_IN(AirlightGoniometricArc) walk, AIRLIGHT_IN(AirlightEquiangular) arc, real psi)
{
  int next = walk.upwards ? walk.plane + 1 : walk.plane;
  next = next < walk.ring ? next : 0;
  real4 border = AIRLIGHT_FETCH(photometry, walk.firstPlane + 2 * next); // sine, cosine
  real across = border.y * walk.across.z - border.x * walk.across.y;
  real along = border.y * walk.along.z - border.x * walk.along.y;
  // There sine and cosine of the angle left are as these.
  real sine = abs(along);
  real cosine = along > real(0.0) ? -across : across;
  real end = arc.left - airlightAngle(sine, cosine);
  // The plane's other half is the opposite angle's. And the last border is not the next one again.
  bool ahead = sine * (border.y * walk.across.y + border.x * walk.across.z) +
      cosine * (border.y * walk.along.y + border.x * walk.along.z) > real(0.0) &&
    walk.ring > 1 && (end >= psi || walk.planeCell.w == real(0.0));
  return ahead ? end : real(AIRLIGHT_FAR);
}

// How far a part may reach on which three nodes are enough, of what eight allow.
#define AIRLIGHT_THREE_NODES 0.4

// Where the part of the ray that begins at psi may end, in one cell, which it looks up.
AIRLIGHT_FN real airlightGoniometricEnd(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightPhotometry) photometry, AIRLIGHT_IN(AirlightEquiangular) arc, real psi,
  AIRLIGHT_INOUT(AirlightGoniometricArc) walk)
{
  walk.coneCell = AIRLIGHT_FETCH(photometry, walk.firstCone + walk.cone);
  walk.planeCell = AIRLIGHT_FETCH(photometry, walk.firstPlane + 2 * walk.plane + 1);
  int cone = clamp(walk.cone - 1, 0, walk.cones - 1);
  int plane = min(walk.plane, walk.planes - 1);
  real4 corners = AIRLIGHT_FETCH(photometry,
    walk.firstCorner +
      (walk.transposed ? cone * walk.planes + plane : plane * walk.cones + cone));
  bool inside = cone == walk.cone - 1 && plane == walk.plane;
  walk.corners = inside ? corners : real4(real(0.0));
  real coneEnd = airlightGoniometricConeEnd(walk);
  real planeEnd = airlightGoniometricPlaneEnd(photometry, walk, arc, psi);
  real end = max(min(coneEnd, planeEnd), psi);
  walk.ends = coneEnd <= planeEnd ? 1 : 2;
  // Beside the pole the angle around it turns within `width`.
  real gap = walk.turn - psi;
  real most = max(gap > real(0.0) ? real(0.5) * gap : -gap, max(walk.width, real(1e-4)));
  most = psi +
    min(most, real(AIRLIGHT_THREE_NODES) * airlightEquiangularPanelLength(medium, arc, psi));
  if (most < end && walk.corners != real4(real(0.0)))
  {
    walk.ends = 0;
    end = most;
  }
  return end;
}

// On into the next cell, where the ray has come to that end.
AIRLIGHT_FN void airlightGoniometricCross(AIRLIGHT_INOUT(AirlightGoniometricArc) walk)
{
  int cone = (walk.towards > real(0.0)) == walk.leaves ? 1 : -1;
  walk.cone += walk.ends == 1 ? cone : 0;
  int plane = walk.upwards ? walk.plane + 1 : walk.plane + walk.ring - 1;
  plane = plane < walk.ring ? plane : plane - walk.ring;
  walk.plane = walk.ends == 2 ? plane : walk.plane;
}

// The integrand where half the angle that is left has this sine and cosine.
AIRLIGHT_FN AirlightSpectrum airlightGoniometricSample(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightEquiangular) arc, AIRLIGHT_IN(AirlightGoniometricArc) walk, real sine,
  real cosine)
{
  real3 direction = airlightGoniometricDirection(walk, sine, cosine);
  real angle = airlightAngle(length(real2(direction.y, direction.z)), direction.x);
  real v = clamp((angle - walk.coneCell.x) * walk.coneCell.y, real(0.0), real(1.0));
  // From the middle of the interval.
  angle = airlightSignedAngle(
    walk.planeCell.y * direction.z - walk.planeCell.x * direction.y,
    walk.planeCell.y * direction.y + walk.planeCell.x * direction.z);
  real h = clamp(real(0.5) + angle * walk.planeCell.z, real(0.0), real(1.0));
  real2 share = walk.transposed ? real2(h, v) : real2(v, h);
  real intensity = mix(mix(walk.corners.x, walk.corners.y, share.x),
    mix(walk.corners.z, walk.corners.w, share.x), share.y);
  return intensity * airlightEquiangularSample(medium, arc, sine, cosine);
}

// The integral over a part in one cell.
AIRLIGHT_FN AirlightSpectrum airlightGoniometricPart(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightEquiangular) arc, AIRLIGHT_IN(AirlightGoniometricArc) walk, real psi0,
  real psi1)
{
  real reach = real(0.5) * (psi1 - psi0);
  real2 m = airlightSineCosine(real(0.5) * (arc.left - (psi0 + reach)));
  real2 o = airlightSineCosine(real(0.3872983346207417) * reach); // half of a node's angle
  real sc = m.x * o.y;
  real cs = m.y * o.x;
  real cc = m.y * o.y;
  real ss = m.x * o.x;
  return reach *
    (real(0.8888888888888889) * airlightGoniometricSample(medium, arc, walk, m.x, m.y) +
      real(0.5555555555555556) *
        (airlightGoniometricSample(medium, arc, walk, sc - cs, cc + ss) +
          airlightGoniometricSample(medium, arc, walk, sc + cs, cc - ss)));
}

// More parts than any table has led to; a bound, so that every driver ends.
#define AIRLIGHT_MAXIMUM_CELLS 3000

// The ray's part [t0, t1].
AIRLIGHT_FN AirlightSpectrum airlightGoniometricQuadrature(AIRLIGHT_IN(AirlightMedium) medium,
  AIRLIGHT_IN(AirlightPhotometry) photometry, AIRLIGHT_IN(AirlightRay) ray, real t0, real t1)
{
  AirlightEquiangular arc = airlightEquiangularRange(medium, ray, t0, t1);
  AirlightGoniometricArc walk = airlightGoniometricArc(photometry, ray, arc);
  AirlightSpectrum sum = AirlightSpectrum(real(0.0));
  real psi = real(0.0);
  for (int i = 0; i < AIRLIGHT_MAXIMUM_CELLS && psi < arc.end; i++)
  {
    real next = min(airlightGoniometricEnd(medium, photometry, arc, psi, walk), arc.end);
    sum += airlightGoniometricPart(medium, arc, walk, psi, next);
    psi = next;
    airlightGoniometricCross(walk);
  }
  return sum;
}

#endif
