// The boundaries in a pixel's slots, in order of distance.

const uint AIRLIGHT_NO_BOUNDARY = 0xffffffffu;

// The nearest first, 16 or 32 of them: AIRLIGHT_K_BUFFER_SIZE. Not an array, which some drivers do
// not keep in registers.
uvec4 sortedA;
uvec4 sortedB;
uvec4 sortedC;
uvec4 sortedD;
#if AIRLIGHT_K_BUFFER_SIZE > 16
uvec4 sortedE;
uvec4 sortedF;
uvec4 sortedG;
uvec4 sortedH;
#endif
int packedLeft;  // of boundaries that are left
int packedWeights; // sum of all weights

// Boundaries that do not decrease, and another one: `boundary` becomes what is left over.
void airlightInsertPacked(inout uvec4 boundaries, inout uint boundary)
{
  uvec4 less;
  less.x = min(boundaries.x, boundary);
  boundary = max(boundaries.x, boundary);
  less.y = min(boundaries.y, boundary);
  boundary = max(boundaries.y, boundary);
  less.z = min(boundaries.z, boundary);
  boundary = max(boundaries.z, boundary);
  less.w = min(boundaries.w, boundary);
  boundary = max(boundaries.w, boundary);
  boundaries = less;
}

void airlightClearSorted()
{
  sortedA = uvec4(AIRLIGHT_NO_BOUNDARY);
  sortedB = sortedA;
  sortedC = sortedA;
  sortedD = sortedA;
#if AIRLIGHT_K_BUFFER_SIZE > 16
  sortedE = sortedA;
  sortedF = sortedA;
  sortedG = sortedA;
  sortedH = sortedA;
#endif
}

// Puts a boundary among the nearest 16; returns what is left over.
uint airlightInsertNear(uint boundary)
{
  airlightInsertPacked(sortedA, boundary);
  airlightInsertPacked(sortedB, boundary);
  airlightInsertPacked(sortedC, boundary);
  airlightInsertPacked(sortedD, boundary);
  return boundary;
}

// Puts it among the others.
void airlightInsertFar(uint boundary)
{
#if AIRLIGHT_K_BUFFER_SIZE > 16
  airlightInsertPacked(sortedE, boundary);
  airlightInsertPacked(sortedF, boundary);
  airlightInsertPacked(sortedG, boundary);
  airlightInsertPacked(sortedH, boundary);
#endif
}

// What a slot holds; AIRLIGHT_NO_BOUNDARY if that lies beyond `end`.
uint airlightReadKBuffer(uint slot, float end)
{
  uint boundary = kBuffer[slot];
  bool before = airlightPackedDistance(boundary) < end;
  packedWeights += before ? airlightPackedWeight(boundary) : 0;
  packedLeft += before ? 1 : 0;
  return before ? boundary : AIRLIGHT_NO_BOUNDARY;
}

// False where there are more boundaries than slots. What lies beyond `end`, on the unit of
// airlightDirection(), is left out.
bool airlightOpenPacked(ivec2 pixel, float end)
{
  airlightClearSorted();
  packedWeights = 0;
  packedLeft = 0;
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
    airlightInsertNear(airlightReadKBuffer(airlightKBufferIndex(first, uint(i)), end));
  }
#if AIRLIGHT_K_BUFFER_SIZE > 16
  for (int i = near; i < count; i++)
  {
    airlightInsertFar(
      airlightInsertNear(airlightReadKBuffer(airlightKBufferIndex(first, uint(i)), end)));
  }
#endif
  return all <= AIRLIGHT_K_BUFFER_SIZE;
}

// The nearest one; AIRLIGHT_NO_BOUNDARY where none is left.
uint airlightNextPacked()
{
  uint boundary = sortedA.x;
  sortedA = uvec4(sortedA.yzw, sortedB.x);
  sortedB = uvec4(sortedB.yzw, sortedC.x);
  sortedC = uvec4(sortedC.yzw, sortedD.x);
#if AIRLIGHT_K_BUFFER_SIZE > 16
  sortedD = uvec4(sortedD.yzw, sortedE.x);
  sortedE = uvec4(sortedE.yzw, sortedF.x);
  sortedF = uvec4(sortedF.yzw, sortedG.x);
  sortedG = uvec4(sortedG.yzw, sortedH.x);
  sortedH = uvec4(sortedH.yzw, AIRLIGHT_NO_BOUNDARY);
#else
  sortedD = uvec4(sortedD.yzw, AIRLIGHT_NO_BOUNDARY);
#endif
  packedLeft--;
  return boundary;
}
