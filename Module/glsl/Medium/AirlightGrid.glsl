// Density from the samples of an image, in shaders: trilinear between them, 0 outside. By hand:
// textures interpolate with 8 bits of fraction. AirlightDensityGrid.h is the same in double
// precision for the CPU.

struct AirlightGrid
{
  mat3 axes;  // from coordinates relative to the eye to samples
  vec3 start; // the eye in samples, counted from the first one
  vec3 last;  // the last sample
  int first;  // texel: each has four samples, 2 x 2 in x and y, of one layer in z
};

// The eight samples of a cell: those of its lower and its upper layer.
struct AirlightCell
{
  vec4 low;
  vec4 high;
};

// A ray on its way from cell to cell, in samples.
struct AirlightWalk
{
  vec3 origin;
  vec3 slope;
  vec3 inverse; // of the slope, 0 along axes on which the ray does not move
  vec3 leaves;  // where it leaves the cell, for each axis
  ivec3 cell;
  ivec3 size; // numbers of cells
  float t;
  float end;
};

// The part of [from, to] of a ray that is inside the image; x >= y: none.
vec2 airlightGridRange(AirlightGrid grid, vec3 origin, vec3 direction, float from, float to)
{
  vec3 o = grid.start + grid.axes * origin;
  vec3 d = grid.axes * direction;
  vec2 range = vec2(from, to);
  range = airlightClipSlab(range, o.x, d.x, 0.0, grid.last.x);
  range = airlightClipSlab(range, o.y, d.y, 0.0, grid.last.y);
  range = airlightClipSlab(range, o.z, d.z, 0.0, grid.last.z);
  return range;
}

void airlightFindLeaves(inout AirlightWalk walk)
{
  vec3 face = vec3(walk.cell) + step(0.0, walk.slope);
  walk.leaves = mix(vec3(AIRLIGHT_FAR), (face - walk.origin) * walk.inverse,
    notEqual(walk.inverse, vec3(0.0)));
}

AirlightWalk airlightWalk(AirlightGrid grid, vec3 origin, vec3 direction, float from, float to)
{
  AirlightWalk walk;
  vec2 range = airlightGridRange(grid, origin, direction, from, to);
  walk.origin = grid.start + grid.axes * origin;
  walk.slope = grid.axes * direction;
  bvec3 still = lessThan(abs(walk.slope), vec3(1e-12));
  walk.inverse = mix(1.0 / mix(walk.slope, vec3(1.0), still), vec3(0.0), still);
  walk.size = ivec3(grid.last);
  walk.t = range.x;
  walk.end = range.y;
  vec3 p = walk.origin + walk.t * walk.slope;
  vec3 below = mix(floor(p), ceil(p) - 1.0, lessThan(walk.slope, vec3(0.0)));
  walk.cell = ivec3(clamp(below, vec3(0.0), grid.last - 1.0));
  airlightFindLeaves(walk);
  return walk;
}

// More cells are on no ray.
int airlightMostCells(AirlightWalk walk)
{
  return walk.size.x + walk.size.y + walk.size.z + 4;
}

// Where it leaves its cell, or ends.
float airlightCellEnd(AirlightWalk walk)
{
  return min(min(walk.leaves.x, walk.leaves.y), min(walk.leaves.z, walk.end));
}

// To the next cell. Rounding may leave a rest in the last one.
void airlightEnterNext(inout AirlightWalk walk, float end)
{
  walk.t = max(walk.t, end);
  ivec3 next = walk.cell +
    ivec3(lessThanEqual(walk.leaves, vec3(end))) * ivec3(sign(walk.slope));
  walk.cell = clamp(next, ivec3(0), walk.size - 1);
  airlightFindLeaves(walk);
  walk.leaves = walk.cell == next ? walk.leaves : vec3(AIRLIGHT_FAR);
}

AirlightCell airlightCell(int first, ivec3 size, ivec3 cell)
{
  int texel = first + cell.x + size.x * (cell.y + size.y * cell.z);
  AirlightCell result;
  result.low = texelFetch(airlightData, texel);
  result.high = texelFetch(airlightData, texel + size.x * size.y);
  return result;
}

// Between the eight samples, at a place in the cell.
float airlightInCell(AirlightCell cell, vec3 f)
{
  vec4 layer = mix(cell.low, cell.high, f.z);
  vec2 row = mix(layer.xy, layer.zw, f.y);
  return mix(row.x, row.y, f.x);
}

// Between the samples of a grid of so many cells.
float airlightInterpolated(int first, vec3 size, vec3 p)
{
  vec3 cell = clamp(floor(p), vec3(0.0), size - 1.0);
  return airlightInCell(airlightCell(first, ivec3(size), ivec3(cell)), p - cell);
}

float airlightGridDensity(AirlightGrid grid, vec3 point)
{
  vec3 p = grid.start + grid.axes * point;
  bool inside = all(greaterThanEqual(p, vec3(0.0))) && all(lessThanEqual(p, grid.last));
  return inside ? max(airlightInterpolated(grid.first, grid.last, p), 0.0) : 0.0;
}

// The density in a cell along a ray, a cubic of u in [0, 1]: its coefficients from four places.
vec4 airlightCellCubic(AirlightCell cell, vec3 a, vec3 b)
{
  float f0 = airlightInCell(cell, a);
  float f1 = airlightInCell(cell, mix(a, b, 1.0 / 3.0));
  float f2 = airlightInCell(cell, mix(a, b, 2.0 / 3.0));
  float f3 = airlightInCell(cell, b);
  return vec4(f0, -5.5 * f0 + 9.0 * f1 - 4.5 * f2 + f3, 9.0 * f0 - 22.5 * f1 + 18.0 * f2 - 4.5 * f3,
    4.5 * (f3 - f0) + 13.5 * (f1 - f2));
}

// Integral of the density along [from, to] of a ray. Two nodes a cell are exact for cubics.
float airlightGridDepth(AirlightGrid grid, vec3 origin, vec3 direction, float from, float to)
{
  AirlightWalk walk = airlightWalk(grid, origin, direction, from, to);
  float sum = 0.0;
  int most = airlightMostCells(walk);
  for (int i = 0; i < most && walk.t < walk.end; i++)
  {
    float end = airlightCellEnd(walk);
    float reach = 0.5 * (end - walk.t);
    if (reach > 0.0)
    {
      AirlightCell cell = airlightCell(grid.first, walk.size, walk.cell);
      vec3 middle = walk.origin + (walk.t + reach) * walk.slope - vec3(walk.cell);
      vec3 node = 0.57735026918962576 * reach * walk.slope;
      sum += reach * (airlightInCell(cell, middle - node) + airlightInCell(cell, middle + node));
    }
    airlightEnterNext(walk, end);
  }
  return sum;
}
