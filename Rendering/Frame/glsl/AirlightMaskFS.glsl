// The nearest depth, which hides all that is drawn later, at pixels where a mask is 0; the others
// keep theirs.

uniform sampler2D mask;

void main()
{
  if (texelFetch(mask, ivec2(gl_FragCoord.xy), 0).r > 0.0)
  {
    discard;
  }
  gl_FragDepth = 0.0;
}
