// The boundaries in a pixel's slots, counted.

int airlightBoundaryCount;
int airlightBoundaryWeights;
int boundariesLeft;

// What a slot holds; AIRLIGHT_NO_BOUNDARY if that lies beyond the end.
uint airlightReadKBuffer(uint slot)
{
  uint boundary = kBuffer[slot];
  bool before = airlightPackedDistance(boundary) < boundaryEnd;
  airlightBoundaryWeights += before ? airlightPackedWeight(boundary) : 0;
  airlightBoundaryCount += before ? 1 : 0;
  return before ? boundary : AIRLIGHT_NO_BOUNDARY;
}

// False where there are more boundaries than slots.
bool airlightOpenBoundaries(ivec2 pixel, float unit, float surface)
{
  airlightEndBoundaries(unit, surface);
  airlightClearSorted();
  airlightBoundaryWeights = 0;
  airlightBoundaryCount = 0;
  int all = int(listHeads[airlightCountIndex(pixel)]);
  // Without min(count, 16): compilers unroll loops whose greatest length they see, and software
  // renderers run through all of an unrolled one for every pixel.
  int count = all * int(all <= AIRLIGHT_K_BUFFER_SIZE);
  uint first = airlightKBufferStart(pixel);
#if AIRLIGHT_K_BUFFER_SIZE > 16
  int near = min(count, 16);
#else
  int near = count;
#endif
  for (int i = 0; i < near; i++)
  {
    airlightInsertNear(airlightReadKBuffer(airlightKBufferIndex(first, uint(i))));
  }
#if AIRLIGHT_K_BUFFER_SIZE > 16
  for (int i = near; i < count; i++)
  {
    uint boundary = airlightReadKBuffer(airlightKBufferIndex(first, uint(i)));
    airlightInsertFar(airlightInsertNear(boundary));
  }
#endif
  boundariesLeft = airlightBoundaryCount;
  return all <= AIRLIGHT_K_BUFFER_SIZE;
}

void airlightBeginBoundaries(AirlightRay ray, inout float from, inout int shadows) {}

int airlightNextBoundary(out float t, out int weight)
{
  uint boundary = airlightTakeNearest();
  t = boundaryUnit * airlightPackedDistance(boundary);
  weight = airlightPackedWeight(boundary);
  boundariesLeft--;
  return boundariesLeft >= 0 ? AIRLIGHT_MORE : AIRLIGHT_END;
}

void airlightCloseBoundaries(ivec2 pixel, int state, float from, int shadows) {}
