// Where the nodes of a froxel grid are on a ray: at equal steps from the eye to what is visible,
// then at equal steps of depth through that, then at growing ones, for the air behind; the last one
// at infinity.

uniform int airlightFroxelNodes;   // on a ray
uniform vec2 airlightFroxelDepths; // where the visible begins, and from one node to the next in it

const int AIRLIGHT_FROXEL_NEAR_NODES = 6;
const int AIRLIGHT_FROXEL_FAR_NODES = 7;

// The steps through what is visible.
float airlightFroxelSteps()
{
  return float(
    airlightFroxelNodes - 1 - AIRLIGHT_FROXEL_NEAR_NODES - AIRLIGHT_FROXEL_FAR_NODES);
}

// The place among the nodes of a depth.
float airlightFroxelPlace(float depth)
{
  float first = airlightFroxelDepths.x;
  float near = first > 0.0 ? clamp(depth / first, 0.0, 1.0) : 1.0;
  float place = max((depth - first) / airlightFroxelDepths.y, 0.0);
  float even = airlightFroxelSteps();
  float far = log2(1.0 + max(place - even, 0.0) / 4.0);
  return min(float(AIRLIGHT_FROXEL_NEAR_NODES) * near + min(place, even) + far,
    float(airlightFroxelNodes - 1));
}

float airlightFroxelDepth(int node)
{
  float even = airlightFroxelSteps();
  float inside = max(float(node - AIRLIGHT_FROXEL_NEAR_NODES), 0.0);
  float place = min(inside, even) + 4.0 * (exp2(max(inside - even, 0.0)) - 1.0);
  float near = min(float(node) / float(AIRLIGHT_FROXEL_NEAR_NODES), 1.0);
  float first = airlightFroxelDepths.x;
  first *= first > 0.0 ? near : 1.0;
  return node + 1 < airlightFroxelNodes ? first + airlightFroxelDepths.y * place : 1e37;
}
