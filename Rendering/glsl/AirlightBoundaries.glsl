// The boundaries of a pixel in order of distance. Short lists are sorted here, in a local array.
// Longer ones are left out in a first draw, which notes that they are there; AirlightSortFS.glsl
// sorts them in place, and further draws with AIRLIGHT_SORTED read them as they are, some boundaries
// a draw, because some software renderers bound the iterations of one shader run.

layout(std430, binding = 1) buffer AirlightNodes
{
  uint nodes[];
};
layout(std430, binding = 2) buffer AirlightHeads
{
  uint heads[]; // counter of boundaries, length of the longest list, one head a pixel
};

uniform int width;
uniform uint capacity;

const int AIRLIGHT_MORE = 0;  // a boundary
const int AIRLIGHT_PAUSE = 1; // the rest is the next draw's
const int AIRLIGHT_END = 2;   // none is left

uint airlightHeadIndex(ivec2 pixel)
{
  return uint(2 + pixel.y * width + pixel.x);
}

#ifdef AIRLIGHT_SORTED

uniform int resume; // 0: the first draw of the sorted lists

uint boundaryNode;
uint boundaryLast;
int boundariesLeft;

// False where nothing is left to do. Otherwise where to go on: a pause leaves its distance and its
// count of shadows in the last boundary read, which becomes the head.
bool airlightOpenBoundaries(
  ivec2 pixel, AirlightRay ray, float surface, inout float from, inout int shadows)
{
  boundaryNode = heads[airlightHeadIndex(pixel)];
  boundaryLast = 0u;
  boundariesLeft = AIRLIGHT_CHUNK;
  if (boundaryNode != 0u && resume != 0)
  {
    from = uintBitsToFloat(nodes[3u * boundaryNode]);
    shadows = int(nodes[3u * boundaryNode + 1u]);
    boundaryNode = nodes[3u * boundaryNode + 2u];
    return true;
  }
  return boundaryNode != 0u;
}

int airlightNextBoundary(out float t, out int weight)
{
  t = uintBitsToFloat(nodes[3u * boundaryNode]);
  weight = int(nodes[3u * boundaryNode + 1u]);
  if (boundaryNode == 0u || boundariesLeft == 0)
  {
    return boundaryNode == 0u ? AIRLIGHT_END : AIRLIGHT_PAUSE;
  }
  boundariesLeft--;
  boundaryLast = boundaryNode;
  boundaryNode = nodes[3u * boundaryNode + 2u];
  return AIRLIGHT_MORE;
}

void airlightCloseBoundaries(ivec2 pixel, int state, float from, int shadows)
{
  heads[airlightHeadIndex(pixel)] = state == AIRLIGHT_PAUSE ? boundaryLast : 0u;
  if (state == AIRLIGHT_PAUSE)
  {
    nodes[3u * boundaryLast] = floatBitsToUint(from);
    nodes[3u * boundaryLast + 1u] = uint(shadows);
  }
}

#else

float listT[AIRLIGHT_SHORT_LIST];
int listWeight[AIRLIGHT_SHORT_LIST];
int listSize;
int listNext;

// False where the list is too long for the local array.
bool airlightOpenBoundaries(
  ivec2 pixel, AirlightRay ray, float surface, inout float from, inout int shadows)
{
  listSize = 0;
  listNext = 0;
  uint node = heads[airlightHeadIndex(pixel)];
  int length = 0;
  for (uint guard = 0u; node != 0u && guard < capacity; guard++)
  {
    if (listSize < AIRLIGHT_SHORT_LIST)
    {
      float t = uintBitsToFloat(nodes[3u * node]);
      int weight = int(nodes[3u * node + 1u]);
      int k = listSize;
      // By distance; at one distance entries before exits, so that volumes that touch stay joined.
      for (; k > 0 && (t < listT[k - 1] || (t == listT[k - 1] && weight > listWeight[k - 1])); k--)
      {
        listT[k] = listT[k - 1];
        listWeight[k] = listWeight[k - 1];
      }
      listT[k] = t;
      listWeight[k] = weight;
      listSize++;
    }
    length++;
    node = nodes[3u * node + 2u];
  }
  if (length > AIRLIGHT_SHORT_LIST)
  {
    atomicMax(heads[1], uint(length));
  }
  return length <= AIRLIGHT_SHORT_LIST;
}

int airlightNextBoundary(out float t, out int weight)
{
  int k = min(listNext, AIRLIGHT_SHORT_LIST - 1);
  t = listT[k];
  weight = listWeight[k];
  listNext++;
  return listNext <= listSize ? AIRLIGHT_MORE : AIRLIGHT_END;
}

// What is done here is not the later draws'.
void airlightCloseBoundaries(ivec2 pixel, int state, float from, int shadows)
{
  heads[airlightHeadIndex(pixel)] = 0u;
}

#endif
