// The words that let one text be GLSL and, through GLM, C++ (see AirlightMath.h for its C++ side).
#define real float
#define real2 vec2
#define real3 vec3
#define real4 vec4
#define bool3 bvec3
#define int3 ivec3
#define real3x3 mat3
#define real4x4 mat4
#define AIRLIGHT_FN
#define AIRLIGHT_OUT(T) out T
#define AIRLIGHT_INOUT(T) inout T
#define AIRLIGHT_IN(T) T
// The media are a uniform: a parameter would be a copy in each function, which some compilers keep.
// Programs that know parts of them better have a variable beside it.
#ifdef AIRLIGHT_OWN_MEDIA
#define AIRLIGHT_MEDIA_UNIFORM uniform AirlightMedia givenMedia; AirlightMedia airlightMedia;
#else
#define AIRLIGHT_MEDIA_UNIFORM uniform AirlightMedia airlightMedia;
#endif
#define AIRLIGHT_MEDIA_IN
#define AIRLIGHT_MEDIA_OUT
// Multiple scattering is a uniform of its own.
#define AIRLIGHT_MULTIPLE_MEMBER
#define AIRLIGHT_MULTIPLE_UNIFORM uniform AirlightMultiple airlightMultiple;
#define AIRLIGHT_MULTIPLE_IN
#define AIRLIGHT_MULTIPLE_OUT
// The bound of a loop that compilers do not unroll, as they do not know that 0 is added. Each round
// would have a copy of all that it calls, and a program take some of them half a minute.
uniform int airlightZero;
#define AIRLIGHT_ROLLED(count) ((count) + airlightZero)
// Forbids optimisations that change roundings. Below GLSL 4.00 an extension has the word, which the
// first lines of all shaders enable where there is one.
#if __VERSION__ >= 400 || defined(GL_ARB_gpu_shader5)
#define AIRLIGHT_PRECISE precise
#else
#define AIRLIGHT_PRECISE
#endif
// Whether medium i is inside a closed surface.
#define AIRLIGHT_IS_SURFACE(i)                                                                     \
  (AIRLIGHT_ALL_SURFACES == 1 || ((AIRLIGHT_SURFACE_MEDIA >> (i)) & 1) != 0)
// Images of density, see AirlightGrid.glsl.
#if AIRLIGHT_HAS_GRID
#define AIRLIGHT_GRID_STEPS
#define AIRLIGHT_GRID_MEMBER AirlightGrid grid;                                                    \
  int albedoFirst;                                                                                 \
  int glowFirst;
#define AIRLIGHT_LIGHT_GRID_MEMBERS                                                                \
  int gridFirst[AIRLIGHT_MAX_MEDIA];                                                               \
  real3 gridSize[AIRLIGHT_MAX_MEDIA];                                                              \
  real4x4 gridCells[AIRLIGHT_MAX_MEDIA];
// Whether medium i has an image: so it is known when a shader is compiled.
#define AIRLIGHT_IS_GRID(i) (((AIRLIGHT_GRID_MEDIA >> (i)) & 1) != 0)
// Likewise whether it has arrays of colours there.
#define AIRLIGHT_HAS_ALBEDO(i) (((AIRLIGHT_ALBEDO_MEDIA >> (i)) & 1) != 0)
#define AIRLIGHT_HAS_GLOW(i) (((AIRLIGHT_GLOW_MEDIA >> (i)) & 1) != 0)
#define AIRLIGHT_HAS_COLOURS(medium) ((AIRLIGHT_ALBEDO_MEDIA | AIRLIGHT_GLOW_MEDIA) != 0)
// Where samples are: their first texel.
#define AIRLIGHT_SAMPLES int
#define AIRLIGHT_LAYER airlightLayer
#define AIRLIGHT_IS_EMPTY_BLOCK airlightIsEmptyBlock
#define AIRLIGHT_GRID_DENSITY(medium, point) airlightGridDensity((medium).grid, point)
#define AIRLIGHT_GRID_DEPTH(medium, o, d, from, to) airlightGridDepth((medium).grid, o, d, from, to)
#else
#define AIRLIGHT_GRID_MEMBER
#define AIRLIGHT_LIGHT_GRID_MEMBERS
#endif
// Ambient light that differs by direction, see AirlightSky.glsl.
#ifdef AIRLIGHT_HAS_SKY
#define AIRLIGHT_SKY_MEMBER AirlightSky sky;
#else
#define AIRLIGHT_SKY_MEMBER
#endif
// Triangles, tables: what does not fit into uniforms.
#define AIRLIGHT_DATA_MEMBER
#define AIRLIGHT_FETCH(owner, i) texelFetch(airlightData, i)
#if AIRLIGHT_HAS_DATA
uniform samplerBuffer airlightData;
#endif
#if AIRLIGHT_HAS_GRID
#if AIRLIGHT_SAMPLE_BITS < 32
// The same numbers as whole ones of so many bits: the samples of images, as shares of the largest.
uniform samplerBuffer airlightSamples;
#define AIRLIGHT_SAMPLE(i)                                                                         \
  (texelFetch(airlightSamples, i) * real((1 << AIRLIGHT_SAMPLE_BITS) - 1))
#else
#define AIRLIGHT_SAMPLE(i) texelFetch(airlightData, i)
#endif

// Before an image's samples are texels of its blocks, the first one last.
bool airlightIsEmptyBlock(int first, int block)
{
  return AIRLIGHT_SAMPLE(first - 1 - block).x == 0.0;
}

// Where the samples at the corners of a cell in one layer are; `size`: the image's number of cells.
// Texels are as AirlightPackedSamples.h says: three cells in each along x.
struct AirlightLayerPlace
{
  int texel; // the cell's first row; the second one is so many further on
  int row;
  int place; // in the texel
};

AirlightLayerPlace airlightLayerPlace(int3 size, int3 cell)
{
  const float third = 0.33333334; // rounded up, so that no integer becomes a smaller one
  int texels = int(float(size.x + 2) * third); // of a row
  int column = int(float(cell.x) * third);
  return AirlightLayerPlace(
    column + texels * (cell.y + (size.y + 1) * cell.z), texels, cell.x - 3 * column);
}

real4 airlightTakeLayer(real4 a, real4 b, int place)
{
  return place == 0 ? real4(a.xy, b.xy) : place == 1 ? real4(a.yz, b.yz) : real4(a.zw, b.zw);
}

real4 airlightLayer(int first, int3 size, int3 cell)
{
  AirlightLayerPlace at = airlightLayerPlace(size, cell);
  return airlightTakeLayer(AIRLIGHT_SAMPLE(first + at.texel),
    AIRLIGHT_SAMPLE(first + at.texel + at.row), at.place);
}

// The same of numbers that are no samples of an image.
real4 airlightDataLayer(int first, int3 size, int3 cell)
{
  AirlightLayerPlace at = airlightLayerPlace(size, cell);
  return airlightTakeLayer(texelFetch(airlightData, first + at.texel),
    texelFetch(airlightData, first + at.texel + at.row), at.place);
}
#endif
