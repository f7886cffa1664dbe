// Adds to the records of what is drawn over the medium: on the run [runStart, runEnd] of the ray so much
// of the light passes; undimmed, `sum` is scattered into [from, to] of it, which lies inside the media.

uniform int layerBit; // of the light, -1 without surface shadows

void addToLayer(uint layer, vec3 part)
{
  uint word = AIRLIGHT_LAYER_WORDS * layer;
  layers[word + 2u] = floatBitsToUint(uintBitsToFloat(layers[word + 2u]) + part.r);
  layers[word + 3u] = floatBitsToUint(uintBitsToFloat(layers[word + 3u]) + part.g);
  layers[word + 4u] = floatBitsToUint(uintBitsToFloat(layers[word + 4u]) + part.b);
}

void addToLayers(AirlightMedia media, AirlightLight light, ivec2 pixel, AirlightRay ray,
  AirlightPassing passing, float runStart, float runEnd, float from,
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
      addToLayer(layer, airlightDim(part, passing));
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

#ifdef AIRLIGHT_RAY_MARCH
// The same of a march, step by step: the step [from, to] scatters `part`, those before it `sum`.
void addStepToLayers(ivec2 pixel, float from, float to, vec3 sum, vec3 part)
{
  uint layer = layerHeads[airlightLayerHead(pixel)];
  for (int guard = 0; layer != 0u && guard < airlightLayerCapacity; guard++)
  {
    float t = airlightLayerDistance(layer);
    if (t > from && t <= to)
    {
      addToLayer(layer, sum + (t - from) / (to - from) * part);
    }
    layer = layers[AIRLIGHT_LAYER_WORDS * layer];
  }
}

// After the last step, which ends at `end`.
void finishLayers(ivec2 pixel, AirlightRay ray, float end, vec3 sum)
{
  uint layer = layerHeads[airlightLayerHead(pixel)];
  for (int guard = 0; layer != 0u && guard < airlightLayerCapacity; guard++)
  {
    float t = airlightLayerDistance(layer);
    uint word = AIRLIGHT_LAYER_WORDS * layer;
    if (t > end)
    {
      addToLayer(layer, sum);
    }
    if (layerBit >= 0 && airlightIsSurfaceLit(ray.origin + t * ray.direction))
    {
      layers[word + 5u + uint(layerBit / 32)] |= 1u << uint(layerBit % 32);
    }
    layer = layers[word];
  }
}
#endif
