// Adds to the records of what is drawn over the medium: on the run [runStart, runEnd] of the ray so much
// of the light passes; undimmed, `sum` is scattered into [from, to] of it, which lies inside the media.

uniform int layerBit; // of the light, -1 without surface shadows

void addToLayers(AirlightMedia media, AirlightLight light, ivec2 pixel, AirlightRay ray, AirlightPassing passing, float runStart, float runEnd, float from,
  vec3 fromTail, float to, vec3 sum)
{
  bool isLit = airlightPasses(passing);
  uint layer = layerHeads[airlightLayerHead(pixel)];
  for (int guard = 0; layer != 0u && guard < airlightLayerCapacity; guard++)
  {
    float t = airlightLayerDistance(layer);
    uint word = AIRLIGHT_LAYER_WORDS * layer;
    if (isLit && t > from && to > from)
    {
      vec3 part = sum;
      if (t < to)
      {
        part = airlightInterval3(
          media, light, ray, from, fromTail, t, airlightTail3(media, light, ray, t));
      }
      part = airlightDim(part, passing);
      layers[word + 2u] = floatBitsToUint(uintBitsToFloat(layers[word + 2u]) + part.r);
      layers[word + 3u] = floatBitsToUint(uintBitsToFloat(layers[word + 3u]) + part.g);
      layers[word + 4u] = floatBitsToUint(uintBitsToFloat(layers[word + 4u]) + part.b);
    }
#if AIRLIGHT_DIMMED
    t = uintBitsToFloat(layers[word + 8u]);
    if (dimmingSlot >= 0 && t > runStart && t <= runEnd)
    {
      uvec2 kept = airlightPack(passing);
      layers[word + 9u + 2u * uint(dimmingSlot)] = kept.x;
      layers[word + 10u + 2u * uint(dimmingSlot)] = kept.y;
    }
#endif
    if (isLit && layerBit >= 0 && t > runStart && t <= runEnd)
    {
      layers[word + 5u + uint(layerBit / 32)] |= 1u << uint(layerBit % 32);
    }
    layer = layers[word];
  }
}
