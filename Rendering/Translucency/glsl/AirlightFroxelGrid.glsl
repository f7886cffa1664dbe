// Froxels, the cells of a coarse grid in the view's frustum: the airlight before each of their
// nodes, and what arrives of each light there. The rays of a coarse picture have nodes at the same
// depths (AirlightFroxelDepths.glsl). The n-th numbers of all nodes lie together.

layout(std430, binding = AIRLIGHT_BINDING_FROXELS) buffer AirlightFroxelGrid
{
  int froxelNumbers[]; // bits of floats, if not counts
};
uniform int airlightFroxelColumns;
uniform int airlightFroxelRows;
uniform int airlightFroxelLight; // the light's place in a node, -1: it has no shadows

// Numbers of a node.
const int AIRLIGHT_FROXEL_RADIANCE = 0; // three: scattered into the ray before it
// Four, of one light: what translucent casters take of it, and the square of its uncertainty.
const int AIRLIGHT_FROXEL_LOSS = 3;
// Four a light: what translucent casters leave of it, and 1 where no opaque one hides it. Before,
// of the boundaries after the node before: the sums of their thickness and of their blocks.
const int AIRLIGHT_FROXEL_LIGHTS = 7;
const int AIRLIGHT_FROXEL_LIGHT_SIZE = 4;

int airlightFroxelIndex(ivec2 pixel, int node, int number)
{
  int row = (number * airlightFroxelNodes + node) * airlightFroxelRows + pixel.y;
  return row * airlightFroxelColumns + pixel.x;
}

int airlightFroxelLightNumber(int light)
{
  return AIRLIGHT_FROXEL_LIGHTS + AIRLIGHT_FROXEL_LIGHT_SIZE * light;
}

// The first node that is not before a depth.
int airlightFroxelNodeAt(float depth)
{
  return int(clamp(ceil(airlightFroxelPlace(depth)), 0.0, float(airlightFroxelNodes - 1)));
}
