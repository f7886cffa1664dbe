// A frame, to be blended with the mean of others.

uniform sampler2D addedFrame;
uniform float weight;

layout(location = 0) out vec4 radiance;

void main()
{
  radiance = weight * texelFetch(addedFrame, ivec2(gl_FragCoord.xy), 0);
}
