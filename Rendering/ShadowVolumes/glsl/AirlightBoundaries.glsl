// The boundaries of a pixel in order of distance. A first draw takes the pixels whose boundaries
// have slots, or where there are none (AIRLIGHT_K_BUFFER_SIZE 0), those with short lists, which are
// sorted here in a local array. It leaves out the others; AirlightSortFS.glsl sorts their lists in
// place, and further draws with AIRLIGHT_SORTED read them as they are, some boundaries a draw,
// because some software renderers bound the iterations of one shader run.
//
// A boundary has AIRLIGHT_NODE_WORDS: distance on the unit of airlightDirection(), weight, index of
// the next. Where there are slots, the first word is as that of a slot, and the second for who
// reads it. With AIRLIGHT_SHADOW_TRANSMITTANCE the weight is eight times the number of layers and a
// bit for each channel that they block, and the optical thickness of the layers follows.

layout(std430, binding = AIRLIGHT_BINDING_BOUNDARIES) buffer AirlightNodes
{
  uint nodes[];
};
float boundaryUnit; // of their distances
float boundaryEnd;  // where those that count end, on that unit

// For a ray that ends at `surface` on that unit, where that is not below 0.
void airlightEndBoundaries(float surface, float unit)
{
  boundaryUnit = unit;
  boundaryEnd = surface >= 0.0 ? surface : 1e37;
}

const int AIRLIGHT_MORE = 0;  // a boundary
const int AIRLIGHT_PAUSE = 1; // the rest is the next draw's
const int AIRLIGHT_END = 2;   // none is left

float airlightNodeDistance(uint node)
{
#if AIRLIGHT_K_BUFFER_SIZE > 0
  return airlightPackedDistance(nodes[AIRLIGHT_NODE_WORDS * node]);
#else
  return uintBitsToFloat(nodes[AIRLIGHT_NODE_WORDS * node]);
#endif
}

AirlightCounts airlightWeight(uint node)
{
#if AIRLIGHT_K_BUFFER_SIZE > 0
  return airlightPackedWeight(nodes[AIRLIGHT_NODE_WORDS * node]);
#else
  int weight = int(nodes[AIRLIGHT_NODE_WORDS * node + 1u]);
#if AIRLIGHT_SHADOW_TRANSMITTANCE
  uint word = AIRLIGHT_NODE_WORDS * node + 3u;
  return AirlightCounts((weight >> 3) * ivec3(weight & 1, (weight >> 1) & 1, (weight >> 2) & 1),
    ivec3(int(nodes[word]), int(nodes[word + 1u]), int(nodes[word + 2u])));
#else
  return weight;
#endif
#endif
}

#ifdef AIRLIGHT_SORTED

uniform int resume; // 0: the first draw of the sorted lists

uint boundaryNode;
uint boundaryLast;
int boundariesLeft;

#if AIRLIGHT_SHADOW_TRANSMITTANCE

uint boundaryPrevious; // the last but one

// What a pause leaves takes the last two boundaries read, the first of which becomes the head.
void airlightLeave(float from, AirlightCounts shadows)
{
  uint a = AIRLIGHT_NODE_WORDS * boundaryPrevious;
  uint b = AIRLIGHT_NODE_WORDS * boundaryLast;
  nodes[a] = floatBitsToUint(from);
  nodes[b] = floatBitsToUint(airlightRunStart);
  nodes[a + 1u] = uint(shadows.blocks.r);
  nodes[b + 1u] = uint(shadows.thickness.r);
  for (uint i = 1u; i < 3u; i++)
  {
    nodes[a + 2u + i] = uint(shadows.blocks[i]);
    nodes[b + 2u + i] = uint(shadows.thickness[i]);
  }
}

void airlightTakeUp(out float from, out AirlightCounts shadows)
{
  uint a = AIRLIGHT_NODE_WORDS * boundaryNode;
  uint b = AIRLIGHT_NODE_WORDS * nodes[a + 2u];
  from = uintBitsToFloat(nodes[a]);
  airlightRunStart = uintBitsToFloat(nodes[b]);
  shadows.blocks = ivec3(int(nodes[a + 1u]), int(nodes[a + 3u]), int(nodes[a + 4u]));
  shadows.thickness = ivec3(int(nodes[b + 1u]), int(nodes[b + 3u]), int(nodes[b + 4u]));
  boundaryNode = nodes[b + 2u];
}

#else

void airlightLeave(float from, int shadows)
{
  nodes[AIRLIGHT_NODE_WORDS * boundaryLast] = floatBitsToUint(from);
  nodes[AIRLIGHT_NODE_WORDS * boundaryLast + 1u] = uint(shadows);
}

void airlightTakeUp(out float from, out int shadows)
{
  uint word = AIRLIGHT_NODE_WORDS * boundaryNode;
  from = uintBitsToFloat(nodes[word]);
  shadows = int(nodes[word + 1u]);
  boundaryNode = nodes[word + 2u];
}

#endif

// False where nothing is left to do. Otherwise where to go on: a pause leaves its distance and its
// count of shadows in the last boundary read, which becomes the head.
bool airlightOpenBoundaries(
  ivec2 pixel, AirlightRay ray, float surface, inout float from, inout AirlightCounts shadows)
{
  boundaryNode = listHeads[airlightHeadIndex(pixel)];
  boundaryLast = 0u;
  boundariesLeft = AIRLIGHT_CHUNK;
  if (boundaryNode != 0u && resume != 0)
  {
    airlightTakeUp(from, shadows);
    return true;
  }
  return boundaryNode != 0u;
}

int airlightNextBoundary(out float t, out AirlightCounts weight)
{
  t = airlightNodeDistance(boundaryNode);
  weight = airlightWeight(boundaryNode);
  bool last = boundaryNode == 0u || !(t < boundaryEnd);
  t *= boundaryUnit;
  if (last || boundariesLeft == 0)
  {
    return last ? AIRLIGHT_END : AIRLIGHT_PAUSE;
  }
  boundariesLeft--;
#if AIRLIGHT_SHADOW_TRANSMITTANCE
  boundaryPrevious = boundaryLast;
#endif
  boundaryLast = boundaryNode;
  boundaryNode = nodes[AIRLIGHT_NODE_WORDS * boundaryNode + 2u];
  return AIRLIGHT_MORE;
}

void airlightCloseBoundaries(ivec2 pixel, int state, float from, AirlightCounts shadows)
{
#if AIRLIGHT_SHADOW_TRANSMITTANCE
  uint paused = boundaryPrevious;
#else
  uint paused = boundaryLast;
#endif
  listHeads[airlightHeadIndex(pixel)] = state == AIRLIGHT_PAUSE ? paused : 0u;
  if (state == AIRLIGHT_PAUSE)
  {
    airlightLeave(from, shadows);
  }
}

#elif AIRLIGHT_K_BUFFER_SIZE > 0

bool airlightOpenBoundaries(
  ivec2 pixel, AirlightRay ray, float surface, inout float from, inout AirlightCounts shadows)
{
  return airlightOpenPacked(pixel, boundaryEnd);
}

int airlightNextBoundary(out float t, out AirlightCounts weight)
{
  uint boundary = airlightNextPacked();
  t = boundaryUnit * airlightPackedDistance(boundary);
  weight = airlightPackedWeight(boundary);
  return packedLeft >= 0 ? AIRLIGHT_MORE : AIRLIGHT_END;
}

void airlightCloseBoundaries(ivec2 pixel, int state, float from, AirlightCounts shadows) {}

#else

float listT[AIRLIGHT_SHORT_LIST];
int listWeight[AIRLIGHT_SHORT_LIST];
#if AIRLIGHT_SHADOW_TRANSMITTANCE
uint listNode[AIRLIGHT_SHORT_LIST];
#endif
int listSize;
int listNext;

// False where the list is too long for the local array.
bool airlightOpenBoundaries(
  ivec2 pixel, AirlightRay ray, float surface, inout float from, inout AirlightCounts shadows)
{
  listSize = 0;
  listNext = 0;
  uint node = listHeads[airlightHeadIndex(pixel)];
  int length = 0;
  for (uint guard = 0u; node != 0u && guard < uint(nodes.length()); guard++)
  {
    float t = airlightNodeDistance(node);
    if (listSize < AIRLIGHT_SHORT_LIST && t < boundaryEnd)
    {
      int weight = int(nodes[AIRLIGHT_NODE_WORDS * node + 1u]);
      int k = listSize;
      // By distance; at one distance entries before exits, so that volumes that touch stay joined.
      for (; k > 0 && (t < listT[k - 1] || (t == listT[k - 1] && weight > listWeight[k - 1])); k--)
      {
        listT[k] = listT[k - 1];
        listWeight[k] = listWeight[k - 1];
#if AIRLIGHT_SHADOW_TRANSMITTANCE
        listNode[k] = listNode[k - 1];
#endif
      }
      listT[k] = t;
      listWeight[k] = weight;
#if AIRLIGHT_SHADOW_TRANSMITTANCE
      listNode[k] = node;
#endif
      listSize++;
    }
    length++;
    node = nodes[AIRLIGHT_NODE_WORDS * node + 2u];
  }
  if (length > AIRLIGHT_SHORT_LIST)
  {
    atomicMax(listHeads[1], uint(length));
  }
  return length <= AIRLIGHT_SHORT_LIST;
}

int airlightNextBoundary(out float t, out AirlightCounts weight)
{
  int k = min(listNext, AIRLIGHT_SHORT_LIST - 1);
  t = boundaryUnit * listT[k];
#if AIRLIGHT_SHADOW_TRANSMITTANCE
  weight = airlightWeight(listNode[k]);
#else
  weight = listWeight[k];
#endif
  listNext++;
  return listNext <= listSize ? AIRLIGHT_MORE : AIRLIGHT_END;
}

// What is done here is not the later draws'.
void airlightCloseBoundaries(ivec2 pixel, int state, float from, AirlightCounts shadows)
{
  listHeads[airlightHeadIndex(pixel)] = 0u;
}

#endif
