// Added to the fragment shaders of VTK's volume ray casting: what the medium before each sample
// makes of its colour before it is blended, and what of each light arrives at it.
//
// The air before the samples, scattered light and, unless all media are uniform, optical depth, is
// known at a few nodes, equally spaced between where the ray enters the volume and where it ends,
// and interpolated by cubics that rise wherever the nodes do.

const int AIRLIGHT_NODES = 16;
uniform int airlightNodeCount;    // 2 to AIRLIGHT_NODES
uniform mat4 airlightVolumeToEye; // from the data set's coordinates to those of the rays
uniform vec2 airlightVolumeSize;  // of the viewport, pixels
// those with a position first, as VTK may number them
uniform int airlightSortedSceneLights[AIRLIGHT_SCENE_LIGHTS];

vec3 airlightVolumeOrigin; // of the ray, as airlightOrigin()
vec3 airlightVolumeAlong;  // unit
vec3 airlightPerTexture;   // what the distance grows by along the texture's coordinates
float airlightFirstNode;   // distances along the ray
float airlightNodeStep;
vec3 airlightNodeAir[AIRLIGHT_NODES];
vec3 airlightNodeAirSlope[AIRLIGHT_NODES]; // a step
#if !AIRLIGHT_UNIFORM_MEDIA
AirlightSpectrum airlightNodeDepth[AIRLIGHT_NODES];
AirlightSpectrum airlightNodeDepthSlope[AIRLIGHT_NODES];
#endif
#if AIRLIGHT_TRANSLUCENT_FRAGMENTS
uint airlightNodeTranslucent[AIRLIGHT_NODES]; // records, 0: none

// As many pixels as the viewport has, where VTK draws volumes in lower resolution, too.
ivec2 airlightVolumePixel()
{
  vec2 p = (gl_FragCoord.xy - in_windowLowerLeftCorner) * in_inverseWindowSize;
  return ivec2(clamp(p * airlightVolumeSize, vec2(0.0), airlightVolumeSize - 1.0));
}

// In the first draw: a record for each node.
void airlightCollectNodes()
{
  uint count = uint(airlightNodeCount);
  uint first = airlightAddTranslucent(count);
  if (first + count > uint(airlightTranslucentCapacity))
  {
    return;
  }
  uint next = airlightPrependTranslucent(airlightVolumePixel(), first);
  for (uint k = 0u; k < count; k++)
  {
    float t = airlightFirstNode + float(k) * airlightNodeStep;
    airlightMakeTranslucent(first + k, k + 1u < count ? first + k + 1u : next, t, t);
  }
}

// In the last draw: the nearest record of each node.
void airlightFindNodes()
{
  float nearest[AIRLIGHT_NODES];
  for (int i = 0; i < airlightNodeCount; i++)
  {
    airlightNodeTranslucent[i] = 0u;
    nearest[i] = 0.5;
  }
  // Those that can be nodes: half a step more at both ends.
  float margin = 0.5 * airlightNodeStep;
  uvec2 sorted = airlightSortedTranslucent(airlightVolumePixel());
  float last = airlightFirstNode + float(airlightNodeCount - 1) * airlightNodeStep + margin;
  for (uint at = airlightFindSorted(sorted, airlightFirstNode - margin);
       at < sorted.x + sorted.y && airlightSortedDistance(at) <= last; at++)
  {
    uint fragment = airlightSortedRecord(at);
    float place = (airlightSortedDistance(at) - airlightFirstNode) / airlightNodeStep;
    int i = int(clamp(floor(place + 0.5), 0.0, float(airlightNodeCount - 1)));
    float apart = abs(place - float(i));
    if (apart < nearest[i])
    {
      airlightNodeTranslucent[i] = fragment;
      nearest[i] = apart;
    }
  }
}
#endif

// What the medium scatters into the ray before node i.
vec3 airlightInscatterToNode(int i, float t)
{
#if AIRLIGHT_TRANSLUCENT_FRAGMENTS
  airlightTranslucent = airlightNodeTranslucent[i];
  if (airlightTranslucent == 0u)
  {
    // As if nothing cast shadows there, of which nothing is known.
    return airlightDiffuse(airlightVolumeOrigin, airlightVolumeAlong, t);
  }
#endif
  return airlightInscatterToFragment(airlightVolumeOrigin, airlightVolumeAlong, t);
}

// The slope at a node between two that rise, so that the cubics between them do.
vec3 airlightSlope(vec3 before, vec3 after)
{
  return clamp(0.5 * (before + after), vec3(0.0), 3.0 * max(min(before, after), vec3(0.0)));
}

vec3 airlightEndSlope(vec3 next, vec3 other)
{
  return clamp(1.5 * next - 0.5 * other, vec3(0.0), 3.0 * max(next, vec3(0.0)));
}

AirlightSpectrum airlightVolumeDepth(float t)
{
  return AIRLIGHT_SPECTRUM(
    airlightDepth(airlightVolumeOrigin, airlightVolumeAlong, t));
}

void airlightFillNodes()
{
  for (int i = 0; i < airlightNodeCount; i++)
  {
    float t = airlightFirstNode + float(i) * airlightNodeStep;
    airlightNodeAir[i] = airlightInscatterToNode(i, t);
#if !AIRLIGHT_UNIFORM_MEDIA
    airlightNodeDepth[i] = airlightVolumeDepth(t);
#endif
  }
  int last = airlightNodeCount - 1;
  for (int i = 0; i <= last; i++)
  {
    int low = clamp(i - 1, 0, last - 1);
    int high = min(low + 1, last - 1);
    int other = i == 0 ? high : max(low - 1, 0);
    bool inner = i > 0 && i < last;
    vec3 air = airlightNodeAir[low + 1] - airlightNodeAir[low];
    vec3 nextAir = airlightNodeAir[high + 1] - airlightNodeAir[high];
    vec3 otherAir = airlightNodeAir[other + 1] - airlightNodeAir[other];
    airlightNodeAirSlope[i] = inner ? airlightSlope(air, nextAir) : airlightEndSlope(air, otherAir);
#if !AIRLIGHT_UNIFORM_MEDIA
    vec3 depth = vec3(airlightNodeDepth[low + 1] - airlightNodeDepth[low]);
    vec3 nextDepth = vec3(airlightNodeDepth[high + 1] - airlightNodeDepth[high]);
    vec3 otherDepth = vec3(airlightNodeDepth[other + 1] - airlightNodeDepth[other]);
    airlightNodeDepthSlope[i] = AIRLIGHT_SPECTRUM(
      inner ? airlightSlope(depth, nextDepth) : airlightEndSlope(depth, otherDepth));
#endif
  }
}

// The ray from where it enters the volume to where it leaves it or ends.
void airlightFindSpan()
{
  mat4 flip = mat4(1.0); // as the vertex shader does
  flip[0][0] = sign(in_cellSpacing[0].x);
  flip[1][1] = sign(in_cellSpacing[0].y);
  flip[2][2] = sign(in_cellSpacing[0].z);
  mat4 place =
    airlightVolumeToEye * in_textureDatasetMatrix[0] * flip * inverse(in_cellToPoint[0]);
  float steps = g_terminatePointMax;
  for (int axis = 0; axis < 3; axis++)
  {
    float d = g_dirStep[axis];
    float end = d > 0.0 ? in_texMax[0][axis] : in_texMin[0][axis];
    steps = abs(d) > 1e-20 ? min(steps, (end - g_rayOrigin[axis]) / d) : steps;
  }
  vec3 a = (place * vec4(g_rayOrigin, 1.0)).xyz;
  vec3 b = (place * vec4(g_rayOrigin + max(steps, 0.0) * g_dirStep, 1.0)).xyz;
  vec3 deep = cross(airlightRayOrigin[1], airlightRayOrigin[2]);
  airlightVolumeAlong =
    airlightParallel != 0 ? normalize(airlightDirection(vec2(0.0))) : normalize(b);
  vec3 across = airlightParallel != 0 ? deep : airlightVolumeAlong;
  float unit = dot(airlightVolumeAlong, across);
  airlightFirstNode = dot(a, across) / unit;
  airlightVolumeOrigin =
    airlightParallel != 0 ? a - airlightFirstNode * airlightVolumeAlong : vec3(0.0);
  float span = max(dot(b, across) / unit - airlightFirstNode, 1e-6 * abs(airlightFirstNode));
  airlightNodeStep = max(span, 1e-30) / float(airlightNodeCount - 1);
  airlightPerTexture = across * mat3(place) / unit;
}

// At the end of VTK's own preparations.
void airlightStartVolume()
{
  for (int k = 0; k < AIRLIGHT_SCENE_LIGHTS; k++)
  {
    airlightReceivedLight[k] = vec3(1.0);
  }
  if (airlightStage != AIRLIGHT_STAGE_TRANSLUCENT && airlightStage != AIRLIGHT_STAGE_COLLECT)
  {
    return;
  }
  airlightFindSpan();
#if AIRLIGHT_TRANSLUCENT_FRAGMENTS
  if (airlightStage == AIRLIGHT_STAGE_COLLECT)
  {
    airlightCollectNodes();
    discard;
  }
  airlightFindNodes();
#endif
  airlightFillNodes();
}

// The sample's distance along the ray.
float airlightSampleDistance()
{
  return airlightFirstNode + dot(g_dataPos - g_rayOrigin, airlightPerTexture);
}

// Its place among the nodes: the first of two, and the share of the other.
int airlightSampleNode(float t, out float share)
{
  float place =
    clamp((t - airlightFirstNode) / airlightNodeStep, 0.0, float(airlightNodeCount - 1));
  int i = min(int(place), airlightNodeCount - 2);
  share = place - float(i);
  return i;
}

#if AIRLIGHT_TRANSLUCENT_FRAGMENTS
// What casters leave of light k at node i.
vec3 airlightNodeLight(int i, int k)
{
  if (airlightNodeTranslucent[i] == 0u)
  {
    return vec3(1.0);
  }
  vec3 light = vec3(airlightIsTranslucentLit(airlightNodeTranslucent[i], k) ? 1.0 : 0.0);
#if AIRLIGHT_SHADOW_TRANSMITTANCE
  if (airlightTransmittanceSlots[k] >= 0)
  {
    light *= airlightUnpack(
      airlightTranslucentTransmittance(airlightNodeTranslucent[i], airlightTransmittanceSlots[k]));
  }
#endif
  return light;
}
#endif

// What arrives of each light at the sample. The edges of shadows are as wide as nodes are apart.
void airlightReceiveSample()
{
  if (airlightStage != AIRLIGHT_STAGE_TRANSLUCENT)
  {
    return;
  }
  float t = airlightSampleDistance();
  vec3 point = airlightVolumeOrigin + t * airlightVolumeAlong;
  float share;
  int i = airlightSampleNode(t, share);
  for (int k = 0; k < airlightSceneLightCount; k++)
  {
    float kind = airlightSceneLights[k].w;
    airlightReceivedLight[k] =
      kind < 0.0 ? vec3(1.0) : airlightLightTransmittance(k, kind == 0.0, point);
#if AIRLIGHT_TRANSLUCENT_FRAGMENTS
    if (airlightUseLit != 0 && airlightSceneLights[k].w >= 0.0 && k < 4 * AIRLIGHT_BITS)
    {
      airlightReceivedLight[k] *= mix(airlightNodeLight(i, k), airlightNodeLight(i + 1, k), share);
    }
#endif
  }
}

vec3 airlightCubic(vec3 a, vec3 aSlope, vec3 b, vec3 bSlope, float x)
{
  float y = 1.0 - x;
  return y * y * ((1.0 + 2.0 * x) * a + x * aSlope) + x * x * ((1.0 + 2.0 * y) * b - y * bSlope);
}

// The optical depth before the sample at t, which is the share x behind node i.
AirlightSpectrum airlightSampleDepth(float t, int i, float x)
{
#if AIRLIGHT_UNIFORM_MEDIA
  return airlightVolumeDepth(t);
#else
  return AIRLIGHT_SPECTRUM(airlightCubic(vec3(airlightNodeDepth[i]),
    vec3(airlightNodeDepthSlope[i]), vec3(airlightNodeDepth[i + 1]),
    vec3(airlightNodeDepthSlope[i + 1]), x));
#endif
}

// A sample's colour, times its opacity, behind the medium before it.
vec4 airlightApplyMediumToVolume(vec4 colour)
{
  if (airlightStage != AIRLIGHT_STAGE_TRANSLUCENT || colour.a <= 0.0)
  {
    return colour;
  }
#if AIRLIGHT_SHADED_VOLUME
  colour.rgb = airlightFinite(colour.rgb);
#endif
#if AIRLIGHT_ENCODED_INPUT
  colour.rgb = colour.a * airlightDecode(colour.rgb / colour.a);
#endif
  float x;
  float t = airlightSampleDistance();
  int i = airlightSampleNode(t, x);
  AirlightSpectrum depth = airlightSampleDepth(t, i, x);
  vec3 air = airlightCubic(airlightNodeAir[i], airlightNodeAirSlope[i], airlightNodeAir[i + 1],
    airlightNodeAirSlope[i + 1], x);
  return vec4(colour.rgb * exp(-depth) + colour.a * air, colour.a);
}
