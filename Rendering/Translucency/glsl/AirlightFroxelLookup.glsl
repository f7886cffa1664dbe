// What a froxel grid has at a place of the view, interpolated (AirlightFroxelAtlasFS.glsl).

uniform sampler2D airlightFroxels;
uniform vec2 airlightFroxelTile;  // columns and rows of a tile
uniform vec2 airlightFroxelScale; // columns and rows per pixel
uniform vec2 airlightFroxelTexel; // the texture's size is 1

// Of pixel p of the viewport; the kind is that of a tile.
vec4 airlightFroxel(int kind, vec2 p, float place)
{
  vec2 at = clamp(airlightFroxelScale * p, vec2(0.5), airlightFroxelTile - 0.5);
  float node = clamp(floor(place), 0.0, float(airlightFroxelNodes - 2));
  vec2 first = (at + airlightFroxelTile * vec2(float(kind), node)) * airlightFroxelTexel;
  vec2 next = first + vec2(0.0, airlightFroxelTile.y * airlightFroxelTexel.y);
  return mix(textureLod(airlightFroxels, first, 0.0), textureLod(airlightFroxels, next, 0.0),
    clamp(place - node, 0.0, 1.0));
}

// By how much the nodes around a place differ.
vec4 airlightFroxelRange(int kind, vec2 p, float place)
{
  ivec2 tile = ivec2(airlightFroxelTile);
  ivec2 first = ivec2(floor(airlightFroxelScale * p - 0.5));
  int node = clamp(int(floor(place)), 0, airlightFroxelNodes - 2);
  vec4 least = vec4(1e30);
  vec4 most = vec4(-1e30);
  for (int i = 0; i < 8; i++)
  {
    ivec2 at = clamp(first + ivec2(i % 2, i / 2 % 2), ivec2(0), tile - 1);
    vec4 value = texelFetch(airlightFroxels, at + tile * ivec2(kind, node + i / 4), 0);
    least = min(least, value);
    most = max(most, value);
  }
  return most - least;
}
