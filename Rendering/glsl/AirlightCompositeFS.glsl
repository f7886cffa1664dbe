// Puts the medium before the scene: radiance = airlight + transmittance * scene.

uniform AirlightMedia media;
uniform sampler2D distances;
uniform sampler2D scene;
uniform int encodedInput; // 1: the scene's colours are encoded for display
#ifndef AIRLIGHT_LAYERS
uniform sampler2D sceneDepth;
uniform int encodedOutput; // 1: the picture is encoded for display
uniform int blended;   // over what the framebuffer holds
uniform int debugView; // vtkAirlightPass::DebugViewType
uniform sampler2D reference; // airlight by the ray march
#endif
uniform sampler2D scattered;

layout(location = 0) out vec4 radiance;
#if defined(AIRLIGHT_RECORD) || !defined(AIRLIGHT_LAYERS)
uniform sampler2D counts;
#endif
#ifdef AIRLIGHT_RECORD
uniform float error; // of what the media scatter of the ambient light, relative
layout(location = 1) out vec4 airlight; // radiance; error bound
layout(location = 2) out vec4 surface;
layout(location = 3) out vec4 transmittance;
#endif

void main()
{
  vec2 p = airlightPixel();
  ivec2 pixel = ivec2(p);
  float t = texelFetch(distances, pixel, 0).r;
  vec4 colour = texelFetch(scene, pixel, 0);
  // A light whose numbers are not finite makes the mappers shade surfaces with NaN.
  colour.rgb = min(mix(vec3(0.0), colour.rgb, equal(colour.rgb, colour.rgb)), vec3(1e30));
  colour.rgb = encodedInput != 0 ? airlightDecode(colour.rgb) : colour.rgb;
  vec3 origin = airlightOrigin(p);
  vec3 direction = normalize(airlightDirection(p));
  float end = t >= 0.0 ? t : AIRLIGHT_FAR;
  vec3 passes = exp(-airlightDepth(media, origin, direction, end));
  vec3 ambient = airlightAmbient(media, origin, direction, end);
  vec3 added = texelFetch(scattered, pixel, 0).rgb + ambient;
  // A picture with a transparent background becomes as opaque as the medium is.
  float opacity = 1.0 - (1.0 - colour.a) * dot(passes, vec3(1.0 / 3.0));
  radiance = vec4(added + passes * colour.rgb, opacity);
#ifdef AIRLIGHT_RECORD
  airlight = vec4(added,
    texelFetch(counts, pixel, 0).g + error * max(ambient.r, max(ambient.g, ambient.b)));
  surface = vec4(t >= 0.0 ? passes * colour.rgb : vec3(0.0), 1.0);
  transmittance = vec4(passes, 1.0);
#endif
#ifndef AIRLIGHT_LAYERS
  if (debugView == 1)
  {
    radiance = vec4(added, 1.0);
  }
  vec3 linear = radiance.rgb;
  if (encodedOutput != 0)
  {
    radiance = airlightEncode(radiance, blended != 0);
  }
  if (debugView == 2)
  {
    // Black, red, yellow, white: 0, 5, 39, 255 and more boundaries.
    float heat = 3.0 * log2(1.0 + texelFetch(counts, pixel, 0).r) / 8.0;
    radiance = vec4(clamp(vec3(heat, heat - 1.0, heat - 2.0), 0.0, 1.0), 1.0);
  }
  if (debugView == 4)
  {
    // Blue, white, red: 1 % less than the ray march, the same, 1 % more.
    float more =
      dot(texelFetch(scattered, pixel, 0).rgb - texelFetch(reference, pixel, 0).rgb, vec3(1.0));
    float share = clamp(100.0 * more / max(dot(linear, vec3(1.0)), 1e-30), -1.0, 1.0);
    radiance = vec4(1.0 + vec3(min(share, 0.0), -abs(share), min(-share, 0.0)), 1.0);
  }
  gl_FragDepth = texelFetch(sceneDepth, pixel, 0).r;
#endif
}
