// Light and shadow along a ray from a shadow map, step by step.

uniform sampler2D shadowMap; // distance that the light goes; 1e30 where nothing is in its way
uniform int mapKind;         // 0: no casters, 1: six faces, 2: one in perspective, 3: parallel
uniform int mapResolution;
// from the eye: the light, or where it is at infinity the casters' middle
uniform vec3 mapOrigin;
uniform vec3 mapFrame[3];   // kinds 2 and 3: across, across, away from the light
uniform vec2 mapScale;      // of tangents, kind 3 of lengths, to -1..1
uniform float mapNearest;   // kind 3: where casters begin
uniform float mapSlack;     // roundings: so much,
uniform float mapRelativeSlack; // and so much of the distance
uniform int marchSteps;
uniform float marchScale; // directional light: the length on which its shadows change

// Where a point falls in the map.
struct AirlightMapPosition
{
  vec2 texel; // on its face, 0 to mapResolution
  ivec2 face; // the face's lower left corner
  float distance;
  bool inside;
};

// Of a point relative to mapOrigin.
AirlightMapPosition airlightMapPosition(vec3 p)
{
  AirlightMapPosition position;
  vec3 q;
  int face = 0;
  if (mapKind == 1)
  {
    vec3 a = abs(p);
    bool isX = a.x >= a.y && a.x >= a.z;
    bool isY = !isX && a.y >= a.z;
    q = isX ? vec3(p.y, p.z, a.x) : isY ? vec3(p.z, p.x, a.y) : vec3(p.x, p.y, a.z);
    float side = isX ? p.x : isY ? p.y : p.z;
    face = (isX ? 0 : isY ? 2 : 4) + (side < 0.0 ? 1 : 0);
  }
  else
  {
    q = vec3(dot(p, mapFrame[0]), dot(p, mapFrame[1]), dot(p, mapFrame[2]));
  }
  position.distance = mapKind == 3 ? q.z : length(p);
  position.inside = mapKind == 3 || q.z > 0.0;
  vec2 across = mapScale * (mapKind == 3 ? q.xy : q.xy / max(q.z, 1e-30));
  position.inside = position.inside && mapKind != 0 && all(lessThanEqual(abs(across), vec2(1.0)));
  position.texel = float(mapResolution) * (0.5 + 0.5 * clamp(across, -1.0, 1.0));
  position.face = mapResolution * ivec2(face % 3, face / 3);
  return position;
}

bool airlightMapLets(AirlightMapPosition position, ivec2 texel, float slack)
{
  ivec2 inside = clamp(texel, ivec2(0), ivec2(mapResolution - 1));
  return position.distance - slack <= texelFetch(shadowMap, position.face + inside, 0).r;
}

// Whether light reaches a point of the air, relative to mapOrigin.
bool airlightMapIsLit(vec3 point)
{
  AirlightMapPosition position = airlightMapPosition(point);
  return !position.inside || airlightMapLets(position, ivec2(floor(position.texel)),
                            mapSlack + mapRelativeSlack * abs(position.distance));
}

// The same of a point from the eye.
bool airlightIsLit(vec3 point) { return airlightMapIsLit(point - mapOrigin); }

// Whether light reaches a point of a surface. A point near a convex edge may lie in a texel whose
// middle sees the face beyond the edge, so that any of the four texels around it may let the light
// through; the view ray's end is less exact than points of the air.
bool airlightIsSurfaceLit(vec3 point)
{
  AirlightMapPosition position = airlightMapPosition(point - mapOrigin);
  float slack = 10.0 * (mapSlack + mapRelativeSlack * abs(position.distance));
  ivec2 first = ivec2(floor(position.texel - 0.5));
  bool lit = !position.inside;
  for (int i = 0; i < 4; i++)
  {
    lit = lit || airlightMapLets(position, first + ivec2(i % 2, i / 2), slack);
  }
  return lit;
}

// The part of a ray that is marched and how its steps divide it: for lights at a place into equal
// angles seen from there, for directional lights into lengths that grow slowly.
struct AirlightMarch
{
  AirlightRay ray;
  float from; // point light: distance from the foot; directional: distance along the ray
  float to;
  float turn; // point light: the whole angle
  bool point;
};

void airlightClipToMap(inout AirlightMarch march, int axis)
{
  float o = dot(march.ray.origin - mapOrigin, mapFrame[axis]);
  float d = dot(march.ray.direction, mapFrame[axis]);
  // Across: |o + t d| scale <= 1. Along: o + t d >= nearest.
  float reach = axis < 2 ? 1.0 / mapScale[axis] : 0.0;
  float low = axis < 2 ? -reach : mapNearest;
  float high = axis < 2 ? reach : AIRLIGHT_FAR;
  if (d == 0.0)
  {
    march.to = o >= low && o <= high ? march.to : march.from;
    return;
  }
  float a = (low - o) / d;
  float b = (high - o) / d;
  march.from = max(march.from, min(a, b));
  march.to = max(min(march.to, max(a, b)), march.from);
}

AirlightMarch airlightMarch(AirlightRay ray, bool clipped)
{
  AirlightMarch march;
  march.ray = ray;
  march.point = !airlightIsDirectional(light);
  march.from = ray.lit.x;
  march.to = ray.lit.y;
  march.turn = 0.0;
  if (march.point)
  {
    march.from = airlightFromFoot(ray, ray.lit.x);
    march.to = airlightFromFoot(ray, ray.lit.y);
    march.turn = airlightAngle(ray.foot.h * (march.to - march.from),
      ray.foot.h * ray.foot.h + march.from * march.to);
  }
  else if (clipped)
  {
    for (int axis = 0; axis < 3; axis++)
    {
      airlightClipToMap(march, axis);
    }
  }
  return march;
}

// The parameter of a step's end: distance from the foot, or a share of the way.
float airlightMarchStep(AirlightMarch march, int step)
{
  float share = float(step) / float(marchSteps);
  if (!march.point)
  {
    return share;
  }
  if (step == marchSteps)
  {
    return march.to;
  }
  float c = cos(share * march.turn);
  float s = sin(share * march.turn);
  float h = march.ray.foot.h;
  float x = h * (march.from * c + h * s) / max(h * c - march.from * s, 1e-30);
  return clamp(x, march.from, march.to);
}

// The parameter in the middle of two.
float airlightMarchMiddle(AirlightMarch march, float a, float b)
{
  if (!march.point)
  {
    return 0.5 * (a + b);
  }
  float h = march.ray.foot.h;
  float k = sqrt(h * h + a * a) / sqrt(h * h + b * b);
  return (a + b * k) / (1.0 + k);
}

// The distance along the ray.
float airlightMarchDistance(AirlightMarch march, float x)
{
  if (march.point)
  {
    return march.ray.range.x + march.ray.foot.tL + x;
  }
  float way = march.to - march.from;
  return march.from + way * x / (x + (1.0 - x) * (1.0 + 0.25 * way / marchScale));
}

vec3 airlightMarchPoint(AirlightMarch march, float x)
{
  return march.ray.origin + airlightMarchDistance(march, x) * march.ray.direction;
}
