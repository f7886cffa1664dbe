// Added to the mappers' fragment shaders where fragments are drawn over the medium behind them: what
// the medium before each fragment makes of its colour, before it is blended.

#if AIRLIGHT_LAYER_RECORDS

// In the first draw: a record for this fragment.
void airlightCollect()
{
  ivec2 pixel = ivec2(airlightPixel());
  uint layer = atomicAdd(layerHeads[0], 1u) + 1u;
  if (layer < uint(airlightLayerCapacity))
  {
    uint word = AIRLIGHT_LAYER_WORDS * layer;
    layers[word] = atomicExchange(layerHeads[airlightLayerHead(pixel)], layer);
    layers[word + 1u] = floatBitsToUint(airlightFragmentDistance());
    for (uint i = 2u; i < AIRLIGHT_LAYER_WORDS; i++)
    {
      layers[word + i] = 0u;
    }
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

// Scattered into the ray before this fragment.
vec3 airlightLightsBefore(vec3 origin, vec3 direction, float t)
{
  uint word = AIRLIGHT_LAYER_WORDS * airlightLayer;
  return vec3(uintBitsToFloat(layers[word + 2u]), uintBitsToFloat(layers[word + 3u]),
    uintBitsToFloat(layers[word + 4u]));
}

#else

uniform AirlightLight airlightLights[AIRLIGHT_LAMPS];

// The same without records, and without shadows.
vec3 airlightLightsBefore(vec3 origin, vec3 direction, float t)
{
  vec3 sum = vec3(0.0);
  for (int k = 0; k < airlightLampCount; k++)
  {
    if (airlightLamps[k].w >= 0.0)
    {
      AirlightRay ray = airlightRay(airlightMedia, airlightLights[k], origin, direction, t);
      if (ray.lit.y > ray.lit.x)
      {
        vec3 tail = airlightTail3(airlightMedia, airlightLights[k], ray, ray.lit.x);
        sum += airlightInterval3(airlightMedia, airlightLights[k], ray, ray.lit.x, tail, ray.lit.y,
          airlightTail3(airlightMedia, airlightLights[k], ray, ray.lit.y));
      }
    }
  }
  return sum;
}

#endif

uniform int airlightEncodedInput; // 1: colours are encoded for display

vec3 airlightThrough(vec3 colour)
{
  if (airlightStage != AIRLIGHT_STAGE_LAYER)
  {
    return colour;
  }
  vec2 p = airlightPixel();
  vec3 origin = airlightOrigin(p);
  vec3 direction = normalize(airlightDirection(p));
  float t = airlightFragmentDistance();
  colour = airlightEncodedInput != 0 ? airlightDecode(colour) : colour;
  return colour * exp(-airlightDepth(airlightMedia, origin, direction, t)) +
    airlightAmbient(airlightMedia, origin, direction, t) +
    airlightLightsBefore(origin, direction, t);
}
