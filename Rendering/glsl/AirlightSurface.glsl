// Added to the mappers' fragment shaders, before main(): what becomes of each light on its way to
// this fragment.

#if AIRLIGHT_IN_PASS
uniform int airlightStage;     // 0: write distances, 1: write colours
uniform sampler2D airlightLit; // bits of the lights that reach the pixel's surface
uniform int airlightUseLit;
#else
const int airlightStage = 1;
#endif
#if AIRLIGHT_HAS_PHOTOMETRY
uniform AirlightPhotometry airlightPhotometries[AIRLIGHT_LAMPS];
uniform int airlightGoniometric[AIRLIGHT_LAMPS]; // 1: light k shines by its table
#endif

// The share of each light that arrives; see airlightReceive().
vec3 airlightArrived[AIRLIGHT_LAMPS];

// The share of light k that arrives at a point: transmittance, 0 in shadow.
vec3 airlightShare(int k, vec3 point)
{
  if (airlightLamps[k].w < 0.0)
  {
    return vec3(1.0);
  }
#if AIRLIGHT_IN_PASS
  if (airlightUseLit != 0 && k < 4 * AIRLIGHT_BITS)
  {
    vec4 bits = texelFetch(airlightLit, ivec2(airlightPixel()), 0);
    float word = bits[k / AIRLIGHT_BITS];
    if (mod(floor(word * exp2(-float(k % AIRLIGHT_BITS))), 2.0) < 0.5)
    {
      return vec3(0.0);
    }
  }
#endif
  vec3 share = exp(-(airlightLamps[k].w == 0.0
      ? airlightSunDepths(airlightMedia, point, airlightLamps[k].xyz)
      : airlightDepthBetween(airlightMedia, point, airlightLamps[k].xyz)));
#if AIRLIGHT_HAS_PHOTOMETRY
  if (airlightGoniometric[k] != 0)
  {
    share *= airlightPhotometry(airlightPhotometries[k], normalize(point - airlightLamps[k].xyz));
  }
#endif
  return share;
}

// In a loop and before the mapper's own lines of every light: compilers take time for what is there
// several times.
void airlightReceive()
{
  vec2 p = airlightPixel();
  vec3 point =
    airlightOrigin(p) + airlightFragmentDistance() * normalize(airlightDirection(p));
  int count = airlightStage == 0 ? 0 : airlightLampCount;
  for (int k = 0; k < count; k++)
  {
    airlightArrived[k] = airlightShare(k, point);
  }
}
