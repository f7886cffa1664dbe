// What the medium before a fragment scatters to the eye, from the fragment's record.

// In the first draw: a record for this fragment.
void airlightCollect()
{
  ivec2 pixel = ivec2(airlightPixel());
  float t = airlightFragmentDistance();
#if AIRLIGHT_SHADOW_TRANSMITTANCE
  // A surface does not shadow its own lit side: light is taken before it, by more than the rounding
  // of its distance, which grows with its slope.
  float before = 1e-5 * t + fwidth(t) / 128.0;
#else
  const float before = 0.0;
#endif
  uint fragment = airlightAddTranslucent(1u);
  if (fragment < uint(airlightTranslucentCapacity))
  {
    uint next = airlightPrependTranslucent(pixel, fragment);
    airlightMakeTranslucent(fragment, next, t, t - before);
  }
}

// In the last draw: the nearest record, since another shader may round its distance otherwise.
void airlightFindTranslucent()
{
  float t = airlightFragmentDistance();
  uvec2 sorted = airlightSortedTranslucent(ivec2(airlightPixel()));
  if (sorted.y == 0u)
  {
    return;
  }
  uint place = min(airlightFindSorted(sorted, t), sorted.x + sorted.y - 1u);
  uint other = max(place, sorted.x + 1u) - 1u;
  bool isOther = abs(airlightSortedDistance(other) - t) < abs(airlightSortedDistance(place) - t);
  airlightTranslucent = airlightSortedRecord(isOther ? other : place);
}

// Scattered into the ray before the fragment.
vec3 airlightInscatterToFragment(vec3 origin, vec3 direction, float t)
{
  return airlightDiffuseRest(origin, direction, t) +
    airlightTranslucentRadiance(airlightTranslucent);
}
