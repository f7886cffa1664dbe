// Each fragment of a shadow plane is a boundary (t, +-weight) in one of its pixel's slots, or where
// there is none left, in the pixel's list.

layout(early_fragment_tests) in;

// The words of a boundary are those of AirlightBoundaries.glsl; index 0 ends a list.
layout(std430, binding = 1) writeonly buffer AirlightNodes
{
  uint nodes[];
};

#if AIRLIGHT_DIMMED
// By kind of caster: the thickness of a layer, and a bit for each channel that it blocks.
layout(std430, binding = 6) readonly buffer AirlightShadowLayers
{
  ivec4 shadowLayers[];
};
flat in int planeLayer;
#endif

uniform sampler2D distances;
uniform float nearer; // a boundary counts where t < nearer * surface
uniform uint capacity; // boundaries that fit
#if AIRLIGHT_NEAR_PLANES
uniform vec3 anchor;    // from the eye
uniform vec4 fromLight; // directional: the light's direction and w 0; point: w 1
#endif

flat in vec3 planeNormal;
flat in float planeOffset;
flat in int planeWeight;
#if AIRLIGHT_NEAR_PLANES
flat in vec3 planeA;
flat in vec3 planeB;
#endif

#if AIRLIGHT_NEAR_PLANES
// Whether a point of the plane, from the anchor, lies beyond the edge and between its two sides.
bool isBehindEdge(vec3 point)
{
  bool isPoint = fromLight.w != 0.0;
  vec3 sideA = isPoint ? planeA : fromLight.xyz;
  vec3 sideB = isPoint ? planeB : fromLight.xyz;
  vec3 apexA = isPoint ? vec3(0.0) : planeA;
  vec3 apexB = isPoint ? vec3(0.0) : planeB;
  return dot(cross(sideA, point - apexA), planeNormal) >= 0.0 &&
    dot(cross(point - apexB, sideB), planeNormal) >= 0.0 &&
    dot(cross(point - planeA, planeB - planeA), planeNormal) >= 0.0;
}
#endif

// A boundary of the pixel's list.
void addToList(ivec2 pixel, float t, int weight)
{
  uint index = atomicAdd(heads[0], 1u) + 1u;
  if (index < capacity)
  {
    uint word = AIRLIGHT_NODE_WORDS * index;
    nodes[word] = floatBitsToUint(t);
    nodes[word + 2u] = atomicExchange(heads[airlightHeadIndex(pixel)], index);
#if AIRLIGHT_DIMMED
    ivec4 layer = shadowLayers[planeLayer];
    nodes[word + 1u] = uint(8 * weight + layer.w);
    for (uint i = 0u; i < 3u; i++)
    {
      nodes[word + 3u + i] = uint(weight * layer[i]);
    }
#else
    nodes[word + 1u] = uint(weight);
#endif
  }
}

#if AIRLIGHT_SLOTS > 0
// Weights beyond 2, where many triangles have one edge, take several slots.
void addToSlots(ivec2 pixel, float t, int weight)
{
  uint first = airlightFirstSlot(pixel);
  for (int left = weight; left != 0;)
  {
    int part = clamp(left, -2, 2);
    left -= part;
    uint slot = atomicAdd(heads[airlightCountIndex(pixel)], 1u);
    if (slot < uint(AIRLIGHT_SLOTS))
    {
      slots[first + 64u * slot] = airlightKey(t, part);
    }
    else
    {
      addToList(pixel, t, part);
      if (slot == uint(AIRLIGHT_SLOTS))
      {
        atomicAdd(heads[2], 1u);
      }
      atomicMax(heads[1], slot + 1u);
    }
  }
}
#endif

void main()
{
  vec2 p = airlightPixel();
  vec3 origin = airlightOrigin(p);
  vec3 direction = normalize(airlightDirection(p));
  float t = (planeOffset - dot(planeNormal, origin)) / dot(planeNormal, direction);
  bool enters = gl_FrontFacing;
#if AIRLIGHT_NEAR_PLANES
  enters = planeOffset < 0.0;
  if (!(t > 0.0) || !isBehindEdge(t * direction - anchor))
  {
    return;
  }
#endif
  ivec2 pixel = ivec2(p);
  float surface = texelFetch(distances, pixel, 0).r;
  // The depth test, made lenient, rejects most of what the surface hides; this is the exact one.
  if (surface >= 0.0 && !(t < nearer * surface))
  {
    return;
  }
  // A plane seen edge-on can give no finite t; it is then as good as behind everything.
  if (!(abs(t) < 1e18))
  {
    t = 1e18;
  }
  int weight = enters ? planeWeight : -planeWeight;
#if AIRLIGHT_SLOTS > 0
  addToSlots(pixel, t, weight);
#else
  addToList(pixel, t, weight);
#endif
}
