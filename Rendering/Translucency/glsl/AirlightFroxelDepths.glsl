// Where the nodes of a froxel grid are on a ray: first at equal steps of depth, through all that is
// visible; then at growing ones, for the air behind; the last one at infinity.

uniform int airlightFroxelNodes;   // on a ray
uniform vec2 airlightFroxelDepths; // of the first node, and from one node to the next

const int AIRLIGHT_FROXEL_FAR_NODES = 7;

// The place among the nodes of a depth.
float airlightFroxelPlace(float depth)
{
  float place = max((depth - airlightFroxelDepths.x) / airlightFroxelDepths.y, 0.0);
  float even = float(airlightFroxelNodes - 1 - AIRLIGHT_FROXEL_FAR_NODES);
  float far = log2(1.0 + max(place - even, 0.0) / 4.0);
  return min(min(place, even) + far, float(airlightFroxelNodes - 1));
}

float airlightFroxelDepth(int node)
{
  float even = float(airlightFroxelNodes - 1 - AIRLIGHT_FROXEL_FAR_NODES);
  float place = min(float(node), even) + 4.0 * (exp2(max(float(node) - even, 0.0)) - 1.0);
  return node + 1 < airlightFroxelNodes
    ? airlightFroxelDepths.x + airlightFroxelDepths.y * place
    : 1e37;
}
