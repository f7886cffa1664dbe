// Puts the medium before the scene: radiance = airlight + transmittance * scene. What a frame does
// not need is left out when this is compiled: software renderers run both sides of every branch.
// AIRLIGHT_DEBUG_VIEW is a vtkAirlightPass::DebugViewType.

uniform sampler2D distances;
uniform sampler2D scene;
#ifndef AIRLIGHT_TRANSLUCENT
uniform sampler2D sceneDepth;
uniform int blended; // over what the framebuffer holds
#endif
uniform sampler2D scattered; // and bits of lights that reach the surface

layout(location = 0) out vec4 radiance;
#if defined(AIRLIGHT_RECORD) || AIRLIGHT_DEBUG_VIEW == 2
uniform sampler2D counts;
#endif
#ifdef AIRLIGHT_RECORD
uniform float error; // of ambient light, relative
layout(location = 1) out vec4 airlight; // radiance; error bound
layout(location = 2) out vec4 surface;
layout(location = 3) out vec4 transmittance; // and the distance along the unit ray
#endif
#if AIRLIGHT_RECORD_SEVERAL
uniform sampler2D severalOfLights;
layout(location = 4) out vec4 several; // scattered more than once
#endif

void main()
{
#if AIRLIGHT_EQUIANGULAR
  airlightTakeMedium();
#endif
  vec2 p = airlightPixel();
  ivec2 pixel = ivec2(p);
#if AIRLIGHT_CHOSEN
  if (texelFetch(sceneDepth, pixel, 0).r <= 0.0)
  {
    radiance = vec4(0.0);
    gl_FragDepth = 1.0;
    return;
  }
#endif
  float parameter = texelFetch(distances, pixel, 0).r;
  vec4 colour = texelFetch(scene, pixel, 0);
  float unit = airlightRayUnit(p);
#if AIRLIGHT_SHADOWING_LIGHT >= 0
  float bits = texelFetch(scattered, pixel, 0).a;
  colour = parameter >= 0.0 ? airlightInShadow(pixel, bits, colour) : colour;
#endif
  colour.rgb = airlightFinite(colour.rgb);
#if AIRLIGHT_ENCODED_INPUT
  colour.rgb = airlightDecode(colour.rgb);
#endif
  vec3 origin = airlightOrigin(p);
  vec3 direction = airlightDirection(p) / unit;
  float end = parameter >= 0.0 ? unit * parameter : AIRLIGHT_FAR;
#ifdef AIRLIGHT_SUNS
  vec4 sky = parameter >= 0.0 ? vec4(0.0) : airlightSunDiscs(direction);
  colour = vec4(colour.rgb + sky.rgb, max(colour.a, sky.a));
#endif
  vec3 passes = airlightTransmittanceOf(airlightDepth(origin, direction, end));
#ifdef AIRLIGHT_UNSHADOWED_LIGHTS
  vec3 once = airlightUnshadowedRays(p, origin, direction, unit, end);
#else
  // What a froxel grid takes away is interpolated, and may be more than there is.
  vec3 once = max(texelFetch(scattered, pixel, 0).rgb, vec3(0.0));
#endif
#if AIRLIGHT_DIFFUSE
  vec3 diffuse = airlightDiffuseRest(origin, direction, end);
#else
  const vec3 diffuse = vec3(0.0);
#endif
  vec3 added = once + diffuse;
  // A picture with a transparent background becomes as opaque as the medium is.
  float opacity = 1.0 - (1.0 - colour.a) * dot(passes, vec3(1.0 / 3.0));
  radiance = vec4(added + passes * colour.rgb, opacity);
#ifdef AIRLIGHT_RECORD
  airlight = vec4(added,
    texelFetch(counts, pixel, 0).g + error * max(diffuse.r, max(diffuse.g, diffuse.b)));
  surface = vec4(parameter >= 0.0 ? passes * colour.rgb : vec3(0.0), 1.0);
  transmittance = vec4(passes, parameter >= 0.0 ? end : -1.0);
#endif
#if AIRLIGHT_RECORD_SEVERAL
  several = texelFetch(severalOfLights, pixel, 0);
#if AIRLIGHT_DIFFUSE
  several.rgb += airlightMultipleOfCollisions(origin, direction, end);
#endif
#endif
#ifndef AIRLIGHT_TRANSLUCENT
#if AIRLIGHT_DEBUG_VIEW == 1
  radiance = vec4(added, 1.0);
#endif
  radiance = airlightDisplay(radiance, blended != 0);
#if AIRLIGHT_DEBUG_VIEW == 2
  // Black, red, yellow, white: 0, 5, 39, 255 and more boundaries.
  float heat = 3.0 * log2(1.0 + texelFetch(counts, pixel, 0).r) / 8.0;
  radiance = vec4(clamp(vec3(heat, heat - 1.0, heat - 2.0), 0.0, 1.0), 1.0);
#endif
#if !AIRLIGHT_MASKED
  gl_FragDepth = texelFetch(sceneDepth, pixel, 0).r;
#endif
#endif
}
