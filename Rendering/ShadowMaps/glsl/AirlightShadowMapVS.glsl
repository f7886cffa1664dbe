#version 330
// A caster's triangle as a light sees it, on one face of its shadow map.

in vec3 position; // from the light, or from any point where that is at infinity
in vec4 plane;    // see below
in float limit;

uniform vec3 frame[3]; // across, across, away from the light
uniform vec2 scale;    // of tangents, or where `parallel` of lengths, to -1..1
uniform int parallel;
uniform float nearest; // nothing nearer to the light's plane is drawn

// normal in that frame, away from the light; dot(normal, x) of its points
flat out vec4 trianglePlane;
flat out float triangleLimit; // its largest distance

void main()
{
  vec3 q = vec3(dot(position, frame[0]), dot(position, frame[1]), dot(position, frame[2]));
  trianglePlane =
    vec4(dot(plane.xyz, frame[0]), dot(plane.xyz, frame[1]), dot(plane.xyz, frame[2]), plane.w);
  triangleLimit = limit;
  // Clipped at -w <= z only, which is depth >= nearest.
  gl_Position =
    parallel != 0 ? vec4(q.xy * scale, 0.0, 1.0) : vec4(q.xy * scale, -nearest, q.z);
}
