// What is known of each pixel's boundaries.

layout(std430, binding = 2) buffer AirlightHeads
{
  // The lists' boundaries; the most boundaries of a pixel with a list; the pixels with a list and
  // slots; one not used. Then for each pixel the first of its list, 0 for none, then for each pixel
  // the number of boundaries that were to have slots.
  uint heads[];
};

uniform int width;
uniform int height;

int airlightHeadIndex(ivec2 pixel)
{
  return 4 + pixel.y * width + pixel.x;
}

int airlightCountIndex(ivec2 pixel)
{
  return 4 + (height + pixel.y) * width + pixel.x;
}
