// Density from the samples of an image: trilinear between them, 0 outside. By hand in shaders, too:
// textures interpolate with 8 bits of fraction. AirlightDensityGrid.cxx compiles this in double
// precision. The two differ in how samples are stored: AIRLIGHT_SAMPLES says where they are,
// AIRLIGHT_LAYER reads those of a cell in one layer in z, AIRLIGHT_IS_EMPTY_BLOCK tells whether
// there is nothing in a block of cells, of which it gets the number, x fastest.

// Blocks have two to this power cells along each axis. Images are mostly empty, and ways leave an
// empty block in one step.
#define AIRLIGHT_BLOCK_SHIFT 3

// An axis along which a ray moves by less than this, in samples per unit, is one along which it
// does not move.
#ifdef AIRLIGHT_DOUBLE
#define AIRLIGHT_STILL 1e-300
#else
#define AIRLIGHT_STILL 1e-12
#endif

struct AirlightGrid
{
  real3x3 axes; // from coordinates relative to the eye to samples
  real3 start;  // the eye in samples, counted from the first one
  real3 last;   // the last sample
  AIRLIGHT_SAMPLES first;
};

// The eight samples of a cell: those of its lower and its upper layer, x fastest.
struct AirlightCell
{
  real4 low;
  real4 high;
};

// A ray on its way from cell to cell, in samples.
struct AirlightWalk
{
  real3 origin;
  real3 slope;
  real3 inverse; // of the slope, 0 along axes on which the ray does not move
  real3 never;   // AIRLIGHT_FAR along these axes, else 0
  real3 ahead;   // from the cell's first corner to the face through which the ray leaves it
  int3 stride;   // to the next cell
  int3 cell;
  int3 size;    // numbers of cells
  real3 leaves; // where the ray leaves the cell, for each axis
  real t;
  real end;
};

// Clips the range of a line to one axis of the box of samples.
AIRLIGHT_FN real2 airlightClipToSamples(real2 range, real o, real d, real last)
{
  if (abs(d) < real(AIRLIGHT_STILL))
  {
    return o >= real(0.0) && o <= last ? range : real2(real(0.0), real(0.0));
  }
  real a = -o / d;
  real b = (last - o) / d;
  return real2(max(range.x, min(a, b)), min(range.y, max(a, b)));
}

// The part of a range of a line that is inside the box of samples; x >= y: none.
AIRLIGHT_FN real2 airlightClipToGrid(real2 range, real3 o, real3 d, real3 last)
{
  range = airlightClipToSamples(range, o.x, d.x, last.x);
  range = airlightClipToSamples(range, o.y, d.y, last.y);
  range = airlightClipToSamples(range, o.z, d.z, last.z);
  return range;
}

// The part of [from, to] of a ray that is inside the box of samples; x >= y: none.
AIRLIGHT_FN real2 airlightGridRange(
  AIRLIGHT_IN(AirlightGrid) grid, real3 origin, real3 direction, real from, real to)
{
  return airlightClipToGrid(
    real2(from, to), grid.start + grid.axes * origin, grid.axes * direction, grid.last);
}

AIRLIGHT_FN void airlightFindLeaves(AIRLIGHT_INOUT(AirlightWalk) walk)
{
  walk.leaves = (real3(walk.cell) + walk.ahead - walk.origin) * walk.inverse + walk.never;
}

AIRLIGHT_FN AirlightWalk airlightWalk(
  AIRLIGHT_IN(AirlightGrid) grid, real3 origin, real3 direction, real from, real to)
{
  AirlightWalk walk;
  walk.origin = grid.start + grid.axes * origin;
  walk.slope = grid.axes * direction;
  real2 range = airlightClipToGrid(real2(from, to), walk.origin, walk.slope, grid.last);
  bool3 still = lessThan(abs(walk.slope), real3(real(AIRLIGHT_STILL)));
  walk.inverse = mix(real(1.0) / mix(walk.slope, real3(real(1.0)), still), real3(real(0.0)), still);
  walk.never = mix(real3(real(0.0)), real3(real(AIRLIGHT_FAR)), still);
  walk.ahead = step(real3(real(0.0)), walk.slope);
  walk.stride = int3(sign(walk.slope));
  walk.size = int3(grid.last);
  walk.t = range.x;
  walk.end = range.y;
  real3 p = walk.origin + walk.t * walk.slope;
  real3 below =
    mix(floor(p), ceil(p) - real(1.0), lessThan(walk.slope, real3(real(0.0))));
  walk.cell = int3(clamp(below, real3(real(0.0)), grid.last - real(1.0)));
  airlightFindLeaves(walk);
  return walk;
}

// More cells are on no ray.
AIRLIGHT_FN int airlightMostCells(AIRLIGHT_IN(AirlightWalk) walk)
{
  return walk.size.x + walk.size.y + walk.size.z + 4;
}

// Where it leaves its cell, or ends.
AIRLIGHT_FN real airlightCellEnd(AIRLIGHT_IN(AirlightWalk) walk)
{
  return min(min(walk.leaves.x, walk.leaves.y), min(walk.leaves.z, walk.end));
}

// To the next cell. Rounding may leave a rest in the last one.
AIRLIGHT_FN void airlightEnterNext(AIRLIGHT_INOUT(AirlightWalk) walk, real end)
{
  walk.t = max(walk.t, end);
  int3 next = walk.cell + int3(lessThanEqual(walk.leaves, real3(end))) * walk.stride;
  walk.cell = clamp(next, int3(0), walk.size - 1);
  airlightFindLeaves(walk);
  walk.leaves = walk.cell == next ? walk.leaves : real3(real(AIRLIGHT_FAR));
}

AIRLIGHT_FN int3 airlightBlock(AIRLIGHT_IN(AirlightWalk) walk)
{
  return walk.cell >> AIRLIGHT_BLOCK_SHIFT;
}

AIRLIGHT_FN bool airlightIsInEmptyBlock(
  AIRLIGHT_SAMPLES first, AIRLIGHT_IN(AirlightWalk) walk)
{
  int3 blocks = ((walk.size - 1) >> AIRLIGHT_BLOCK_SHIFT) + 1;
  int3 block = airlightBlock(walk);
  return AIRLIGHT_IS_EMPTY_BLOCK(
    first, block.x + blocks.x * (block.y + blocks.y * block.z));
}

// To the cell after the block.
AIRLIGHT_FN void airlightLeaveBlock(AIRLIGHT_INOUT(AirlightWalk) walk)
{
  int3 low = airlightBlock(walk) << AIRLIGHT_BLOCK_SHIFT;
  int last = (1 << AIRLIGHT_BLOCK_SHIFT) - 1;
  real3 face = real3(low) + real(last + 1) * walk.ahead;
  real3 leaves = (face - walk.origin) * walk.inverse + walk.never;
  real end = min(min(leaves.x, leaves.y), min(leaves.z, walk.end));
  walk.t = max(walk.t, end);
  // Where it leaves the block, the next cell is beyond the face, whatever rounding says.
  int3 high = min(low + last, walk.size - 1);
  int3 cell = clamp(int3(floor(walk.origin + walk.t * walk.slope)), low, high);
  int3 beyond = low + int3(walk.ahead) * (last + 1) + min(walk.stride, int3(0));
  int3 next = int3(mix(real3(cell), real3(beyond), lessThanEqual(leaves, real3(end))));
  walk.cell = clamp(next, int3(0), walk.size - 1);
  airlightFindLeaves(walk);
  // Rounding may leave a rest behind the image.
  walk.t = walk.cell == next ? walk.t : walk.end;
}

// `block`: the one that it was found in before, of which nothing needs to be read again.
AIRLIGHT_FN void airlightLeaveEmptyBlocks(
  AIRLIGHT_SAMPLES first, AIRLIGHT_INOUT(AirlightWalk) walk, AIRLIGHT_INOUT(int3) block)
{
  while (airlightBlock(walk) != block && walk.t < walk.end && airlightIsInEmptyBlock(first, walk))
  {
    airlightLeaveBlock(walk);
  }
  block = airlightBlock(walk);
}

AIRLIGHT_FN AirlightCell airlightCell(AIRLIGHT_SAMPLES first, int3 size, int3 cell)
{
  AirlightCell result;
  result.low = AIRLIGHT_LAYER(first, size, cell);
  result.high = AIRLIGHT_LAYER(first, size, cell + int3(0, 0, 1));
  return result;
}

AIRLIGHT_FN real airlightMostInCell(AIRLIGHT_IN(AirlightCell) cell)
{
  real4 larger = max(cell.low, cell.high);
  return max(max(larger.x, larger.y), max(larger.z, larger.w));
}

// Between the eight samples, at a place in the cell.
AIRLIGHT_FN real airlightInCell(AIRLIGHT_IN(AirlightCell) cell, real3 f)
{
  real4 layer = mix(cell.low, cell.high, f.z);
  real2 row = mix(real2(layer.x, layer.y), real2(layer.z, layer.w), f.y);
  return mix(row.x, row.y, f.x);
}

// Between the samples of a grid of so many cells.
AIRLIGHT_FN real airlightInterpolated(AIRLIGHT_SAMPLES first, real3 size, real3 p)
{
  real3 cell = clamp(floor(p), real3(real(0.0)), size - real(1.0));
  return airlightInCell(airlightCell(first, int3(size), int3(cell)), p - cell);
}

AIRLIGHT_FN real airlightGridDensity(AIRLIGHT_IN(AirlightGrid) grid, real3 point)
{
  real3 p = grid.start + grid.axes * point;
  // Written so that NaN is outside.
  bool inside =
    all(greaterThanEqual(p, real3(real(0.0)))) && all(lessThanEqual(p, grid.last));
  return inside ? max(airlightInterpolated(grid.first, grid.last, p), real(0.0)) : real(0.0);
}

// The density in a cell along a ray, a cubic of u in [0, 1]: its coefficients from four places.
AIRLIGHT_FN real4 airlightCellCubic(AIRLIGHT_IN(AirlightCell) cell, real3 a, real3 b)
{
  real f0 = airlightInCell(cell, a);
  real f1 = airlightInCell(cell, mix(a, b, real(1.0 / 3.0)));
  real f2 = airlightInCell(cell, mix(a, b, real(2.0 / 3.0)));
  real f3 = airlightInCell(cell, b);
  return real4(f0, real(-5.5) * f0 + real(9.0) * f1 - real(4.5) * f2 + f3,
    real(9.0) * f0 - real(22.5) * f1 + real(18.0) * f2 - real(4.5) * f3,
    real(4.5) * (f3 - f0) + real(13.5) * (f1 - f2));
}

// Integral of the density along [from, to] of a ray. A trilinear function is a cubic along a line
// in a cell, for which Gauss and Legendre's two nodes are exact.
AIRLIGHT_FN real airlightGridDepth(
  AIRLIGHT_IN(AirlightGrid) grid, real3 origin, real3 direction, real from, real to)
{
  AirlightWalk walk = airlightWalk(grid, origin, direction, from, to);
  real sum = real(0.0);
  int most = airlightMostCells(walk);
  int3 block = int3(-1);
  for (int i = 0; i < most; i++)
  {
    airlightLeaveEmptyBlocks(grid.first, walk, block);
    if (walk.t >= walk.end)
    {
      break;
    }
    real end = airlightCellEnd(walk);
    real reach = real(0.5) * (end - walk.t);
    if (reach > real(0.0))
    {
      AirlightCell cell = airlightCell(grid.first, walk.size, walk.cell);
      real3 middle = walk.origin + (walk.t + reach) * walk.slope - real3(walk.cell);
      real3 node = real(0.57735026918962576) * reach * walk.slope;
      sum += reach * (airlightInCell(cell, middle - node) + airlightInCell(cell, middle + node));
    }
    airlightEnterNext(walk, end);
  }
  return sum;
}
