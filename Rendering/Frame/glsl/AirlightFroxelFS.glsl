// One light's airlight before the nodes of a froxel grid's rays. What arrives of the light at the
// nodes follows from the sums of the boundaries between them. From node to node the boundaries are
// taken to be spread evenly.

uniform AirlightLight light;
uniform AirlightLightPixel lightPixel;
uniform int startBlocks; // at the start of the rays
uniform ivec3 startThickness;

struct Arriving
{
  int blocks;
  ivec3 thickness;
};

Arriving addBoundaries(Arriving before, ivec2 pixel, int node)
{
  int number = airlightFroxelLightNumber(airlightFroxelLight);
  for (int i = 0; i < 3; i++)
  {
    before.thickness[i] += froxelNumbers[airlightFroxelIndex(pixel, node, number + i)];
  }
  before.blocks += froxelNumbers[airlightFroxelIndex(pixel, node, number + 3)];
  return before;
}

// What translucent casters leave; w: 1 where no opaque one blocks the light. A thickness far below
// 0 has overrun, beyond 2048.
vec4 getPassing(Arriving arriving)
{
  vec3 passing = exp(-vec3(max(arriving.thickness, ivec3(0))) / 1048576.0);
  passing = mix(passing, vec3(0.0), lessThan(arriving.thickness, ivec3(-(1 << 26))));
  return vec4(passing, arriving.blocks > 0 ? 0.0 : 1.0);
}

// The mean of exp(-t) between two values of t with these exponentials.
vec3 getMean(vec3 a, vec3 b)
{
  vec3 ratio = max(a, vec3(1e-30)) / max(b, vec3(1e-30));
  bvec3 equal = lessThan(abs(ratio - 1.0), vec3(1e-2));
  return mix((a - b) / log(mix(ratio, vec3(2.0), equal)), 0.5 * (a + b), equal);
}

void setNumber(ivec2 pixel, int node, int number, float value)
{
  froxelNumbers[airlightFroxelIndex(pixel, node, number)] = floatBitsToInt(value);
}

void addNumber(ivec2 pixel, int node, int number, float value)
{
  int index = airlightFroxelIndex(pixel, node, number);
  setNumber(pixel, node, number, intBitsToFloat(froxelNumbers[index]) + value);
}

// What arrives at a node, at this point. It takes the place of the sums that it follows from.
vec4 arriveAt(ivec2 pixel, int node, vec3 point, inout Arriving arriving)
{
  vec4 passing = vec4(1.0);
  if (airlightFroxelLight >= 0)
  {
    arriving = addBoundaries(arriving, pixel, node);
    passing = getPassing(arriving);
#ifdef AIRLIGHT_FROXEL_MAP
    passing.w *= airlightIsLit(point) ? 1.0 : 0.0;
#endif
    for (int i = 0; i < 4; i++)
    {
      setNumber(pixel, node, airlightFroxelLightNumber(airlightFroxelLight) + i, passing[i]);
    }
  }
  return passing;
}

// A channel that does not scatter is dark, whatever the limit of its integral.
bvec3 getScattering()
{
  vec3 sigmaS = vec3(0.0);
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    sigmaS += airlightMedia.item[i].sigmaS;
  }
  return greaterThan(sigmaS, vec3(0.0));
}

// What is scattered from node to node, into the ray so far.
struct Scattered
{
  vec3 radiance;
  vec3 loss;
  float variance;
};

void addPart(inout Scattered sum, vec3 part, vec4 passing, vec4 next)
{
  vec3 change = part * abs(next.w * next.rgb - passing.w * passing.rgb);
  float largest = max(change.r, max(change.g, change.b));
  sum.variance += largest * largest;
  part *= 0.5 * (passing.w + next.w);
  vec3 mean = getMean(passing.rgb, next.rgb);
  sum.radiance += part * mean;
  sum.loss += part * (1.0 - mean);
}

void setNode(ivec2 pixel, int node, Scattered sum)
{
  for (int i = 0; i < 3; i++)
  {
    addNumber(pixel, node, AIRLIGHT_FROXEL_RADIANCE + i, sum.radiance[i]);
#ifdef AIRLIGHT_FROXEL_TRANSMITS
    setNumber(pixel, node, AIRLIGHT_FROXEL_LOSS + i, sum.loss[i]);
#endif
  }
#ifdef AIRLIGHT_RECORD
  setNumber(pixel, node, AIRLIGHT_FROXEL_LOSS + 3, sum.variance);
#endif
}

void main()
{
  vec2 p = airlightPixel();
  ivec2 pixel = ivec2(p);
  float unit = airlightRayUnit(p);
  vec3 origin = airlightOrigin(p);
  vec3 direction = airlightDirection(p) / unit;
  AirlightRay ray = airlightRayBeside(light, origin, direction, AIRLIGHT_FAR,
    airlightLightMoment(lightPixel, light, p, unit, origin, direction));
  bvec3 scatters = getScattering();
  Arriving arriving = Arriving(startBlocks, startThickness);
  vec4 passing = getPassing(arriving);
  float from = ray.lit.x;
  vec3 tail = airlightTail3(light, ray, from);
  Scattered sum = Scattered(vec3(0.0), vec3(0.0), 0.0);
  for (int node = 0; node < airlightFroxelNodes; node++)
  {
    float to = clamp(unit * airlightFroxelDepth(node), from, max(from, ray.lit.y));
    vec4 next = arriveAt(pixel, node, ray.origin + to * ray.direction, arriving);
    vec3 part = vec3(0.0);
    if (to > from)
    {
      part = airlightRun3(light, ray, true, from, tail, to);
    }
    addPart(sum, mix(vec3(0.0), part, scatters), passing, next);
    setNode(pixel, node, sum);
    from = to;
    passing = next;
  }
}
