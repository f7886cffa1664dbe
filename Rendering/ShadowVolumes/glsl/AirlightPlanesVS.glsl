// Shadow planes: each silhouette edge, pulled out of a buffer, becomes the quadrilateral from the
// edge to infinity, away from the light, or to where all that follows is hidden. AIRLIGHT_CAPS: a
// caster's own triangles, where rays go through them. AIRLIGHT_NEAR_PLANES: those on which rays
// start, which the eye would see edge-on; a triangle over the whole view lets the fragments find
// out which rays cross them.

// Relative to the anchor (the light itself, or for a directional light any point). Per edge: A and
// its weight, B and the number of its caster, the plane's normal. Per cap: A and the side of the
// light (1: where the triangle's normal points, -1: behind), B and the size of the mesh's
// coordinates, C. Per near plane: as an edge, B with the plane's offset from the start of rays, and
// fourth the start's place in the plane. The third's w is the kind of caster.
layout(std430, binding = AIRLIGHT_BINDING_SILHOUETTE_EDGES) readonly buffer AirlightEdges
{
  vec4 edges[];
};

uniform mat4 anchorToClip;
uniform vec3 anchor;     // from the eye
uniform vec4 fromLight;  // directional: the light's direction and w 0; point: w 1
uniform int inParallel;  // 1: the projection is parallel
uniform int againstView; // 1: and the light shines against it: all planes are behind the view
// what all fragments need, see AirlightKBuffer.glsl and AirlightListHeads.glsl
uniform ivec3 givenListLayout;
// As in AirlightCameraShader.glsl.
uniform vec3 airlightRayOrigin[3];
uniform vec3 airlightRayDirection[3];

// The plane met by the ray of pixel p: with q = x + p.x y + p.y z, at w/q on the unit of
// airlightDirection(), in parallel projection at q/w.
flat out vec4 planeRay;
flat out ivec3 listLayout;
flat out int planeWeight;
flat out int planeLayer;
flat out vec3 planeNormal; // the near planes' own: dot(normal, x) = offset, x from the eye
flat out float planeOffset;
flat out float planeRounding; // of a cap's corners
flat out vec3 planeA; // the edge, from the anchor
flat out vec3 planeB;
flat out vec3 planeSides; // the start's place in a near plane (isBehindEdge() of the fragments)

// Sets planeRay.
void meetRays()
{
  vec3 first = inParallel != 0 ? -airlightRayOrigin[0] : airlightRayDirection[0];
  vec3 perX = inParallel != 0 ? -airlightRayOrigin[1] : airlightRayDirection[1];
  vec3 perY = inParallel != 0 ? -airlightRayOrigin[2] : airlightRayDirection[2];
  planeRay = vec4(dot(planeNormal, first), dot(planeNormal, perX), dot(planeNormal, perY),
    inParallel != 0 ? dot(planeNormal, airlightRayDirection[0]) : planeOffset);
  planeRay.x += inParallel != 0 ? planeOffset : 0.0;
#if !AIRLIGHT_CAPS && !AIRLIGHT_NEAR_PLANES
  planeRay = againstView != 0 ? vec4(-1e17, 0.0, 0.0, 1.0) : planeRay;
#endif
}

#if AIRLIGHT_CAPS
void draw()
{
  int first = 3 * (gl_VertexID / 3);
  vec3 a = edges[first].xyz;
  vec3 b = edges[first + 1].xyz;
  vec3 c = edges[first + 2].xyz;
  planeNormal = normalize(cross(b - a, c - a));
  planeWeight = int(edges[first].w);
  planeLayer = int(edges[first + 2].w);
  // Some units of single precision's last place of the farthest corner, from the eye, the anchor or
  // the origin of the coordinates that the mapper has.
  float fromEye = max(length(anchor + a), max(length(anchor + b), length(anchor + c)));
  float size = max(fromEye, edges[first + 1].w);
  planeRounding = 5e-7 * max(size, max(length(a), max(length(b), length(c))));
  planeOffset = dot(planeNormal, anchor + a);
  gl_Position = anchorToClip * vec4(edges[gl_VertexID].xyz, 1.0);
}
#elif AIRLIGHT_NEAR_PLANES
void draw()
{
  int first = 4 * (gl_VertexID / 3);
  int corner = gl_VertexID % 3;
  planeA = edges[first].xyz;
  planeB = edges[first + 1].xyz;
  planeWeight = int(edges[first].w);
  planeOffset = edges[first + 1].w;
  planeNormal = edges[first + 2].xyz;
  planeLayer = int(edges[first + 2].w);
  planeSides = edges[first + 3].xyz;
  gl_Position = vec4(corner == 1 ? 3.0 : -1.0, corner == 2 ? 3.0 : -1.0, -1.0, 1.0);
}
#else
// By caster, from the eye: the plane of a surface that hides all behind it
// (AirlightPlanarOccluders.h), or 0.
layout(
  std430, binding = AIRLIGHT_BINDING_TRUNCATION_PLANES) readonly buffer AirlightTruncationPlanes
{
  vec4 truncationPlanes[];
};

// Where the ray from the light through a point is hidden for good, or at infinity. Of nothing but
// that point and its caster: planes that meet there have the same end.
vec4 getEnd(vec3 point, vec4 end)
{
  vec3 away = fromLight.w == 0.0 ? fromLight.xyz : point;
  float speed = -dot(end.xyz, away);
  // Behind the surface by some units of single precision's last place.
  float height = dot(end.xyz, anchor + point) + end.w + 1e-6 * (length(anchor) + length(point));
  return speed > 0.0 ? vec4(point + max(height, 0.0) / speed * away, 1.0) : vec4(away, 0.0);
}

// The four corners of an edge's plane: A, A far, B, B far.
void draw()
{
  int first = 3 * (gl_VertexID / 4);
  vec4 a = edges[first];
  vec4 b = edges[first + 1];
  planeNormal = edges[first + 2].xyz;
  planeWeight = int(a.w);
  planeLayer = int(edges[first + 2].w);
  // Through the light, which spares the offset of the edge its rounding.
  planeOffset = dot(planeNormal, fromLight.w == 0.0 ? anchor + a.xyz : anchor);

  vec3 near = gl_VertexID % 4 < 2 ? a.xyz : b.xyz;
  bool far = gl_VertexID % 2 == 1;
  gl_Position = anchorToClip * (far ? getEnd(near, truncationPlanes[int(b.w)]) : vec4(near, 1.0));
}
#endif

void main()
{
  planeA = vec3(0.0);
  planeB = vec3(0.0);
  planeSides = vec3(0.0);
  planeRounding = 0.0;
  listLayout = givenListLayout;
  draw();
  meetRays();
}
