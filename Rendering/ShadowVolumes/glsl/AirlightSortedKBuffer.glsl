// Boundaries in order of distance, as many as a pixel has slots, in the form that slots have
// (AirlightKBuffer.glsl).

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

// Boundaries that do not decrease, and another one: `boundary` becomes what is left over.
void airlightInsertBoundary(inout uvec4 boundaries, inout uint boundary)
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
  airlightInsertBoundary(sortedA, boundary);
  airlightInsertBoundary(sortedB, boundary);
  airlightInsertBoundary(sortedC, boundary);
  airlightInsertBoundary(sortedD, boundary);
  return boundary;
}

// Puts it among the others.
void airlightInsertFar(uint boundary)
{
#if AIRLIGHT_K_BUFFER_SIZE > 16
  airlightInsertBoundary(sortedE, boundary);
  airlightInsertBoundary(sortedF, boundary);
  airlightInsertBoundary(sortedG, boundary);
  airlightInsertBoundary(sortedH, boundary);
#endif
}

// The nearest one; AIRLIGHT_NO_BOUNDARY where none is left.
uint airlightTakeNearest()
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
  return boundary;
}
