// The finished picture and its depth into the caller's framebuffer.

uniform sampler2D radiances;
uniform sampler2D sceneDepth;
#if !AIRLIGHT_MEAN
uniform sampler2D scene;
#endif
uniform ivec2 airlightViewport;
uniform int blended; // over what the framebuffer holds

layout(location = 0) out vec4 radiance;

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy) - airlightViewport;
  radiance = texelFetch(radiances, pixel, 0);
#if !AIRLIGHT_MEAN
  // What blends over opaque surfaces leaves them opaque, which VTK's passes do not keep to.
  radiance.a = texelFetch(scene, pixel, 0).a >= 1.0 ? 1.0 : radiance.a;
#endif
  radiance = airlightDisplay(radiance, blended != 0);
#if !AIRLIGHT_MASKED
  gl_FragDepth = texelFetch(sceneDepth, pixel, 0).r;
#endif
}
