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
#endif
  uint fragment = airlightAddTranslucent(1u);
  if (fragment < uint(airlightTranslucentCapacity))
  {
    uint word = AIRLIGHT_TRANSLUCENT_WORDS * fragment;
    translucentFragments[word] =
      atomicExchange(translucentHeads[airlightTranslucentHead(pixel)], fragment);
    translucentFragments[word + 1u] = floatBitsToUint(t);
    for (uint i = 2u; i < AIRLIGHT_TRANSLUCENT_WORDS; i++)
    {
      translucentFragments[word + i] = 0u;
    }
#if AIRLIGHT_SHADOW_TRANSMITTANCE
    if (AIRLIGHT_TRANSLUCENT_WORDS > 8u)
    {
      translucentFragments[word + 8u] = floatBitsToUint(t - before);
    }
#endif
  }
}

// In the last draw: the nearest record, since another shader may round its distance otherwise.
void airlightFindTranslucent()
{
  float t = airlightFragmentDistance();
  float nearest = AIRLIGHT_FAR;
  uint fragment = translucentHeads[airlightTranslucentHead(ivec2(airlightPixel()))];
  for (int guard = 0; fragment != 0u && guard < airlightTranslucentCapacity; guard++)
  {
    float apart = abs(airlightTranslucentDistance(fragment) - t);
    airlightTranslucent = apart < nearest ? fragment : airlightTranslucent;
    nearest = min(apart, nearest);
    fragment = translucentFragments[AIRLIGHT_TRANSLUCENT_WORDS * fragment];
  }
}

// Scattered into the ray before the fragment.
vec3 airlightInscatterToFragment(vec3 origin, vec3 direction, float t)
{
  uint word = AIRLIGHT_TRANSLUCENT_WORDS * airlightTranslucent;
  return airlightAmbient(airlightMedia, origin, direction, t) +
    vec3(uintBitsToFloat(translucentFragments[word + 2u]),
      uintBitsToFloat(translucentFragments[word + 3u]),
      uintBitsToFloat(translucentFragments[word + 4u]));
}
