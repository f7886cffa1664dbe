// Puts the records of each pixel's list into an array, in the order of their distances (D. L.
// Shell, "A high-speed sorting procedure", 1959: few lines, and no list is too long for it).

void airlightSetSorted(uint place, uint distance, uint record)
{
  translucentFragments[airlightSortedWord(place)] = distance;
  translucentFragments[airlightSortedWord(place) + 1u] = record;
}

// Whether they are in order already, as the nodes of a volume and sheets drawn from afar to near.
bool airlightCopyList(uint head, uint place)
{
  float last = 0.0;
  bool ordered = true;
  for (uint record = head; record != 0u; place++)
  {
    float t = airlightTranslucentDistance(record);
    t = t >= 0.0 ? t : 0.0; // no NaN
    airlightSetSorted(place, floatBitsToUint(t), record);
    ordered = ordered && t >= last;
    last = t;
    record = airlightNextTranslucent(record);
  }
  return ordered;
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
  if (!airlightCopyList(translucentHeads[head], first))
  {
    airlightSortArray(first, count);
  }
  translucentHeads[head] = first;
#if AIRLIGHT_SHADOW_TRANSMITTANCE
  // A record is lit at a distance just before its own. These get the same order, for one cursor: a
  // record before one that needs a wide margin gets a wider one, too.
  float before = airlightTranslucentLitDistance(airlightSortedRecord(first + count - 1u));
  for (uint i = count; i > 0u; i--)
  {
    uint record = airlightSortedRecord(first + i - 1u);
    before = min(before, airlightTranslucentLitDistance(record));
    airlightSetTranslucentLitDistance(record, before);
  }
#endif
}
