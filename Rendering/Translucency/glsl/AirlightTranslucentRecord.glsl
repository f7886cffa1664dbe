// The record of a translucent fragment, in words of 32 bits: where each value begins. Compiled as
// C++, too, which reserves the memory (AirlightTranslucentFragments.h). Shaders read and write
// records by the functions of AirlightTranslucentLists.glsl.

const uint AIRLIGHT_TRANSLUCENT_NEXT = 0u;     // index of the pixel's next record, 0 at the end
const uint AIRLIGHT_TRANSLUCENT_DISTANCE = 1u; // along the unit ray
const uint AIRLIGHT_TRANSLUCENT_RADIANCE = 2u; // three: scattered into the ray before the fragment
const uint AIRLIGHT_TRANSLUCENT_LIT = 5u;      // bits of the lights that reach it, 32 a word
const uint AIRLIGHT_TRANSLUCENT_PLAIN_WORDS = 8u;

// The side of a tile of pixels.
const uint AIRLIGHT_TRANSLUCENT_TILE = 16u;

// Where casters let light through, there are more: the distance just before the fragment at which
// it is lit, and two words for each light that is dimmed (AirlightTransmittanceBuffer.glsl).
const uint AIRLIGHT_TRANSLUCENT_LIT_DISTANCE = 8u;
const uint AIRLIGHT_TRANSLUCENT_TRANSMITTANCE = 9u;
const uint AIRLIGHT_TRANSMITTANCE_WORDS = 2u;
