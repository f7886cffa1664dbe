// What is drawn over the medium: a list of records for each pixel, one for each translucent
// fragment. The fragments make them in a first draw; each light's resolve adds what it scatters
// into the ray before the fragment, and whether it reaches it; the fragments look for theirs in the
// last draw.

#if AIRLIGHT_SHADOW_TRANSMITTANCE
uniform int airlightTranslucentWords; // 8 where no caster lets light through
#define AIRLIGHT_TRANSLUCENT_WORDS uint(airlightTranslucentWords)
#else
const uint AIRLIGHT_TRANSLUCENT_WORDS = 8u;
#endif

// Eight words a record: index of the next, 0 at the end; t; radiance; bits of the lights that reach
// it, 32 a word. With AIRLIGHT_SHADOW_TRANSMITTANCE nine and two for each light that is dimmed: the
// distance just before the fragment at which it is lit, and what passes.
layout(std430, binding = AIRLIGHT_BINDING_TRANSLUCENT_FRAGMENTS) buffer AirlightTranslucentLists
{
  uint translucentFragments[];
};
layout(std430, binding = AIRLIGHT_BINDING_TRANSLUCENT_HEADS) buffer AirlightTranslucentHeads
{
  uint translucentHeads[]; // counter of records, one head a pixel
};
uniform int airlightTranslucentWidth; // of the viewport, pixels
uniform int airlightTranslucentCapacity;

// The first of so many new records. They are counted up to a number far beyond what any buffer
// holds, but for those that are on their way: a counter that wraps would give lists cycles.
uint airlightAddTranslucent(uint count)
{
  const uint most = 0x80000000u;
  uint first = atomicAdd(translucentHeads[0], count) + 1u;
  if (first > most)
  {
    atomicExchange(translucentHeads[0], most);
  }
  return first;
}

uint airlightTranslucentHead(ivec2 pixel)
{
  return uint(1 + pixel.y * airlightTranslucentWidth + pixel.x);
}

float airlightTranslucentDistance(uint fragment)
{
  return uintBitsToFloat(translucentFragments[AIRLIGHT_TRANSLUCENT_WORDS * fragment + 1u]);
}
