// Where a ray passes from one cell of a light's photometric table to the next: there the intensity
// has a kink, or at the table's edge a jump.

#if AIRLIGHT_HAS_PHOTOMETRY

// A ray seen from the light: foot + x direction, x = t - tL. One of the table's angles is counted
// from a pole, so that its lines are cones; the other one around it, from the direction `first` to
// the direction `second`, so that its lines are planes.
struct AirlightPhotometryLine
{
  real3 foot; // of the light on the ray, perpendicular to the direction; may be 0
  real2 pole; // components of foot and of the ray's direction
  real2 first;
  real2 second;
};

AIRLIGHT_FN AirlightPhotometryLine airlightPhotometryLine(
  AIRLIGHT_IN(AirlightPhotometry) photometry, int type, real3 foot, real3 direction)
{
  real2 axis = real2(dot(foot, photometry.axis), dot(direction, photometry.axis));
  real2 up = real2(dot(foot, photometry.up), dot(direction, photometry.up));
  real3 side = cross(photometry.axis, photometry.up);
  real2 right = real2(dot(foot, side), dot(direction, side));
  AirlightPhotometryLine line;
  line.foot = foot;
  line.pole = type == 1 ? axis : (type == 2 ? right : up);
  line.first = type == 1 ? up : axis;
  line.second = type == 1 ? -right : (type == 2 ? up : right);
  return line;
}

AIRLIGHT_FN real airlightEarlier(real end, real candidate, real after)
{
  return candidate > after ? min(end, candidate) : end;
}

// The first crossing of the cone (p.pole)^2 = c^2 (p.p) after x, or `end`. The cone's other half
// is there too: a cut too many does no harm.
AIRLIGHT_FN real airlightConeCut(AIRLIGHT_IN(AirlightPhotometryLine) line, real c, real x, real end)
{
  real f2 = dot(line.foot, line.foot);
  real discriminant =
    line.pole.x * line.pole.x + (line.pole.y * line.pole.y - c * c) * f2;
  if (discriminant <= real(0.0))
  {
    return end;
  }
  // Roots without cancellation.
  real b = line.pole.x * line.pole.y;
  real s = abs(c) * sqrt(discriminant);
  real q = b > real(0.0) ? -(b + s) : s - b;
  real a = line.pole.y * line.pole.y - c * c;
  if (a != real(0.0))
  {
    end = airlightEarlier(end, q / a, x);
  }
  if (q != real(0.0))
  {
    end = airlightEarlier(end, (line.pole.x * line.pole.x - c * c * f2) / q, x);
  }
  return end;
}

// The same for the plane of the pole and the angle.
AIRLIGHT_FN real airlightPlaneCut(
  AIRLIGHT_IN(AirlightPhotometryLine) line, real angle, real x, real end)
{
  real2 side = sin(angle) * line.first - cos(angle) * line.second;
  return side.y != real(0.0) ? airlightEarlier(end, -side.x / side.y, x) : end;
}

// Where after x the ray leaves the cell.
AIRLIGHT_FN real airlightPhotometryCut(AIRLIGHT_IN(AirlightPhotometryLine) line,
  AIRLIGHT_IN(AirlightPhotometryCell) cell, real x)
{
  real2 row = real2(cell.row.x, cell.row.y);
  real2 column = real2(cell.column.x, cell.column.y);
  real2 cones = cell.type == 2 ? column : row;
  real2 planes = cell.type == 2 ? row : column;
  // Of type C the cones' angles are those from the pole, else from the plane across it.
  cones = cell.type == 1 ? cos(cones) : sin(cones);
  real end = airlightConeCut(line, cones.x, x, real(AIRLIGHT_FAR));
  end = airlightConeCut(line, cones.y, x, end);
  end = airlightPlaneCut(line, planes.x, x, end);
  return airlightPlaneCut(line, planes.y, x, end);
}

// Where the ray passes the pole's axis: x and half the width, from whose ends the axis is seen in a
// right angle. The angle around the pole is that of two linear functions of x, and turns here; as a
// function of complex x it has its singularities at x +- i width.
AIRLIGHT_FN real2 airlightPolePassage(AIRLIGHT_IN(AirlightPhotometryLine) line)
{
  real2 from = real2(line.first.x, line.second.x);
  real2 along = real2(line.first.y, line.second.y);
  real square = dot(along, along);
  return square > real(1e-12)
    ? real2(-dot(from, along), abs(from.x * along.y - from.y * along.x)) / square
    : real2(AIRLIGHT_FAR, AIRLIGHT_FAR);
}

// How wide a panel from a on may be beside that passage, which both are given in its variable: no
// wider than it is far away, so that nodes are as dense as the angle turns. What is nearer than
// `least` counts as a jump.
AIRLIGHT_FN real airlightPanelBesidePole(real2 passage, real a, real least)
{
  real gap = passage.x - a;
  real away = gap > real(0.0) ? real(0.5) * gap : -gap;
  return max(away, max(passage.y, least));
}

// Most cells are narrow: Gauss and Legendre's three nodes are enough where the panel is no wider
// than this in v (the integrand's next singularities are pi/2 away from real v).
#define AIRLIGHT_NARROW 0.2

// The narrowest panels beside a pole, of the widest.
#define AIRLIGHT_POLE 1e-4

// Node k of a panel on [-1, 1]: position, weight, weights of what tells how rough the integrand is:
// airlightRoughWeight(), or for three nodes what one node would make of a difference.
AIRLIGHT_FN real4 airlightCellNode(bool narrow, int k)
{
  if (narrow)
  {
    return k == 1 ? real4(real(0.0), real(0.8888888888888889), real(-1.1111111111111111), real(0.0))
                  : real4(real(k - 1) * real(0.7745966692414834), real(0.5555555555555556),
                      real(0.5555555555555556), real(0.0));
  }
  real2 node = airlightGaussNode(k / 2);
  real2 rough = airlightRoughWeight(k / 2);
  return k % 2 == 0 ? real4(node.x, node.y, rough.x, rough.y)
                    : real4(-node.x, node.y, rough.x, -rough.y);
}

// What is scattered on one panel inside one cell; `errorEstimate` is how much it may be wrong by.
// The variable is t where `straight`, else v with t - tL = h sinh v.
AIRLIGHT_FN real3 airlightCellPanel(AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light,
  AIRLIGHT_IN(AirlightRay) ray, AIRLIGHT_IN(AirlightPiece) piece,
  AIRLIGHT_IN(AirlightPhotometryCell) cell, bool straight, real w0, real w1,
  AIRLIGHT_OUT(real3) errorEstimate)
{
  real middle = real(0.5) * (w0 + w1);
  real reach = real(0.5) * (w1 - w0);
  // Not where the light comes in from outside a region: there its way has kinks of its own.
  bool smoothWay = AIRLIGHT_MEDIUM_COUNT == 1 &&
    AIRLIGHT_REGION_KIND(airlightMedia.item[0].region) != AIRLIGHT_REGION_SURFACE &&
    airlightHolds(airlightMedia.item[0].region, light.position);
  bool narrow = smoothWay && (straight || w1 - w0 < real(AIRLIGHT_NARROW));
  int count = narrow ? 3 : AIRLIGHT_GAUSS_COUNT;
  real tL = ray.range.x + ray.foot.tL;
  real h = ray.foot.h;
  real3 sum = real3(real(0.0));
  real3 even = real3(real(0.0));
  real3 odd = real3(real(0.0));
  for (int k = 0; k < AIRLIGHT_ROLLED(count); k++)
  {
    real4 node = airlightCellNode(narrow, k);
    real w = middle + reach * node.x;
    real e = exp(straight ? real(0.0) : w);
    real x = straight ? w - tL : real(0.5) * h * (e - real(1.0) / e);
    real r = straight ? sqrt(h * h + x * x) : real(0.5) * h * (e + real(1.0) / e);
    real3 direction = normalize(ray.origin + (tL + x) * ray.direction - light.position);
    real3 value = (straight ? real(1.0) : r) *
      airlightPhotometryInside(light.photometry, cell, direction) *
      airlightIntegrand(AIRLIGHT_MEDIA_OUT light, ray, piece, tL + x, x, r);
    sum += node.y * value;
    even += node.z * value;
    odd += node.w * value;
  }
  // One node is wrong by the square of the width, three by its sixth power: the square of the
  // relative difference is still on the safe side.
  errorEstimate = reach *
    (narrow ? abs(even) * min(abs(even) / max(sum, real3(real(1e-30))), real3(real(1.0)))
            : airlightRough(even, odd));
  return reach * sum;
}

// t - tL a little further on than w, where rounding does not lead back into the cell before.
AIRLIGHT_FN real airlightJustAfter(bool straight, real tL, real h, real w)
{
  real x = straight ? w - tL : real(0.5) * h * (exp(w) - exp(-w));
  return x + real(1e-5) * (abs(x) + h);
}

// One piece from w0 to w1 of a light with a photometric table, cell by cell; where that leaves too
// much in doubt, again with panels halved.
AIRLIGHT_FN real3 airlightGoniometricPiece(AIRLIGHT_MEDIA_IN AIRLIGHT_IN(AirlightLight) light,
  AIRLIGHT_IN(AirlightRay) ray, AIRLIGHT_IN(AirlightPiece) piece, bool straight, real w0, real w1)
{
  real tL = ray.range.x + ray.foot.tL;
  real3 foot = ray.origin + tL * ray.direction - light.position;
  foot -= dot(foot, ray.direction) * ray.direction;
  int type = int(AIRLIGHT_FETCH(light.photometry, light.photometry.first).z);
  AirlightPhotometryLine line =
    airlightPhotometryLine(light.photometry, type, foot, ray.direction);
  real2 pole = airlightPolePassage(line);
  real beyond = sqrt(ray.foot.h * ray.foot.h + pole.x * pole.x);
  pole = straight ? real2(tL + pole.x, pole.y)
                  : real2(airlightAsinh(pole.x / ray.foot.h), pole.y / beyond);
  real widest = straight ? w1 - w0 : real(1.0);
  real3 limit = real3(real(AIRLIGHT_FAR)); // of a panel's error; none at first
  real3 sum = real3(real(0.0));
  int steps = 0;
  for (int pass = 0; pass < AIRLIGHT_ROLLED(2); pass++)
  {
    real3 errorEstimate = real3(real(0.0));
    sum = real3(real(0.0));
    AirlightPhotometryCell cell;
    real a = w0;
    real end = w0;
    real step = widest;
    // More than any table and any number of halvings have needed; a bound, so that every driver
    // ends.
    for (; steps < 3000 && a < w1; steps++)
    {
      real most = airlightPanelBesidePole(pole, a, real(AIRLIGHT_POLE) * widest);
      if (a >= end)
      {
        step = min(widest, most);
        real after = airlightJustAfter(straight, tL, ray.foot.h, a);
        // Beside a pole the cell just left and the next one differ by roundings: there the middle
        // of the panel tells. And cells are looked up for each panel: where a ray leaves one can be
        // missed.
        bool beside = most < widest;
        real x = after;
        for (int look = beside ? 0 : 1; look < AIRLIGHT_ROLLED(2); look++)
        {
          cell = airlightPhotometryCell(light.photometry, normalize(foot + x * ray.direction));
          x = airlightPhotometryCut(line, cell, after);
          end = straight ? tL + x : airlightAsinh(x / ray.foot.h);
          end = end > a ? min(end, w1) : w1;
          end = beside ? min(end, a + step) : end;
          x = airlightJustAfter(straight, tL, ray.foot.h, real(0.5) * (a + end));
        }
      }
      if (cell.corners == real4(real(0.0)))
      {
        a = end;
        continue;
      }
      step = min(step, most);
      // The last one may be a rounding error wide.
      real b = end - a < real(1.01) * step ? end : a + step;
      real3 part;
      real3 value =
        airlightCellPanel(AIRLIGHT_MEDIA_OUT light, ray, piece, cell, straight, a, b, part);
      // Written so that what is not a number ends it, too.
      if (any(greaterThan(part, limit)) && b - a > widest * real(1.0 / 512.0))
      {
        step = real(0.5) * (b - a);
      }
      else
      {
        sum += value;
        errorEstimate += part;
        a = b;
        step = min(real(2.0) * step, widest);
      }
    }
    if (!any(greaterThan(errorEstimate, real(2.0 * AIRLIGHT_PANEL_TOLERANCE) * sum)))
    {
      return sum;
    }
    limit = real(AIRLIGHT_PANEL_TOLERANCE) * sum;
  }
  return sum;
}

#endif
