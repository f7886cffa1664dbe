// What a light loses on its way through media of which some have their density from an image, in
// shaders: in an image, the mean density on its way, interpolated from a coarser grid
// (AirlightLightGrid.h), times the length.

// So many cells of a light's grid may be crossed by the ways from a part of a ray, and such a share
// of the image.
#define AIRLIGHT_PART_CELLS 4.0
#define AIRLIGHT_PART_SHARE 0.0625

// The part of a way to the light that is in an image: where it begins, in cells of the light's
// grid, and how long it is; in a closed surface, how long the part of it inside is.
struct AirlightGridWay
{
  real3 cells;
  real reach;
};

AirlightGridWay airlightGridWay(
  AirlightMedium medium, bool surface, real3 gridSize, AirlightLight light, real3 point)
{
  real3 way = light.position;
  real l = AIRLIGHT_FAR;
  if (!airlightIsDirectional(light))
  {
    way = light.position - point;
    l = max(length(way), 1e-30);
    way /= l;
  }
  real2 range = airlightRegionRange(medium.region, point, way, l);
  range = airlightGridRange(medium.grid, point, way, range.x, range.y);
  AirlightGridWay result;
  result.reach = max(range.y - range.x, 0.0);
  real3 entry = point + (result.reach > 0.0 ? range.x : 0.0) * way;
  real3 position = (medium.grid.start + medium.grid.axes * entry) / medium.grid.last;
  result.cells = clamp(position, 0.0, 1.0) * gridSize;
#if AIRLIGHT_HAS_SURFACE
  if (surface)
  {
    result.reach = airlightSurfaceSums(medium, entry, way, result.reach, 0.0).x;
  }
#endif
  return result;
}

real3 airlightLightDepth(AirlightLight light, real3 point)
{
  real3 depth = real3(0.0);
  for (int i = 0; i < AIRLIGHT_DIMMING_COUNT; i++)
  {
    if (AIRLIGHT_IS_GRID(i))
    {
      AirlightGridWay way = airlightGridWay(
        airlightMedia.item[i], AIRLIGHT_IS_SURFACE(i), light.gridSize[i], light, point);
      if (way.reach > 0.0)
      {
        real mean = airlightInterpolated(light.gridFirst[i], light.gridSize[i], way.cells);
        depth += airlightMedia.item[i].sigmaT * max(mean, 0.0) * way.reach;
      }
    }
    else if (airlightIsDirectional(light))
    {
      depth += airlightMedia.item[i].sigmaT *
        airlightSunDepth(airlightMedia.item[i], AIRLIGHT_IS_SURFACE(i), point, light.position);
    }
    else
    {
      real3 way = light.position - point;
      real l = max(length(way), 1e-30);
      depth += airlightMedia.item[i].sigmaT *
        airlightPathDepth(airlightMedia.item[i], AIRLIGHT_IS_SURFACE(i), point, way / l, l);
    }
  }
  return depth;
}

// How many parts the ways from [a, b] of a ray take for the images that they meet further on:
// the shadow of a cloud has the cloud's details.
real airlightBehindImages(AirlightLight light, AirlightRay ray, int inImages, real a, real b)
{
  real most = 0.0;
#if AIRLIGHT_DIMMING_COUNT > 1
  for (int i = 0; i < AIRLIGHT_DIMMING_COUNT; i++)
  {
    if (AIRLIGHT_IS_GRID(i) && ((inImages >> i) & 1) == 0)
    {
      AirlightMedium medium = airlightMedia.item[i];
      real3 size = light.gridSize[i];
      real3 middle = ray.origin + 0.5 * (a + b) * ray.direction;
      if (airlightGridWay(medium, false, size, light, middle).reach > 0.0)
      {
        // A little inside, where no end is one by rounding.
        real inset = 1e-3 * (b - a);
        real3 from = ray.origin + (a + inset) * ray.direction;
        real3 to = ray.origin + (b - inset) * ray.direction;
        real3 moved = abs(airlightGridWay(medium, false, size, light, from).cells -
          airlightGridWay(medium, false, size, light, to).cells);
        moved = min(moved / AIRLIGHT_PART_CELLS, moved / (AIRLIGHT_PART_SHARE * size));
        most = max(most, max(moved.x, max(moved.y, moved.z)));
      }
    }
  }
#endif
  return most;
}
