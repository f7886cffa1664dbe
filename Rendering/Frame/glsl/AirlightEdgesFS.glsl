// The pixels of a picture that differ from one of their neighbours: 1 as depth, 0 elsewhere.
// Whatever straight edge crosses a pixel, one of its four neighbours lies beyond.

uniform sampler2D radiances;
uniform float airlightExposure;
uniform float contrast; // of what is shown

#if AIRLIGHT_BLENDED
#define AIRLIGHT_SHOWN vec4 // with opacity
#else
#define AIRLIGHT_SHOWN vec3
#endif

// What the display makes of a radiance, about.
AIRLIGHT_SHOWN airlightShown(ivec2 pixel)
{
  vec4 colour = texelFetch(radiances, pixel, 0);
#if AIRLIGHT_TONE_MAPPING == 0
  colour.rgb = clamp(airlightExposure * colour.rgb, 0.0, 1.0);
#else
  colour.rgb = clamp(airlightExposure * colour.rgb, 0.0, 1e30);
  colour.rgb = 2.0 * colour.rgb / (1.0 + colour.rgb);
#endif
#if AIRLIGHT_COLOR_SPACE != 0
  colour.rgb = sqrt(colour.rgb);
#endif
  return AIRLIGHT_SHOWN(colour);
}

AIRLIGHT_SHOWN airlightContrast(AIRLIGHT_SHOWN here, ivec2 neighbour, ivec2 last)
{
  return abs(airlightShown(clamp(neighbour, ivec2(0), last)) - here);
}

void main()
{
  ivec2 pixel = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(radiances, 0) - 1;
  AIRLIGHT_SHOWN here = airlightShown(pixel);
  AIRLIGHT_SHOWN most = max(max(airlightContrast(here, pixel + ivec2(1, 0), last),
                    airlightContrast(here, pixel - ivec2(1, 0), last)),
    max(airlightContrast(here, pixel + ivec2(0, 1), last),
      airlightContrast(here, pixel - ivec2(0, 1), last)));
  gl_FragDepth = any(greaterThan(most, AIRLIGHT_SHOWN(contrast))) ? 1.0 : 0.0;
}
