// Boundaries in lists, a list for each pixel: nodes of AIRLIGHT_NODE_WORDS, where index 0 ends a
// list. The first word is the distance on the unit of airlightDirection(). If there are slots, it
// is as in AirlightKBuffer.glsl, and the weight is in it. With AIRLIGHT_SHADOW_TRANSMITTANCE the
// weight is eight times the number of layers and a bit for each channel that they block.

const uint AIRLIGHT_NODE_WEIGHT = 1u;
const uint AIRLIGHT_NODE_NEXT = 2u;
const uint AIRLIGHT_NODE_THICKNESS = 3u; // optical thickness of the layers, by channel

layout(std430, binding = AIRLIGHT_BINDING_BOUNDARIES) buffer AirlightNodes
{
  uint nodes[];
};

uint airlightNextNode(uint node)
{
  return nodes[AIRLIGHT_NODE_WORDS * node + AIRLIGHT_NODE_NEXT];
}

float airlightNodeDistance(uint node)
{
#if AIRLIGHT_K_BUFFER_SIZE > 0
  return airlightPackedDistance(nodes[AIRLIGHT_NODE_WORDS * node]);
#else
  return uintBitsToFloat(nodes[AIRLIGHT_NODE_WORDS * node]);
#endif
}
