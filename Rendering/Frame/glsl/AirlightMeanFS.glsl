// The mean of frames and the last one's depth into the caller's framebuffer.

uniform sampler2D mean;
uniform sampler2D frameDepth;
uniform int encodedOutput; // 1: the picture is encoded for display
uniform int blended;       // over what the framebuffer holds

layout(location = 0) out vec4 radiance;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  radiance = texelFetch(mean, pixel, 0);
  if (encodedOutput != 0)
  {
    radiance = airlightEncode(radiance, blended != 0);
  }
  gl_FragDepth = texelFetch(frameDepth, pixel, 0).r;
}
