// What the readers of stored boundaries have in common (AirlightBoundaryReader.glsl). A first draw
// takes the pixels whose boundaries all have slots (AirlightKBufferReader.glsl), or where there are
// no slots, those with short lists (AirlightShortListReader.glsl). AirlightSortFS.glsl sorts the
// other lists in place, and further draws read them as they are: some boundaries a draw
// (AirlightSortedListReader.glsl), because some software renderers bound the iterations of one
// shader run, or counted and all at once (AirlightCountedListReader.glsl).

float boundaryUnit; // of their distances
float boundaryEnd;  // where those that count end, on that unit

void airlightEndBoundaries(float unit, float surface)
{
  boundaryUnit = unit;
  boundaryEnd = surface >= 0.0 ? surface : 1e37;
}

AirlightCounts airlightNodeWeight(uint node)
{
#if AIRLIGHT_K_BUFFER_SIZE > 0
  return airlightPackedWeight(nodes[AIRLIGHT_NODE_WORDS * node]);
#else
  int weight = int(nodes[AIRLIGHT_NODE_WORDS * node + AIRLIGHT_NODE_WEIGHT]);
#if AIRLIGHT_SHADOW_TRANSMITTANCE
  uint word = AIRLIGHT_NODE_WORDS * node + AIRLIGHT_NODE_THICKNESS;
  return AirlightCounts((weight >> 3) * ivec3(weight & 1, (weight >> 1) & 1, (weight >> 2) & 1),
    ivec3(int(nodes[word]), int(nodes[word + 1u]), int(nodes[word + 2u])));
#else
  return weight;
#endif
#endif
}
