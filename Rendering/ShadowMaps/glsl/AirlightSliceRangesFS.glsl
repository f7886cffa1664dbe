// The least and the most of each word of columns of a shadow map's slices
// (AirlightSliceLayout.glsl), after AirlightEpipolarMapFS.glsl, of two words a texel: rays pass
// words that are lit or in shadow as wholes in one step.

uniform usampler2D slices;
const int TEXELS = AIRLIGHT_SLICE_WORD / AIRLIGHT_SLICE_TEXEL;

layout(location = 0) out vec4 ranges;

// Of an odd number of words, what would be the last one is the one before it again.
vec2 getRange(ivec2 word)
{
  word.x = min(word.x, sliceSize.x / AIRLIGHT_SLICE_WORD - 1);
  uvec4 least = uvec4(0xffffu);
  uvec4 most = uvec4(0u);
  for (int i = 0; i < TEXELS; i++)
  {
    uvec4 columns = texelFetch(slices, ivec2(TEXELS * word.x + i, word.y), 0);
    least = min(least, min(columns & 0xffffu, columns >> 16u));
    most = max(most, max(columns & 0xffffu, columns >> 16u));
  }
  least.xy = min(least.xy, least.zw);
  most.xy = max(most.xy, most.zw);
  vec4 range = airlightUnpackSlice(uvec4(min(least.x, least.y), max(most.x, most.y), 0u, 0u));
  return range.xy;
}

void main()
{
  ivec2 pair = ivec2(gl_FragCoord.xy);
  ranges.xy = getRange(ivec2(2 * pair.x, pair.y));
  ranges.zw = getRange(ivec2(2 * pair.x + 1, pair.y));
}
