// The nearest depth at pixels that are not drawn; the others keep theirs.

uniform sampler2D drawn; // of bytes, 1 or 0

void main()
{
  if (texelFetch(drawn, ivec2(gl_FragCoord.xy), 0).r > 0.0)
  {
    discard;
  }
  gl_FragDepth = 0.0;
}
