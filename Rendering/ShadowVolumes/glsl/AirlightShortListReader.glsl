// The boundaries of a pixel whose list is short, sorted here in a local array.

float listT[AIRLIGHT_SHORT_LIST];
int listWeight[AIRLIGHT_SHORT_LIST];
#if AIRLIGHT_SHADOW_TRANSMITTANCE
uint listNode[AIRLIGHT_SHORT_LIST];
#endif
int listSize;
int listNext;

// False where the list is too long for the local array.
bool airlightOpenBoundaries(ivec2 pixel, float unit, float surface)
{
  airlightEndBoundaries(unit, surface);
  listSize = 0;
  listNext = 0;
  uint node = listHeads[airlightHeadIndex(pixel)];
  int length = 0;
  for (uint guard = 0u; node != 0u && guard < uint(nodes.length()); guard++)
  {
    float t = airlightNodeDistance(node);
    if (listSize < AIRLIGHT_SHORT_LIST && t < boundaryEnd)
    {
      int weight = int(nodes[AIRLIGHT_NODE_WORDS * node + AIRLIGHT_NODE_WEIGHT]);
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
    node = airlightNextNode(node);
  }
  if (length > AIRLIGHT_SHORT_LIST)
  {
    atomicMax(listHeads[1], uint(length));
  }
  return length <= AIRLIGHT_SHORT_LIST;
}

void airlightBeginBoundaries(AirlightRay ray, inout float from, inout AirlightCounts shadows) {}

int airlightNextBoundary(out float t, out AirlightCounts weight)
{
  int k = min(listNext, AIRLIGHT_SHORT_LIST - 1);
  t = boundaryUnit * listT[k];
#if AIRLIGHT_SHADOW_TRANSMITTANCE
  weight = airlightNodeWeight(listNode[k]);
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
