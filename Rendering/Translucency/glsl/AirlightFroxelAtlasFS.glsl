// The nodes of a froxel grid as a texture: a tile for each node of a ray and each kind of value,
// one above the other in the order of depths. The kinds: radiance, loss, then each light.

layout(location = 0) out vec4 value;

void main()
{
  ivec2 place = ivec2(gl_FragCoord.xy);
  ivec2 size = ivec2(airlightFroxelColumns, airlightFroxelRows);
  ivec2 tile = place / size;
  int number = tile.x == 0 ? AIRLIGHT_FROXEL_RADIANCE
    : tile.x == 1          ? AIRLIGHT_FROXEL_LOSS
                           : airlightFroxelLightNumber(tile.x - 2);
  for (int i = 0; i < 4; i++)
  {
    value[i] = intBitsToFloat(
      froxelNumbers[airlightFroxelIndex(place - tile * size, tile.y, number + i)]);
  }
}
