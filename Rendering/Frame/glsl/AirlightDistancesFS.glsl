// Distances of all opaque surfaces. Some props draw with actors of their own, whose shaders the
// pass does not get to add to: skyboxes, axes, billboards. Those wrote colours; their distance is
// that of the depth buffer, to its precision, and none where it is that of the far plane.

uniform sampler2D drawn;
uniform sampler2D sceneDepth;

layout(location = 0) out float found;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  vec2 value = texelFetch(drawn, pixel, 0).rg;
  found = value.r;
  if (value.g >= 0.0)
  {
    float z = texelFetch(sceneDepth, pixel, 0).r;
    float converted = airlightDepthToDistance.x + airlightDepthToDistance.y * z;
    found = z >= 1.0 ? -1.0 : airlightParallel != 0 ? converted : 1.0 / converted;
  }
}
