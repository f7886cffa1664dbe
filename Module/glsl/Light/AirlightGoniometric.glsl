// A light of which a photometric file tells how much it shines in each direction.
//
// The file's table (AirlightPhotometry.h) lies in texels of four numbers, from texel `first` on:
//
//   1 texel             rows, columns, type of coordinates (1 is C, 2 is B, 3 is A), 0
//   rows texels         an interval of vertical angles: from, to, 1/(to - from), 0; radians
//   columns texels      an interval of horizontal angles, likewise; symmetry is expanded
//   rows*columns texels the intensities, relative to the largest, at the corners of a cell: (from,
//                       from), (to, from), (from, to), (to, to) of (vertical, horizontal); column
//                       by column
//
// then the same intervals about the table's pole, for rays that pass from one to the next
// (AirlightGoniometricArc.glsl). The pole is the axis for type C, the opposite of right for B and
// of up for A; the intervals from it are cones, those around it lie between planes:
//
//   cones + 2 texels    angle of its beginning from the pole, 1/length, cosines of its beginning
//                       and its end; beyond 1 and -1 where no ray passes. The first one is before
//                       the table, the last one after it, both without a length.
//   planes x 2 texels   sine and cosine of its beginning's angle, 0, 0; those of its middle's,
//                       1/length, 1 if that is half a circle or more. Of types A and B there is
//                       one more, from the table's end around to its beginning.
//
// So a look-up reads one texel of intensities. The macro AIRLIGHT_FETCH(photometry, i) is texel i.
struct AirlightPhotometry
{
  AIRLIGHT_DATA_MEMBER
  int first;
  real3 axis; // where the lamp aims, unit vector
  real3 up;   // unit vector perpendicular to it
};

#if AIRLIGHT_HAS_PHOTOMETRY

// The angle of the point (x, y) in [-pi, pi].
AIRLIGHT_FN real airlightSignedAngle(real y, real x)
{
  return y < real(0.0) ? -airlightAngle(-y, x) : airlightAngle(y, x);
}

// The vertical and the horizontal angle of a direction, each from arctangents: arcsines and
// arccosines would be coarse where they are steep.
AIRLIGHT_FN real2 airlightPhotometryAngles(
  AIRLIGHT_IN(AirlightPhotometry) photometry, int type, real3 direction)
{
  real a = dot(direction, photometry.axis);
  real u = dot(direction, photometry.up);
  real r = dot(direction, cross(photometry.axis, photometry.up));
  if (type == 1)
  {
    return real2(airlightAngle(length(real2(r, u)), a), airlightSignedAngle(-r, u));
  }
  if (type == 2)
  {
    return real2(airlightSignedAngle(u, a), airlightSignedAngle(r, length(real2(a, u))));
  }
  return real2(airlightSignedAngle(u, length(real2(a, r))), airlightSignedAngle(r, a));
}

// The texel of the last interval that begins at or before the angle; the first one if none does.
AIRLIGHT_FN real4 airlightPhotometryInterval(AIRLIGHT_IN(AirlightPhotometry) photometry,
  int firstTexel, int count, real angle, AIRLIGHT_OUT(int) index)
{
  int low = 0;
  int high = count;
  while (high - low > 1)
  {
    int middle = (low + high) / 2;
    if (AIRLIGHT_FETCH(photometry, firstTexel + middle).x <= angle)
    {
      low = middle;
    }
    else
    {
      high = middle;
    }
  }
  index = low;
  return AIRLIGHT_FETCH(photometry, firstTexel + low);
}

// One cell of the table: the intensity in it is linear in both angles.
struct AirlightPhotometryCell
{
  int type;     // of coordinates
  real4 row;    // intervals of vertical and horizontal angles
  real4 column;
  real4 corners;
};

// The angle, in turns of the circle, that is next to the interval.
AIRLIGHT_FN real airlightPhotometryAngle(real angle, real4 interval)
{
  real fromMiddle = angle - real(0.5) * (interval.x + interval.y);
  real turn = real(6.283185307179586);
  return fromMiddle > real(0.5) * turn ? angle - turn
                                       : (fromMiddle < real(-0.5) * turn ? angle + turn : angle);
}

// The cell of a unit direction; outside the table the cell next to it, dark.
AIRLIGHT_FN AirlightPhotometryCell airlightPhotometryCell(
  AIRLIGHT_IN(AirlightPhotometry) photometry, real3 direction)
{
  AirlightPhotometryCell cell;
  real4 head = AIRLIGHT_FETCH(photometry, photometry.first);
  int rows = int(head.x);
  int columns = int(head.y);
  cell.type = int(head.z);
  int firstRow = photometry.first + 1;
  int firstColumn = firstRow + rows;
  real2 angles = airlightPhotometryAngles(photometry, cell.type, direction);
  if (cell.type == 1)
  {
    // All around, from the first horizontal angle, 0 or 90 degrees. Rounding must not lead out.
    real start = AIRLIGHT_FETCH(photometry, firstColumn).x;
    real end = AIRLIGHT_FETCH(photometry, firstColumn + columns - 1).y;
    angles.y = angles.y < start ? angles.y + real(6.283185307179586) : angles.y;
    angles.y = clamp(angles.y, start, end);
  }
  int i;
  int j;
  cell.row = airlightPhotometryInterval(photometry, firstRow, rows, angles.x, i);
  cell.column = airlightPhotometryInterval(photometry, firstColumn, columns, angles.y, j);
  cell.corners = AIRLIGHT_FETCH(photometry, firstColumn + columns + j * rows + i);
  if (angles.x < cell.row.x || angles.x > cell.row.y || angles.y < cell.column.x ||
    angles.y > cell.column.y)
  {
    cell.corners = real4(real(0.0));
  }
  return cell;
}

// The intensity in a unit direction of the cell, at the cell's edge for those that are not.
AIRLIGHT_FN real airlightPhotometryInside(AIRLIGHT_IN(AirlightPhotometry) photometry,
  AIRLIGHT_IN(AirlightPhotometryCell) cell, real3 direction)
{
  real2 angles = airlightPhotometryAngles(photometry, cell.type, direction);
  if (cell.type == 1)
  {
    angles.y = airlightPhotometryAngle(angles.y, cell.column);
  }
  real v = clamp((angles.x - cell.row.x) * cell.row.z, real(0.0), real(1.0));
  real h = clamp((angles.y - cell.column.x) * cell.column.z, real(0.0), real(1.0));
  return mix(mix(cell.corners.x, cell.corners.y, v), mix(cell.corners.z, cell.corners.w, v), h);
}

// The intensity relative to the largest in a unit direction away from the light: linear in both
// angles between those of the file, 0 outside.
AIRLIGHT_FN real airlightPhotometry(AIRLIGHT_IN(AirlightPhotometry) photometry, real3 direction)
{
  return airlightPhotometryInside(
    photometry, airlightPhotometryCell(photometry, direction), direction);
}

#endif
