// One light's airlight before the nodes of a froxel grid's rays. What arrives of the light at the
// nodes follows from the sums of the boundaries between them. From node to node the boundaries are
// taken to be spread evenly.

uniform AirlightMedia media;
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

// What translucent casters leave; w: 1 where no opaque one blocks the light.
vec4 getPassing(Arriving arriving)
{
  return vec4(exp(-vec3(max(arriving.thickness, ivec3(0))) / 1048576.0),
    arriving.blocks > 0 ? 0.0 : 1.0);
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

void addRadiance(ivec2 pixel, int node, vec3 radiance)
{
  for (int i = 0; i < 3; i++)
  {
    int index = airlightFroxelIndex(pixel, node, AIRLIGHT_FROXEL_RADIANCE + i);
    froxelNumbers[index] =
      floatBitsToInt(intBitsToFloat(froxelNumbers[index]) + radiance[i]);
  }
}

void main()
{
  vec2 p = airlightPixel();
  ivec2 pixel = ivec2(p);
  float unit = airlightRayUnit(p);
  vec3 origin = airlightOrigin(p);
  vec3 direction = airlightDirection(p) / unit;
  AirlightRay ray = airlightRayBeside(media, light, origin, direction, AIRLIGHT_FAR,
    airlightLightMoment(lightPixel, light, p, unit, origin, direction));
  Arriving arriving = Arriving(startBlocks, startThickness);
  vec4 passing = getPassing(arriving);
  vec3 tail = airlightTail3(media, light, ray, ray.lit.x);
  float from = ray.lit.x;
  vec3 radiance = vec3(0.0);
  vec3 loss = vec3(0.0);
  float variance = 0.0;
  for (int node = 0; node < airlightFroxelNodes; node++)
  {
    float to = clamp(unit * airlightFroxelDepth(node), from, ray.lit.y);
    vec4 next = vec4(1.0);
    if (airlightFroxelLight >= 0)
    {
      arriving = addBoundaries(arriving, pixel, node);
      next = getPassing(arriving);
#ifdef AIRLIGHT_FROXEL_MAP
      next.w *= airlightIsLit(ray.origin + to * ray.direction) ? 1.0 : 0.0;
#endif
      for (int i = 0; i < 4; i++)
      {
        setNumber(pixel, node, airlightFroxelLightNumber(airlightFroxelLight) + i, next[i]);
      }
    }
    vec3 toTail = airlightTail3(media, light, ray, to);
    vec3 part =
      to > from ? airlightInterval3(media, light, ray, from, tail, to, toTail) : vec3(0.0);
    vec3 change = part * abs(next.w * next.rgb - passing.w * passing.rgb);
    float largest = max(change.r, max(change.g, change.b));
    variance += largest * largest;
    part *= 0.5 * (passing.w + next.w);
    vec3 mean = getMean(passing.rgb, next.rgb);
    radiance += part * mean;
    loss += part * (1.0 - mean);
    addRadiance(pixel, node, radiance);
    for (int i = 0; i < 3; i++)
    {
      setNumber(pixel, node, AIRLIGHT_FROXEL_LOSS + i, loss[i]);
    }
    setNumber(pixel, node, AIRLIGHT_FROXEL_LOSS + 3, variance);
    from = to;
    tail = toTail;
    passing = next;
  }
}
