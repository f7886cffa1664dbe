// Each fragment of a shadow plane is a boundary (t, +-weight) in its pixel's list.

layout(early_fragment_tests) in;

// Three words a boundary: t, weight, index of the next; index 0 ends a list.
layout(std430, binding = 1) writeonly buffer AirlightNodes
{
  uint nodes[];
};
layout(std430, binding = 2) buffer AirlightHeads
{
  uint heads[]; // one a pixel, after the counter
};

uniform sampler2D distances;
uniform uint capacity; // boundaries that fit
uniform int width;

flat in vec3 planeNormal;
flat in float planeOffset;
flat in int planeWeight;

void main()
{
  vec2 p = airlightPixel();
  vec3 origin = airlightOrigin(p);
  vec3 direction = normalize(airlightDirection(p));
  float t = (planeOffset - dot(planeNormal, origin)) / dot(planeNormal, direction);
  ivec2 pixel = ivec2(p);
  float surface = texelFetch(distances, pixel, 0).r;
  // The depth test, made lenient, rejects most of what the surface hides; this is the exact one.
  if (surface >= 0.0 && !(t < surface))
  {
    return;
  }
  // A plane seen edge-on can give no finite t; it is then as good as behind everything.
  if (!(abs(t) < 1e18))
  {
    t = 1e18;
  }
  uint index = atomicAdd(heads[0], 1u) + 1u;
  if (index < capacity)
  {
    uint next = atomicExchange(heads[1 + pixel.y * width + pixel.x], index);
    nodes[3u * index] = floatBitsToUint(t);
    nodes[3u * index + 1u] = uint(gl_FrontFacing ? planeWeight : -planeWeight);
    nodes[3u * index + 2u] = next;
  }
}
