// What is drawn over the medium: a list of records for each pixel, one for each translucent fragment.
// The fragments make them in a first draw; each light's resolve adds what it scatters into the ray
// before the fragment, and whether it reaches it; the fragments look for theirs in the last draw.

#if AIRLIGHT_DIMMED
uniform int airlightLayerWords; // 8 where no caster lets light through
#define AIRLIGHT_LAYER_WORDS uint(airlightLayerWords)
#else
const uint AIRLIGHT_LAYER_WORDS = 8u;
#endif

// Eight words a record: index of the next, 0 at the end; t; radiance; bits of the lights that reach
// it, 32 a word. With AIRLIGHT_DIMMED nine and two for each light that is dimmed: the distance just
// before the fragment at which it is lit, and what passes.
layout(std430, binding = AIRLIGHT_BINDING_TRANSLUCENT_FRAGMENTS) buffer AirlightLayers
{
  uint layers[];
};
layout(std430, binding = AIRLIGHT_BINDING_TRANSLUCENT_HEADS) buffer AirlightLayerHeads
{
  uint layerHeads[]; // counter of records, one head a pixel
};
uniform int airlightLayerWidth; // of the viewport, pixels
uniform int airlightLayerCapacity;

// The first of so many new records. They are counted up to a number far beyond what any buffer holds, but
// for those that are on their way: a counter that wraps would give lists cycles.
uint airlightNewLayers(uint count)
{
  const uint most = 0x80000000u;
  uint first = atomicAdd(layerHeads[0], count) + 1u;
  if (first > most)
  {
    atomicExchange(layerHeads[0], most);
  }
  return first;
}

uint airlightLayerHead(ivec2 pixel)
{
  return uint(1 + pixel.y * airlightLayerWidth + pixel.x);
}

float airlightLayerDistance(uint layer)
{
  return uintBitsToFloat(layers[AIRLIGHT_LAYER_WORDS * layer + 1u]);
}
