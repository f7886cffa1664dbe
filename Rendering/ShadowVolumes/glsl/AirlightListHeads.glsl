// What is known of each pixel's boundaries.

layout(std430, binding = AIRLIGHT_BINDING_LIST_HEADS) buffer AirlightListHeads
{
  // The lists' boundaries; the longest list's. Then for each pixel the first of its list, 0 for
  // none, then for each pixel the number of boundaries that were to have slots.
  uint listHeads[];
};

// The first of the rows of pixels that are drawn, the viewport's width, and how many rows have
// heads. A shadow plane hands them to its fragments: software renderers take as long to read a
// uniform as for a dozen operations.
#ifdef AIRLIGHT_LIST_LAYOUT_IN
flat in ivec3 listLayout;
#else
uniform ivec3 givenListLayout;
#define listLayout givenListLayout
#endif

// Boundaries are counted up to this number, far beyond what any buffer holds, but for those that
// are on their way. Without it the counter of a huge scene would wrap, and lists would get cycles.
const uint AIRLIGHT_MOST_BOUNDARIES = 0x80000000u;

int airlightHeadIndex(ivec2 pixel)
{
  return 2 + (pixel.y - listLayout.x) * listLayout.y + pixel.x;
}

int airlightCountIndex(ivec2 pixel)
{
  return 2 + (listLayout.z + pixel.y - listLayout.x) * listLayout.y + pixel.x;
}
