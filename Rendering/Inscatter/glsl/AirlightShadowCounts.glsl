// How casters stand between a light and the points of a ray. Where all of them are opaque, that is
// the number of shadow volumes around a point. If some let light through
// (AIRLIGHT_SHADOW_TRANSMITTANCE), it is
// for each channel the number of those that block it, and the optical thickness of the others in
// units of 2^-20. All integers: what a ray has left again is gone to the last bit.

#if AIRLIGHT_SHADOW_TRANSMITTANCE

struct AirlightCounts
{
  ivec3 blocks;
  ivec3 thickness;
};
#define AirlightPassing vec3

uniform ivec3 startBlocks;
uniform ivec3 startThickness;
uniform int transmittanceSlot; // place of this light's dimming on surfaces, -1: none is kept

// Where what passes changed last, of a ray that takes several draws.
float airlightRunStart = -1.0;

AirlightCounts airlightStartCounts()
{
  return AirlightCounts(startBlocks, startThickness);
}

AirlightCounts airlightNoCounts()
{
  return AirlightCounts(ivec3(0), ivec3(0));
}

AirlightCounts airlightAdd(AirlightCounts a, AirlightCounts b)
{
  return AirlightCounts(a.blocks + b.blocks, a.thickness + b.thickness);
}

// The share of the light that is left.
vec3 airlightPassing(AirlightCounts counts)
{
  // Where boundaries meet, rounding lets a ray leave a volume before it enters it; what is far
  // below 0 has overrun, beyond a thickness of 2048.
  bvec3 dark = bvec3(uvec3(greaterThan(counts.blocks, ivec3(0))) |
    uvec3(lessThan(counts.thickness, ivec3(-(1 << 26)))));
  vec3 passing = exp(-vec3(max(counts.thickness, ivec3(0))) / 1048576.0);
  passing = mix(passing, vec3(1.0), lessThanEqual(counts.thickness, ivec3(0)));
  return mix(passing, vec3(0.0), dark);
}

bool airlightPasses(vec3 passing)
{
  return any(greaterThan(passing, vec3(0.0)));
}

vec3 airlightApplyTransmittance(vec3 radiance, vec3 passing)
{
  return radiance * passing;
}

#else

#define AirlightCounts int
#define AirlightPassing bool

uniform int startCount; // shadow volumes that hold the ray's start

int airlightStartCounts()
{
  return startCount;
}

int airlightNoCounts()
{
  return 0;
}

int airlightAdd(int a, int b)
{
  return a + b;
}

bool airlightPassing(int count)
{
  return count <= 0;
}

bool airlightPasses(bool lit)
{
  return lit;
}

vec3 airlightApplyTransmittance(vec3 radiance, bool lit)
{
  return radiance;
}

#endif
