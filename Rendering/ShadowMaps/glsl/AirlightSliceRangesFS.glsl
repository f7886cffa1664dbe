// The least and the most of each word of columns of a shadow map's slices
// (AirlightSliceLayout.glsl), after AirlightEpipolarMapFS.glsl: rays pass words that are lit or in
// shadow as wholes in one step.

uniform sampler2D slices; // four columns a texel
const int TEXELS = AIRLIGHT_SLICE_WORD / 4;

layout(location = 0) out vec4 range;

void main()
{
  ivec2 word = ivec2(gl_FragCoord.xy);
  vec4 least = texelFetch(slices, ivec2(TEXELS * word.x, word.y), 0);
  vec4 most = least;
  for (int i = 1; i < TEXELS; i++)
  {
    vec4 values = texelFetch(slices, ivec2(TEXELS * word.x + i, word.y), 0);
    least = min(least, values);
    most = max(most, values);
  }
  range = vec4(min(min(least.x, least.y), min(least.z, least.w)),
    max(max(most.x, most.y), max(most.z, most.w)), 0.0, 0.0);
}
