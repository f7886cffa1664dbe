// Whether a shadow map lets light through to a point.

uniform sampler2D shadowMap; // distance that the light goes; 1e30 where nothing is in its way
uniform int mapKind;         // 0: no casters, 1: six faces, 2: one in perspective, 3: parallel
uniform int mapResolution;
// from the eye: the light, or where it is at infinity the casters' middle
uniform vec3 mapOrigin;
uniform vec3 mapFrame[3];   // kinds 2 and 3: across, across, away from the light
uniform vec2 mapScale;      // of tangents, kind 3 of lengths, to -1..1
uniform float mapSlack;     // roundings: so much,
uniform float mapRelativeSlack; // and so much of the distance

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
  int row = face < 3 ? 0 : 1;
  position.face = mapResolution * ivec2(face - 3 * row, row);
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
