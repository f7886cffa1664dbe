// The finished picture and its depth into the caller's framebuffer.

uniform sampler2D radiances;
uniform sampler2D sceneDepth;
uniform ivec2 airlightViewport;
uniform int encodedInput;
uniform int blended; // over what the framebuffer holds

layout(location = 0) out vec4 radiance;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - airlightViewport;
  radiance = texelFetch(radiances, pixel, 0);
  if (encodedInput != 0)
  {
    radiance = airlightEncode(radiance, blended != 0);
  }
  gl_FragDepth = texelFetch(sceneDepth, pixel, 0).r;
}
