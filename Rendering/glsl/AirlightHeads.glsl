// What is known of each pixel's boundaries.

layout(std430, binding = 2) buffer AirlightHeads
{
  // The lists' boundaries; the most boundaries of a pixel with a list; the pixels with a list and
  // slots; one not used. Then for each pixel the first of its list, 0 for none, then for each pixel
  // the number of boundaries that were to have slots.
  uint heads[];
};

// Of the slots the first row of pixels and the tiles of eight pixels in a row of them; width and height
// of the viewport. A shadow plane says them to its fragments: software renderers take as long to read
// a uniform as for a dozen operations.
#ifdef AIRLIGHT_PLACES_IN
flat in ivec4 places;
#else
uniform ivec4 places;
#endif

int airlightHeadIndex(ivec2 pixel)
{
  return 4 + pixel.y * places.z + pixel.x;
}

int airlightCountIndex(ivec2 pixel)
{
  return 4 + (places.w + pixel.y) * places.z + pixel.x;
}
