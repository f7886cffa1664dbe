// What a light loses on its way through media of which some have their density from an image, in
// shaders: in an image, the mean density on its way, interpolated from a coarser grid
// (AirlightLightGrid.h), times the length.

// So many cells of a light's grid may be crossed by the ways from a part of a ray, and such a share
// of the image.
#define AIRLIGHT_PART_CELLS 4.0
#define AIRLIGHT_PART_SHARE 0.0625

// The part of a way to the light that is in an image: where it begins, in cells of the light's
// grid, too, where it goes, and how long it is.
struct AirlightGridWay
{
  real3 cells;
  real3 entry;
  real3 direction;
  real reach;
};

AirlightGridWay airlightGridWay(
  AirlightMedium medium, real3 gridSize, real4x4 gridCells, AirlightLight light, real3 point)
{
  AirlightGridWay result;
  result.direction = light.position;
  real l = AIRLIGHT_FAR;
  if (!airlightIsDirectional(light))
  {
    result.direction = light.position - point;
    l = max(length(result.direction), 1e-30);
    result.direction /= l;
  }
  real2 range = airlightRegionRange(medium.region, point, result.direction, l);
  range = airlightGridRange(medium.grid, point, result.direction, range.x, range.y);
  result.reach = max(range.y - range.x, 0.0);
  result.entry = point + (result.reach > 0.0 ? range.x : 0.0) * result.direction;
  real3 cells = (gridCells * real4(result.entry, 1.0)).xyz;
  result.cells = clamp(cells, real3(0.0), gridSize);
  return result;
}

// At a place in the light's grid.
real airlightMeanOnWay(int first, real3 size, real3 place)
{
  real3 corner = clamp(floor(place), real3(0.0), size - 1.0);
  int3 cells = int3(size);
  AirlightCell cell;
  cell.low = airlightDataLayer(first, cells, int3(corner));
  cell.high = airlightDataLayer(first, cells, int3(corner) + int3(0, 0, 1));
  return airlightInCell(cell, place - corner);
}

// Of the ways from a point to the light through images in closed surfaces: how much of their reach
// is outside.
struct AirlightOutside
{
  real reach[AIRLIGHT_DIMMING_COUNT];
};

AirlightOutside airlightOutsideAt(AirlightLight light, real3 point)
{
  AirlightOutside outside;
  for (int i = 0; i < AIRLIGHT_DIMMING_COUNT; i++)
  {
    outside.reach[i] = 0.0;
#if AIRLIGHT_HAS_SURFACE
    if (AIRLIGHT_IS_GRID(i) && AIRLIGHT_IS_SURFACE(i))
    {
      AirlightGridWay way = airlightGridWay(
        airlightMedia.item[i], light.gridSize[i], light.gridCells[i], light, point);
      if (way.reach > 0.0)
      {
        outside.reach[i] = way.reach -
          airlightSurfaceSums(airlightMedia.item[i], way.entry, way.direction, way.reach, 0.0).x;
      }
    }
#endif
  }
  return outside;
}

AirlightOutside airlightMixOutside(AirlightOutside a, AirlightOutside b, real u)
{
  for (int i = 0; i < AIRLIGHT_DIMMING_COUNT; i++)
  {
    a.reach[i] = mix(a.reach[i], b.reach[i], u);
  }
  return a;
}

real3 airlightInsideLightDepth(AirlightLight light, real3 point, AirlightOutside outside)
{
  real3 depth = real3(0.0);
  for (int i = 0; i < AIRLIGHT_DIMMING_COUNT; i++)
  {
    if (AIRLIGHT_IS_GRID(i))
    {
      AirlightGridWay way = airlightGridWay(
        airlightMedia.item[i], light.gridSize[i], light.gridCells[i], light, point);
#if AIRLIGHT_HAS_SURFACE
      way.reach -= outside.reach[i];
#endif
      if (way.reach > 0.0)
      {
        real mean = airlightMeanOnWay(light.gridFirst[i], light.gridSize[i], way.cells);
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

real3 airlightLightDepth(AirlightLight light, real3 point)
{
  return airlightInsideLightDepth(light, point, airlightOutsideAt(light, point));
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
      real4x4 cells = light.gridCells[i];
      real3 middle = ray.origin + 0.5 * (a + b) * ray.direction;
      if (airlightGridWay(medium, size, cells, light, middle).reach > 0.0)
      {
        // A little inside, where no end is one by rounding.
        real inset = 1e-3 * (b - a);
        real3 from = ray.origin + (a + inset) * ray.direction;
        real3 to = ray.origin + (b - inset) * ray.direction;
        real3 moved = abs(airlightGridWay(medium, size, cells, light, from).cells -
          airlightGridWay(medium, size, cells, light, to).cells);
        moved = min(moved / AIRLIGHT_PART_CELLS, moved / (AIRLIGHT_PART_SHARE * size));
        most = max(most, max(moved.x, max(moved.y, moved.z)));
      }
    }
  }
#endif
  return most;
}
