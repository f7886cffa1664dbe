// Puts the records of each pixel's list into an array, in the order of their distances (D. L.
// Shell, "A high-speed sorting procedure", 1959: few lines, and no list is too long for it).

void airlightSetSorted(uint place, uint distance, uint record)
{
  translucentFragments[airlightSortedWord(place)] = distance;
  translucentFragments[airlightSortedWord(place) + 1u] = record;
}

void airlightCopyList(uint head, uint place)
{
  for (uint record = head; record != 0u; place++)
  {
    float t = airlightTranslucentDistance(record);
    airlightSetSorted(place, floatBitsToUint(t >= 0.0 ? t : 0.0), record); // no NaN
    record = airlightNextTranslucent(record);
  }
}

void airlightSortArray(uint first, uint count)
{
  // Three times and one more, backwards.
  uint gap = 1u;
  while (3u * gap + 1u < count)
  {
    gap = 3u * gap + 1u;
  }
  for (; gap > 0u; gap /= 3u)
  {
    for (uint i = gap; i < count; i++)
    {
      float t = airlightSortedDistance(first + i);
      uint record = airlightSortedRecord(first + i);
      uint k = i;
      while (k >= gap && airlightSortedDistance(first + k - gap) > t)
      {
        airlightSetSorted(first + k, floatBitsToUint(airlightSortedDistance(first + k - gap)),
          airlightSortedRecord(first + k - gap));
        k -= gap;
      }
      airlightSetSorted(first + k, floatBitsToUint(t), record);
    }
  }
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  uint head = airlightTranslucentHead(pixel);
  uint pixels = uint(airlightTranslucentWidth * airlightTranslucentHeight);
  uint count = 0u;
  for (uint record = translucentHeads[head]; record != 0u; count++)
  {
    record = airlightNextTranslucent(record);
  }
  translucentHeads[head + pixels] = count;
  if (count == 0u)
  {
    return;
  }
  uint first = atomicAdd(translucentHeads[1u + 2u * pixels], count);
  airlightCopyList(translucentHeads[head], first);
  translucentHeads[head] = first;
  airlightSortArray(first, count);
#if AIRLIGHT_SHADOW_TRANSMITTANCE
  // A record is lit at a distance just before its own. These get the same order, for one cursor.
  float before = 0.0;
  for (uint i = 0u; i < count; i++)
  {
    uint record = airlightSortedRecord(first + i);
    before = max(before, airlightTranslucentLitDistance(record));
    airlightSetTranslucentLitDistance(record, before);
  }
#endif
}
