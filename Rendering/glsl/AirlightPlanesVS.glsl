#version 430
// Shadow planes: each silhouette edge, pulled out of a buffer, becomes the quadrilateral from the
// edge to infinity, away from the light.

// Per edge: A and its weight, B, the plane's normal; relative to the anchor (the light itself, or
// for a directional light any point).
layout(std430, binding = 0) readonly buffer AirlightEdges
{
  vec4 edges[];
};

uniform mat4 anchorToClip;
uniform vec3 anchor;     // from the eye
uniform vec4 fromLight;  // directional: the light's direction and w 0; point: w 1

flat out vec3 planeNormal;
flat out float planeOffset; // dot(normal, x) = offset on the plane, x from the eye
flat out int planeWeight;

void main()
{
  vec4 a = edges[3 * (gl_VertexID / 6)];
  vec4 b = edges[3 * (gl_VertexID / 6) + 1];
  planeNormal = edges[3 * (gl_VertexID / 6) + 2].xyz;
  planeWeight = int(a.w);
  // Through the light, which spares the offset of the edge its rounding.
  planeOffset = dot(planeNormal, fromLight.w == 0.0 ? anchor + a.xyz : anchor);

  // Two triangles (A, A far, B), (B, A far, B far): front faces are seen from outside the volume.
  int corner = gl_VertexID % 6;
  vec3 near = corner == 0 || corner == 1 || corner == 4 ? a.xyz : b.xyz;
  bool far = corner == 1 || corner == 4 || corner == 5;
  gl_Position = anchorToClip *
    (far ? vec4(fromLight.w == 0.0 ? fromLight.xyz : near, 0.0) : vec4(near, 1.0));
}
