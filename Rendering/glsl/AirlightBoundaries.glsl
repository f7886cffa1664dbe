// The boundaries of a pixel in order of distance. Lists of any length: those that do not fit the
// local array are read in batches, each one the nearest boundaries behind the last batch.

layout(std430, binding = 1) readonly buffer AirlightNodes
{
  uint nodes[];
};
layout(std430, binding = 2) readonly buffer AirlightHeads
{
  uint heads[]; // one a pixel, after the counter
};

uniform int width;
uniform uint capacity;

const int AIRLIGHT_BATCH = 24;
float batchT[AIRLIGHT_BATCH];
int batchWeight[AIRLIGHT_BATCH];
uint batchNode[AIRLIGHT_BATCH];
int batchSize;
int batchNext;
bool batchLast;
uint listHead;

// By distance; at one distance entries before exits, so that volumes that touch stay joined; the
// node's index only tells equals apart.
bool airlightBefore(float t, int weight, uint node, int k)
{
  if (t != batchT[k])
  {
    return t < batchT[k];
  }
  if (weight != batchWeight[k])
  {
    return weight > batchWeight[k];
  }
  return node < batchNode[k];
}

void airlightReadBatch(float lastT, int lastWeight, uint lastNode, bool first)
{
  batchSize = 0;
  batchNext = 0;
  batchLast = true;
  uint node = listHead;
  for (uint guard = 0u; node != 0u && guard < capacity; guard++)
  {
    float t = uintBitsToFloat(nodes[3u * node]);
    int weight = int(nodes[3u * node + 1u]);
    bool behind = first || t > lastT ||
      (t == lastT && (weight < lastWeight || (weight == lastWeight && node > lastNode)));
    if (behind && batchSize == AIRLIGHT_BATCH)
    {
      batchLast = false;
      behind = airlightBefore(t, weight, node, AIRLIGHT_BATCH - 1);
    }
    if (behind)
    {
      int k = min(batchSize, AIRLIGHT_BATCH - 1);
      for (; k > 0 && airlightBefore(t, weight, node, k - 1); k--)
      {
        batchT[k] = batchT[k - 1];
        batchWeight[k] = batchWeight[k - 1];
        batchNode[k] = batchNode[k - 1];
      }
      batchT[k] = t;
      batchWeight[k] = weight;
      batchNode[k] = node;
      batchSize = min(batchSize + 1, AIRLIGHT_BATCH);
    }
    node = nodes[3u * node + 2u];
  }
}

void airlightOpenBoundaries(ivec2 pixel)
{
  listHead = heads[1 + pixel.y * width + pixel.x];
  airlightReadBatch(0.0, 0, 0u, true);
}

// The next boundary; false after the last one.
bool airlightNextBoundary(out float t, out int weight)
{
  if (batchNext == batchSize && !batchLast)
  {
    int k = batchSize - 1;
    airlightReadBatch(batchT[k], batchWeight[k], batchNode[k], false);
  }
  t = 0.0;
  weight = 0;
  if (batchNext == batchSize)
  {
    return false;
  }
  t = batchT[batchNext];
  weight = batchWeight[batchNext];
  batchNext++;
  return true;
}
