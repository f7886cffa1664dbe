#version 330
// What VTK's mappers drew from a light, made part of its shadow map: each texel with a bias by the
// slope between it and its neighbours on the same thing.

// distances on the unit of airlightDirection(); 1e30 where there is nothing
uniform sampler2D drawn;
uniform int resolution;  // of a face
uniform int parallel;    // 1: that unit is 1
uniform vec2 scale;      // of tangents, to -1..1
uniform float offset;    // of the camera that drew, before where distances count from

layout(location = 0) out vec4 nearestDistance;

float getDistance(ivec2 texel)
{
  vec2 s = (2.0 * (vec2(texel % resolution) + 0.5) / float(resolution) - 1.0) / scale;
  return texelFetch(drawn, texel, 0).r * (parallel != 0 ? 1.0 : length(vec3(s, 1.0)));
}

// To the nearer neighbour of two, which is the likelier to be of the same thing.
float rise(ivec2 texel, float here, ivec2 along)
{
  ivec2 first = texel / resolution * resolution;
  float least = 1e30;
  for (int side = -1; side <= 1; side += 2)
  {
    ivec2 other = texel + side * along;
    if (other / resolution * resolution == first && all(greaterThanEqual(other, first)))
    {
      least = min(least, abs(getDistance(other) - here));
    }
  }
  return least < 0.1 * abs(here) ? least : 0.0;
}

void main()
{
  ivec2 texel = ivec2(gl_FragCoord.xy);
  float here = getDistance(texel);
  if (here >= 1e29)
  {
    discard;
  }
  float bias = rise(texel, here, ivec2(1, 0)) + rise(texel, here, ivec2(0, 1));
  nearestDistance = vec4(here + bias - offset);
}
