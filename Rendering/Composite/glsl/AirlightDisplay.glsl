// From radiance to the screen: exposure, tone mapping, the output's colour space, dithering. What a
// frame does not need is left out when this is compiled. AIRLIGHT_TONE_MAPPING is a
// vtkAirlightPass::ToneMappingType, AIRLIGHT_COLOR_SPACE a vtkAirlightPass::OutputColorSpaceType.

uniform float airlightExposure;
uniform ivec2 airlightPicture; // the renderer's corner in the target, maybe outside

#if AIRLIGHT_TONE_MAPPING == 3
uniform vec4 airlightFilmic; // contrast, contrast times shoulder, clipping point, toe

// Of the Academy's colour encoding: from and to the primaries of Rec. 709 (S. Hill's fit).
const mat3 AIRLIGHT_TO_ACES = mat3(0.5972782, 0.0760130, 0.0284085, 0.3545713, 0.9083221, 0.1338243,
  0.0482177, 0.0156580, 0.8375685);
const mat3 AIRLIGHT_FROM_ACES = mat3(1.6047540, -0.1020832, -0.0032670, -0.5310795, 1.1081323,
  -0.0727552, -0.0736720, -0.0060519, 1.0760220);
#endif

#if AIRLIGHT_TONE_MAPPING == 4
// Khronos PBR Neutral: what is below 0.8 keeps its colour, but for the 4 % that a surface reflects
// without colour; what is above is compressed, and loses its colour.
vec3 airlightNeutral(vec3 colour)
{
  const float reflected = 0.04;
  const float start = 0.8 - reflected;
  const float fading = 0.15;
  float least = min(colour.r, min(colour.g, colour.b));
  colour -= least < 2.0 * reflected ? least - least * least / (4.0 * reflected) : reflected;
  float peak = max(colour.r, max(colour.g, colour.b));
  if (peak < start)
  {
    return colour;
  }
  float range = 1.0 - start;
  float compressed = 1.0 - range * range / (peak + range - start);
  float grey = 1.0 - 1.0 / (1.0 + fading * (peak - compressed));
  return mix(colour * (compressed / peak), vec3(compressed), grey);
}
#endif

vec3 airlightToneMapped(vec3 colour)
{
#if AIRLIGHT_TONE_MAPPING == 1
  return colour / (1.0 + colour);
#elif AIRLIGHT_TONE_MAPPING == 2
  return 1.0 - exp(-colour);
#elif AIRLIGHT_TONE_MAPPING == 3
  // Beyond this everything is white, and powers would be too large.
  colour = AIRLIGHT_TO_ACES * min(colour, vec3(1e4));
  colour = pow(colour, vec3(airlightFilmic.x)) /
    (pow(colour, vec3(airlightFilmic.y)) * airlightFilmic.z + airlightFilmic.w);
  return clamp(AIRLIGHT_FROM_ACES * colour, vec3(0.0), vec3(1.0));
#elif AIRLIGHT_TONE_MAPPING == 4
  return airlightNeutral(colour);
#else
  return colour;
#endif
}

vec3 airlightEncoded(vec3 colour)
{
#if AIRLIGHT_COLOR_SPACE == 1
  return pow(colour, vec3(1.0 / 2.2));
#elif AIRLIGHT_COLOR_SPACE == 2
  // IEC 61966-2-1.
  vec3 curve = 1.055 * pow(colour, vec3(1.0 / 2.4)) - 0.055;
  return mix(curve, 12.92 * colour, lessThanEqual(colour, vec3(0.0031308)));
#else
  return colour;
#endif
}

// Below half a step of 8 bits, and the same each time: a lattice in each channel, which has every
// value as often and no runs along rows or columns.
vec3 airlightDither()
{
  vec2 pixel = floor(gl_FragCoord.xy) - vec2(airlightPicture);
  float place = fract(0.7548776662 * pixel.x) + fract(0.5698402910 * pixel.y);
  return (fract(place + vec3(0.0, 1.0 / 3.0, 2.0 / 3.0)) - 0.5) * (0.998 / 255.0);
}

// Of a colour, or where it is to be blended of a colour times its opacity. VTK's backgrounds have
// no opacity, and are not blended. Airlight may be brighter than its opacity.
vec4 airlightDisplay(vec4 colour, bool blended)
{
#if AIRLIGHT_TONE_MAPPING != 0 || AIRLIGHT_COLOR_SPACE != 0
  vec3 exposed = clamp(airlightExposure * colour.rgb, vec3(0.0), vec3(1e30));
  float brightest = max(exposed.r, max(exposed.g, exposed.b));
  float opacity = blended ? clamp(max(colour.a, brightest), 1e-6, 1.0) : 1.0;
  vec3 shown = airlightEncoded(airlightToneMapped(exposed / opacity)) * opacity;
#else
  vec3 shown = airlightExposure * colour.rgb;
#endif
#if AIRLIGHT_DITHERING
  shown = clamp(shown, vec3(0.0), vec3(1.0)) + airlightDither();
#endif
  return vec4(shown, colour.a);
}
