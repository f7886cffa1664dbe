#version 330
// The distance at which a triangle ends the light of a texel: the largest one within three quarters
// of a texel to either side of its middle, on the triangle's plane, but not beyond the triangle. A
// face, however slanted, so never shadows itself: the bias is in the map, by each face's slope.

uniform vec2 scale;
uniform int resolution;
uniform int parallel;
uniform ivec2 tile; // of the face's lower left corner

flat in vec4 trianglePlane;
flat in float triangleLimit;

layout(location = 0) out vec4 nearestDistance;

void main()
{
  vec3 n = trianglePlane.xyz;
  vec2 s = (2.0 * (gl_FragCoord.xy - vec2(tile)) / float(resolution) - 1.0) / scale;
  vec2 reach = 1.5 / (float(resolution) * scale);
  float slope = dot(abs(n.xy), reach);
  float far = triangleLimit;
  if (parallel != 0)
  {
    float rise = trianglePlane.w - dot(n.xy, s) + slope;
    far = n.z > 0.0 ? rise / n.z : far;
  }
  else
  {
    float facing = n.z + dot(n.xy, s) - slope;
    far = facing > 0.0 ? length(vec3(abs(s) + reach, 1.0)) * trianglePlane.w / facing : far;
  }
  nearestDistance = vec4(min(far, triangleLimit));
}
