// What is drawn over the medium: a list of records for each pixel, one for each translucent
// fragment. The fragments make them in a first draw, in linked lists.
// AirlightSortTranslucentFS.glsl then gives each pixel an array of its records in the order of
// distances. Each light's resolve adds what it scatters into the ray before the fragment, and
// whether it reaches it; the fragments look for theirs in the last draw. A record's words are those
// of AirlightTranslucentRecord.glsl.

#if AIRLIGHT_SHADOW_TRANSMITTANCE
uniform int airlightTranslucentWords; // a record's
#define AIRLIGHT_TRANSLUCENT_WORDS uint(airlightTranslucentWords)
#else
const uint AIRLIGHT_TRANSLUCENT_WORDS = AIRLIGHT_TRANSLUCENT_PLAIN_WORDS;
#endif

layout(std430, binding = AIRLIGHT_BINDING_TRANSLUCENT_FRAGMENTS) buffer AirlightTranslucentLists
{
  uint translucentFragments[]; // records; then for each of the sorted ones distance and index
};
layout(std430, binding = AIRLIGHT_BINDING_TRANSLUCENT_HEADS) buffer AirlightTranslucentHeads
{
  // Counter of records; for each pixel its list's head, later the first of its sorted records; for
  // each pixel their number; counter of sorted records; for each tile of pixels whether it has any.
  uint translucentHeads[];
};
uniform int airlightTranslucentWidth;  // of the viewport, pixels
uniform int airlightTranslucentHeight;
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

// Makes a record the first of its pixel's list. Returns the one that was.
uint airlightPrependTranslucent(ivec2 pixel, uint fragment)
{
  ivec2 tile = pixel / int(AIRLIGHT_TRANSLUCENT_TILE);
  int across = (airlightTranslucentWidth - 1) / int(AIRLIGHT_TRANSLUCENT_TILE) + 1;
  int pixels = airlightTranslucentWidth * airlightTranslucentHeight;
  translucentHeads[2 + 2 * pixels + tile.y * across + tile.x] = 1u;
  return atomicExchange(translucentHeads[airlightTranslucentHead(pixel)], fragment);
}

// The first and the number of a pixel's sorted records.
uvec2 airlightSortedTranslucent(ivec2 pixel)
{
  uint head = airlightTranslucentHead(pixel);
  uint pixels = uint(airlightTranslucentWidth * airlightTranslucentHeight);
  return uvec2(translucentHeads[head], translucentHeads[head + pixels]);
}

// Of a sorted record: its distance and, one further, its index.
uint airlightSortedWord(uint place)
{
  return AIRLIGHT_TRANSLUCENT_WORDS * uint(airlightTranslucentCapacity) + 2u * place;
}

float airlightSortedDistance(uint place)
{
  return uintBitsToFloat(translucentFragments[airlightSortedWord(place)]);
}

uint airlightSortedRecord(uint place)
{
  return translucentFragments[airlightSortedWord(place) + 1u];
}

// The place of the first of a pixel's sorted records that is not before t; one after the last where
// all are.
uint airlightFindSorted(uvec2 sorted, float t)
{
  uint low = sorted.x;
  uint high = sorted.x + sorted.y;
  while (low < high)
  {
    uint middle = (low + high) / 2u;
    bool before = airlightSortedDistance(middle) < t;
    low = before ? middle + 1u : low;
    high = before ? high : middle;
  }
  return low;
}

// The first word of a value of a record.
uint airlightTranslucentWord(uint fragment, uint value)
{
  return AIRLIGHT_TRANSLUCENT_WORDS * fragment + value;
}

uint airlightNextTranslucent(uint fragment)
{
  return translucentFragments[airlightTranslucentWord(fragment, AIRLIGHT_TRANSLUCENT_NEXT)];
}

float airlightTranslucentDistance(uint fragment)
{
  return uintBitsToFloat(
    translucentFragments[airlightTranslucentWord(fragment, AIRLIGHT_TRANSLUCENT_DISTANCE)]);
}

// Writes a record that no light has reached, before `next` in its list; it is lit at `litDistance`.
void airlightMakeTranslucent(uint fragment, uint next, float t, float litDistance)
{
  uint word = airlightTranslucentWord(fragment, 0u);
  translucentFragments[word + AIRLIGHT_TRANSLUCENT_NEXT] = next;
  translucentFragments[word + AIRLIGHT_TRANSLUCENT_DISTANCE] = floatBitsToUint(t);
  for (uint i = AIRLIGHT_TRANSLUCENT_RADIANCE; i < AIRLIGHT_TRANSLUCENT_WORDS; i++)
  {
    translucentFragments[word + i] = 0u;
  }
#if AIRLIGHT_SHADOW_TRANSMITTANCE
  if (AIRLIGHT_TRANSLUCENT_WORDS > AIRLIGHT_TRANSLUCENT_PLAIN_WORDS)
  {
    translucentFragments[word + AIRLIGHT_TRANSLUCENT_LIT_DISTANCE] = floatBitsToUint(litDistance);
  }
#endif
}

vec3 airlightTranslucentRadiance(uint fragment)
{
  uint word = airlightTranslucentWord(fragment, AIRLIGHT_TRANSLUCENT_RADIANCE);
  return vec3(uintBitsToFloat(translucentFragments[word]),
    uintBitsToFloat(translucentFragments[word + 1u]),
    uintBitsToFloat(translucentFragments[word + 2u]));
}

void airlightAddTranslucentRadiance(uint fragment, vec3 radiance)
{
  uint word = airlightTranslucentWord(fragment, AIRLIGHT_TRANSLUCENT_RADIANCE);
  for (uint i = 0u; i < 3u; i++)
  {
    translucentFragments[word + i] =
      floatBitsToUint(uintBitsToFloat(translucentFragments[word + i]) + radiance[i]);
  }
}

bool airlightIsTranslucentLit(uint fragment, int light)
{
  uint word = airlightTranslucentWord(fragment, AIRLIGHT_TRANSLUCENT_LIT + uint(light / 32));
  return (translucentFragments[word] & (1u << uint(light % 32))) != 0u;
}

void airlightSetTranslucentLit(uint fragment, int light)
{
  uint word = airlightTranslucentWord(fragment, AIRLIGHT_TRANSLUCENT_LIT + uint(light / 32));
  translucentFragments[word] |= 1u << uint(light % 32);
}

#if AIRLIGHT_SHADOW_TRANSMITTANCE
float airlightTranslucentLitDistance(uint fragment)
{
  return uintBitsToFloat(
    translucentFragments[airlightTranslucentWord(fragment, AIRLIGHT_TRANSLUCENT_LIT_DISTANCE)]);
}

void airlightSetTranslucentLitDistance(uint fragment, float t)
{
  translucentFragments[airlightTranslucentWord(fragment, AIRLIGHT_TRANSLUCENT_LIT_DISTANCE)] =
    floatBitsToUint(t);
}

// Of what casters leave of the light in place `slot`.
uint airlightTranslucentTransmittanceWord(uint fragment, int slot)
{
  return airlightTranslucentWord(fragment,
    AIRLIGHT_TRANSLUCENT_TRANSMITTANCE + AIRLIGHT_TRANSMITTANCE_WORDS * uint(slot));
}

uvec2 airlightTranslucentTransmittance(uint fragment, int slot)
{
  uint word = airlightTranslucentTransmittanceWord(fragment, slot);
  return uvec2(translucentFragments[word], translucentFragments[word + 1u]);
}

void airlightSetTranslucentTransmittance(uint fragment, int slot, uvec2 bits)
{
  uint word = airlightTranslucentTransmittanceWord(fragment, slot);
  translucentFragments[word] = bits.x;
  translucentFragments[word + 1u] = bits.y;
}
#endif
