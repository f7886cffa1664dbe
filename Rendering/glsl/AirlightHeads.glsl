// What is known of each pixel's boundaries.

layout(std430, binding = 2) buffer AirlightHeads
{
  // The lists' boundaries; the longest list's. Then for each pixel the first of its list, 0 for none,
  // then for each pixel the number of boundaries that were to have slots.
  uint heads[];
};

// The first row of pixels that has slots; width and height of the viewport. A shadow plane says them to
// its fragments: software renderers take as long to read a uniform as for a dozen operations.
#ifdef AIRLIGHT_PLACES_IN
flat in ivec3 places;
#else
uniform ivec3 givenPlaces;
#define places givenPlaces
#endif

int airlightHeadIndex(ivec2 pixel)
{
  return 2 + pixel.y * places.y + pixel.x;
}

int airlightCountIndex(ivec2 pixel)
{
  return 2 + (places.z + pixel.y) * places.y + pixel.x;
}
