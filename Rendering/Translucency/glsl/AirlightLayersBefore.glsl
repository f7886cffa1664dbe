// What the medium before a fragment scatters to the eye, from the fragment's record.

// In the first draw: a record for this fragment.
void airlightCollect()
{
  ivec2 pixel = ivec2(airlightPixel());
  float t = airlightFragmentDistance();
#if AIRLIGHT_DIMMED
  // A surface does not shadow its own lit side: light is taken before it, by more than the rounding
  // of its distance, which grows with its slope.
  float before = 1e-5 * t + fwidth(t) / 128.0;
#endif
  uint layer = airlightNewLayers(1u);
  if (layer < uint(airlightLayerCapacity))
  {
    uint word = AIRLIGHT_LAYER_WORDS * layer;
    layers[word] = atomicExchange(layerHeads[airlightLayerHead(pixel)], layer);
    layers[word + 1u] = floatBitsToUint(t);
    for (uint i = 2u; i < AIRLIGHT_LAYER_WORDS; i++)
    {
      layers[word + i] = 0u;
    }
#if AIRLIGHT_DIMMED
    if (AIRLIGHT_LAYER_WORDS > 8u)
    {
      layers[word + 8u] = floatBitsToUint(t - before);
    }
#endif
  }
}

// In the last draw: the nearest record, since another shader may round its distance otherwise.
void airlightFindLayer()
{
  float t = airlightFragmentDistance();
  float nearest = AIRLIGHT_FAR;
  uint layer = layerHeads[airlightLayerHead(ivec2(airlightPixel()))];
  for (int guard = 0; layer != 0u && guard < airlightLayerCapacity; guard++)
  {
    float apart = abs(airlightLayerDistance(layer) - t);
    airlightLayer = apart < nearest ? layer : airlightLayer;
    nearest = min(apart, nearest);
    layer = layers[AIRLIGHT_LAYER_WORDS * layer];
  }
}

// Scattered into the ray before the fragment.
vec3 airlightBefore(vec3 origin, vec3 direction, float t)
{
  uint word = AIRLIGHT_LAYER_WORDS * airlightLayer;
  return airlightAmbient(airlightMedia, origin, direction, t) +
    vec3(uintBitsToFloat(layers[word + 2u]), uintBitsToFloat(layers[word + 3u]),
      uintBitsToFloat(layers[word + 4u]));
}
