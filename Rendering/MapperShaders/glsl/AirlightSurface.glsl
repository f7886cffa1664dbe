// Added to the mappers' fragment shaders, before main(): what becomes of each light on its way to
// this fragment.

#if AIRLIGHT_IN_PASS
// What is drawn: see SurfaceStage in AirlightSurfaceShader.h.
#if AIRLIGHT_ONLY_COLOURS
const int airlightStage = AIRLIGHT_STAGE_COLOUR;
#else
uniform int airlightStage;
#endif
// In alpha, bits of the first lights that reach the pixel's surface; and those of others.
uniform sampler2D airlightLit;
#if AIRLIGHT_MORE_LIT
uniform sampler2D airlightMoreLit;
#endif
uniform int airlightUseLit;
#else
const int airlightStage = AIRLIGHT_STAGE_TRANSLUCENT;
#endif
#if AIRLIGHT_HAS_PHOTOMETRY
uniform AirlightPhotometry airlightPhotometries[AIRLIGHT_SCENE_LIGHTS];
uniform int airlightGoniometric[AIRLIGHT_SCENE_LIGHTS]; // 1: light k shines by its table
#endif

#if AIRLIGHT_TRANSLUCENT_FRAGMENTS
uint airlightTranslucent = 0u; // this fragment's record, 0: none
#endif

#if AIRLIGHT_READS_LIT
// Read once for all lights: to fetch a texel takes software renderers longer than a light's share.
// Whole numbers in floats. Their bits are read as integers: exp2() is exact with some drivers only.
uvec4 airlightLitBits;

// All bits set where no lights' shadows are to be seen.
void airlightReadLit()
{
  airlightLitBits = uvec4((1u << uint(AIRLIGHT_BITS)) - 1u);
  if (airlightUseLit != 0 && airlightStage == AIRLIGHT_STAGE_COLOUR)
  {
    // A delegate may draw some pixels beyond the viewport.
    ivec2 pixel = ivec2(airlightPixel());
    pixel = clamp(pixel, ivec2(0), textureSize(airlightLit, 0) - 1);
    airlightLitBits.x = uint(texelFetch(airlightLit, pixel, 0).a);
#if AIRLIGHT_MORE_LIT
    airlightLitBits.yzw = uvec3(texelFetch(airlightMoreLit, pixel, 0).rgb);
#endif
  }
}
#endif

// The share of each light that arrives; see airlightReceive().
vec3 airlightReceivedLight[AIRLIGHT_SCENE_LIGHTS];
// of one of them; see SurfaceShaderOptions::ShadowingLight
float airlightShadowingLightFactor = 1.0;

#if AIRLIGHT_LIGHT_WAYS
// What media leave of lights on opaque surfaces (AirlightLightWaysPass.h). Delegates do without.
uniform sampler2D airlightLightWays;
uniform int airlightLayerRows;                          // of the texture, for each light
uniform int airlightLightLayers[AIRLIGHT_SCENE_LIGHTS]; // of light k, -1: it has none

vec3 airlightKnownWay(int k)
{
  ivec2 layer = ivec2(0, airlightLightLayers[k] * airlightLayerRows);
  return texelFetch(airlightLightWays, ivec2(airlightPixel()) + layer, 0).rgb;
}
#endif

// The share of light k that the medium leaves of it on its way to a point; `sun`: the light is at
// infinity.
vec3 airlightLightTransmittance(int k, bool sun, vec3 point)
{
#if AIRLIGHT_LIGHT_WAYS == 2
  vec3 share = airlightKnownWay(k);
#else
  bool known = false;
  vec3 share = vec3(1.0);
#if AIRLIGHT_LIGHT_WAYS
  known = airlightStage == AIRLIGHT_STAGE_COLOUR && airlightLightLayers[k] >= 0;
  if (known)
  {
    share = airlightKnownWay(k);
  }
#endif
  if (!known)
  {
    share = airlightTransmittanceOf(sun
        ? airlightSunDepths(point, airlightSceneLights[k].xyz)
        : airlightDepthBetween(point, airlightSceneLights[k].xyz));
  }
#endif
#if AIRLIGHT_HAS_PHOTOMETRY
  if (airlightGoniometric[k] != 0)
  {
    share *=
      airlightPhotometry(airlightPhotometries[k], normalize(point - airlightSceneLights[k].xyz));
  }
#endif
  return share;
}

// The same of a light with a position, `at` in VTK's coordinates. Where all media are everywhere
// the same its distance is all that counts, which the mapper's own shading asks for, too: then
// nothing needs to be known of the pixel's ray, whose numbers take software renderers as long as
// all of that shading.
#ifdef AIRLIGHT_HAS_POSITIONS
vec3 airlightTransmittanceOver(float way)
{
  vec3 sum = vec3(0.0);
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    sum += airlightMedia.item[i].sigmaT;
  }
  return airlightTransmittanceOf(sum * way);
}
#define AIRLIGHT_TRANSMITTANCE_FROM(k, at, point)                                                  \
  airlightTransmittanceOver(length(vertexVCVSOutput.xyz - at))
#else
#define AIRLIGHT_TRANSMITTANCE_FROM(k, at, point) airlightLightTransmittance(k, false, point)
#endif

#if AIRLIGHT_FROXELS
uniform int airlightFroxelLights[AIRLIGHT_SCENE_LIGHTS]; // place of light k, -1: it has no shadows

// What casters leave of light k before a translucent fragment, and of those that let light through
// on an opaque one. A translucent surface does not shadow its own lit side, which is the viewer's:
// what counts is a node nearer to the eye.
vec3 airlightShadowTransmittance(int k)
{
  int kind = 2 + airlightFroxelLights[k];
  if (kind < 2 || airlightUseLit == 0)
  {
    return vec3(1.0);
  }
  vec2 p = airlightPixel();
  float place = airlightFroxelPlace(airlightFragmentParameter());
  bool translucent = airlightStage == AIRLIGHT_STAGE_TRANSLUCENT;
  vec4 light = airlightFroxel(kind, p, translucent ? place - 1.0 : place);
  return light.rgb * (translucent ? light.w : 1.0);
}
#elif AIRLIGHT_SHADOW_TRANSMITTANCE
uniform int airlightTransmittanceSlots[AIRLIGHT_SCENE_LIGHTS]; // place of light k, -1: not dimmed

// What translucent casters leave of light k.
vec3 airlightShadowTransmittance(int k)
{
  int slot = airlightTransmittanceSlots[k];
  if (slot < 0 || airlightUseLit == 0)
  {
    return vec3(1.0);
  }
#if AIRLIGHT_TRANSLUCENT_FRAGMENTS
  if (airlightStage == AIRLIGHT_STAGE_TRANSLUCENT)
  {
    return airlightUnpack(airlightTranslucentTransmittance(airlightTranslucent, slot));
  }
#endif
  return airlightStage == AIRLIGHT_STAGE_COLOUR
    ? airlightUnpack(airlightSurfaceTransmittance(slot, ivec2(airlightPixel())))
    : vec3(1.0);
}
#endif

// The share of light k that arrives, of what the medium leaves of it: none in shadow.
vec3 airlightApplyShadows(int k, vec3 passed)
{
#if AIRLIGHT_TRANSLUCENT_FRAGMENTS
  if (airlightUseLit != 0 && airlightStage == AIRLIGHT_STAGE_TRANSLUCENT && k < 4 * AIRLIGHT_BITS)
  {
    if (!airlightIsTranslucentLit(airlightTranslucent, k))
    {
      return vec3(0.0);
    }
  }
#endif
#if AIRLIGHT_READS_LIT
  if (k < 4 * AIRLIGHT_BITS)
  {
    if (((airlightLitBits[k / AIRLIGHT_BITS] >> uint(k % AIRLIGHT_BITS)) & 1u) == 0u)
    {
      return vec3(0.0);
    }
  }
#endif
#if AIRLIGHT_SHADOW_TRANSMITTANCE || AIRLIGHT_FROXELS
  passed *= airlightShadowTransmittance(k);
#endif
  return passed;
}

// Before the mapper's own lines of every light: compilers take time for what is there several
// times.
void airlightReceive()
{
  vec3 point = airlightFragmentPoint();
#if AIRLIGHT_READS_LIT
  airlightReadLit();
#endif
#ifdef AIRLIGHT_EACH_LIGHT
  AIRLIGHT_EACH_LIGHT(point)
#else
  bool shades =
    airlightStage == AIRLIGHT_STAGE_COLOUR || airlightStage == AIRLIGHT_STAGE_TRANSLUCENT;
  int count = shades ? airlightSceneLightCount : 0;
  for (int k = 0; k < count; k++)
  {
    float kind = airlightSceneLights[k].w;
    airlightReceivedLight[k] = kind < 0.0
      ? vec3(1.0)
      : airlightApplyShadows(k, airlightLightTransmittance(k, kind == 0.0, point));
  }
#endif
}
