// Each fragment of a shadow plane is a boundary (t, +-weight) in one of its pixel's slots, or where
// there is none left, in the pixel's list; or with AIRLIGHT_FROXELS, one more in the sums of the
// first node of a froxel grid behind it (AirlightFroxelGrid.glsl). What software renderers do for
// each of eight pixels in turn takes most of the time, also where only one of them needs it:
// writing to memory, above all atomically. The depth test, made lenient, rejects most of what the
// surface hides; who reads the boundaries leaves out the rest.

layout(early_fragment_tests) in;

#if AIRLIGHT_SHADOW_TRANSMITTANCE
// By kind of caster: the thickness of a layer, and a bit for each channel that it blocks.
layout(std430, binding = AIRLIGHT_BINDING_CASTER_THICKNESS) readonly buffer AirlightShadowLayers
{
  ivec4 shadowLayers[];
};
flat in int planeLayer;
#endif

#if AIRLIGHT_CAPS
// The surface that the ray ends on is none that it goes through. Its distance is as the mapper
// draws it, which for triangles that are large or far from the eye has the rounding of their
// corners, the more the more edge-on they are seen. Graphics cards also move corners to whole
// fractions of a pixel: so much of one the surface lies beside its place. NEARER is for roundings
// of theirs where that changes no distance; no test fails without it.
uniform sampler2D distances;
const float NEARER = 1.0 - 1e-5;
const float SUBPIXEL = 1.0 / 256.0;
flat in float planeRounding;
#endif
#if AIRLIGHT_NEAR_PLANES
uniform vec4 fromLight; // directional: the light's direction and w 0; point: w 1
uniform vec3 anchor;    // from the eye: in parallel projection the light, through which planes go
#endif

flat in vec4 planeRay; // AirlightPlanesVS.glsl
flat in int planeWeight;
#if AIRLIGHT_NEAR_PLANES || AIRLIGHT_CAPS
flat in vec3 planeNormal;
#endif
#if AIRLIGHT_NEAR_PLANES
flat in float planeOffset;
flat in vec3 planeA;
flat in vec3 planeB;
flat in vec3 planeSides; // of the start
#endif

#if AIRLIGHT_NEAR_PLANES
// By how much a way leads away from the plane's two sides and from the edge.
vec3 getTurns(vec3 way)
{
  vec3 sideA = fromLight.w != 0.0 ? planeA : fromLight.xyz;
  vec3 sideB = fromLight.w != 0.0 ? planeB : fromLight.xyz;
  return vec3(dot(cross(sideA, way), planeNormal), dot(cross(way, sideB), planeNormal),
    dot(cross(way, planeB - planeA), planeNormal));
}

// Whether the ray's point at t lies beyond the edge and between the plane's two sides. In a
// perspective from the eye's own place on, which decides where all rays meet the plane right before
// it. In parallel projection the ray comes from its start's own place at infinity.
bool isBehindEdge(float t, vec2 p)
{
  vec3 place = planeSides + t * getTurns(airlightDirection(p));
  if (airlightParallel != 0)
  {
    place = getTurns(airlightOrigin(p) - anchor) - t * planeSides;
    place.z -= dot(cross(planeA, planeB), planeNormal);
  }
  return all(greaterThanEqual(place, vec3(0.0)));
}
#endif

#ifdef AIRLIGHT_FROXELS
void addBoundary(ivec2 pixel, float t, int weight)
{
  ivec4 layer = shadowLayers[planeLayer];
  int node = airlightFroxelNodeAt(t);
  int number = airlightFroxelLightNumber(airlightFroxelLight);
  if (layer.w != 0)
  {
    atomicAdd(froxelNumbers[airlightFroxelIndex(pixel, node, number + 3)], weight);
    return;
  }
  for (int i = 0; i < 3; i++)
  {
    atomicAdd(froxelNumbers[airlightFroxelIndex(pixel, node, number + i)], weight * layer[i]);
  }
}
#else
void addBoundary(ivec2 pixel, float t, int weight)
{
#if AIRLIGHT_K_BUFFER_SIZE > 0
  uint boundary = airlightPackBoundary(t, weight);
  uint slot = atomicAdd(listHeads[airlightCountIndex(pixel)], 1u);
  if (slot < uint(AIRLIGHT_K_BUFFER_SIZE))
  {
    kBuffer[airlightKBufferIndex(airlightKBufferStart(pixel), slot)] = boundary;
    return;
  }
#endif
  uint index = atomicAdd(listHeads[0], 1u) + 1u;
  if (index > AIRLIGHT_MOST_BOUNDARIES)
  {
    atomicExchange(listHeads[0], AIRLIGHT_MOST_BOUNDARIES);
  }
  if (index < uint(nodes.length()) / AIRLIGHT_NODE_WORDS)
  {
    uint word = AIRLIGHT_NODE_WORDS * index;
    nodes[word + AIRLIGHT_NODE_NEXT] = atomicExchange(listHeads[airlightHeadIndex(pixel)], index);
#if AIRLIGHT_K_BUFFER_SIZE > 0
    nodes[word] = boundary;
#else
    nodes[word] = floatBitsToUint(t);
#if AIRLIGHT_SHADOW_TRANSMITTANCE
    ivec4 layer = shadowLayers[planeLayer];
    nodes[word + AIRLIGHT_NODE_WEIGHT] = uint(8 * weight + layer.w);
    for (uint i = 0u; i < 3u; i++)
    {
      nodes[word + AIRLIGHT_NODE_THICKNESS + i] = uint(weight * layer[i]);
    }
#else
    nodes[word + AIRLIGHT_NODE_WEIGHT] = uint(weight);
#endif
#endif
  }
}
#endif

// Where the pixel's ray meets the plane, on the unit of airlightDirection().
float meetPlane(vec2 p)
{
#if AIRLIGHT_NEAR_PLANES
  return airlightParallel != 0 ? dot(planeNormal, anchor - airlightOrigin(p)) / planeOffset
                               : planeOffset / dot(planeNormal, airlightDirection(p));
#else
  float q = planeRay.x + p.x * planeRay.y + p.y * planeRay.z;
  return airlightParallel != 0 ? q / planeRay.w : planeRay.w / q;
#endif
}

#if AIRLIGHT_CAPS
// By how much that distance changes within SUBPIXEL.
float getSubpixelChange(float t)
{
  float slope = (abs(planeRay.y) + abs(planeRay.z)) / abs(planeRay.w);
  return SUBPIXEL * (airlightParallel != 0 ? slope : t * t * slope);
}
#endif

void main()
{
  vec2 p = airlightPixel();
  float t = meetPlane(p);
  bool enters = gl_FrontFacing;
#if AIRLIGHT_NEAR_PLANES
  enters = planeOffset < 0.0;
  if (!(airlightParallel != 0 || t > 0.0) || !isBehindEdge(t, p))
  {
    return;
  }
#endif
  ivec2 pixel = ivec2(p);
#if AIRLIGHT_CAPS
  float unit = airlightRayUnit(p);
  float surface = unit * texelFetch(distances, pixel, 0).r;
  float cosine = abs(dot(planeNormal, airlightDirection(p))) / length(airlightDirection(p));
  float change = getSubpixelChange(t);
  if (surface >= 0.0 && !(cosine * (t + change) * unit < cosine * NEARER * surface - planeRounding))
  {
    return;
  }
#endif
  // A plane seen edge-on can give no finite t, or in a perspective one behind the eye, where the
  // rasteriser has rounded its corners to fractions of a pixel; it is then as good as behind
  // everything.
  if (!(abs(t) < 1e18) || (airlightParallel == 0 && t < 0.0))
  {
    t = 1e18;
  }
  addBoundary(pixel, t, enters ? planeWeight : -planeWeight);
}
