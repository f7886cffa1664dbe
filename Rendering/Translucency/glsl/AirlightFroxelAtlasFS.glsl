// The nodes of a froxel grid as a texture: a tile for each node of a ray and each kind of value,
// one above the other in the order of depths. The kinds: radiance, loss, then each light. So a
// kind's column of tiles has the order of the grid.

layout(location = 0) out vec4 value;

void main()
{
  ivec2 place = ivec2(gl_FragCoord.xy);
  // Software renderers take long to divide integers.
  int kind = int(gl_FragCoord.x / float(airlightFroxelColumns));
  int number = kind == 0 ? AIRLIGHT_FROXEL_RADIANCE
    : kind == 1          ? AIRLIGHT_FROXEL_LOSS
                         : airlightFroxelLightNumber(kind - 2);
  int index =
    airlightFroxelIndex(place - ivec2(kind * airlightFroxelColumns, 0), 0, number);
  int next = airlightFroxelIndex(ivec2(0), airlightFroxelNodes, 0); // from a number to the next
  for (int i = 0; i < 4; i++)
  {
    value[i] = intBitsToFloat(froxelNumbers[index + i * next]);
  }
}
