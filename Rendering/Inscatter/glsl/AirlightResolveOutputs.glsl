// What AirlightResolveFS.glsl and AirlightEquiangularFS.glsl take and give.

uniform sampler2D distances;
uniform vec4 litBit; // what to add where the surface is lit
#ifdef AIRLIGHT_RECORD
uniform float phaseError; // of the medium's fitted phase function, relative
uniform float error;      // of the integration, of the ray's airlight without shadows
uniform float multipleError; // of what is scattered more than once, relative
#endif

// Of the nodes of multiple scattering, relative to all scattered light.
#define AIRLIGHT_NODES_ERROR 0.005

layout(location = 0) out vec4 airlight; // radiance; the bits of litBit's first channel
#ifdef AIRLIGHT_RECORD
layout(location = 1) out vec4 counts; // boundaries; error bound; lit length
layout(location = 2) out vec4 single; // this light's own
#if AIRLIGHT_MORE_LIT
layout(location = 3) out vec4 lit; // those of the other channels
#endif
#if AIRLIGHT_MULTIPLE && AIRLIGHT_MORE_LIT
layout(location = 4) out vec4 several; // what it scatters more than once
#elif AIRLIGHT_MULTIPLE
layout(location = 3) out vec4 several;
#endif
#elif AIRLIGHT_MORE_LIT
layout(location = 1) out vec4 lit;
#endif

void airlightGive(vec3 radiance, bool surfaceLit)
{
  vec4 bits = surfaceLit ? litBit : vec4(0.0);
  airlight = vec4(radiance, bits.x);
#if AIRLIGHT_MORE_LIT
  lit = vec4(bits.yzw, 0.0);
#endif
}

#ifdef AIRLIGHT_RECORD
float brightest(vec3 colour)
{
  return max(colour.r, max(colour.g, colour.b));
}

// What the light scatters once into the pixel's ray, and more than once; `whole`: the former, were
// there no shadows.
void airlightRecord(vec3 once, vec3 more, vec3 whole, int boundaries, float litLength)
{
  single = vec4(once, airlight.a);
#if AIRLIGHT_MULTIPLE
  several = vec4(more, 0.0);
#endif
  float ofWhole = error;
#if AIRLIGHT_MULTIPLE_LAMP >= 0
  ofWhole += AIRLIGHT_NODES_ERROR;
#endif
#ifdef AIRLIGHT_BOUNDARY_ERROR
  ofWhole += AIRLIGHT_BOUNDARY_ERROR;
#endif
  float bound =
    phaseError * brightest(once) + multipleError * brightest(more) + ofWhole * brightest(whole);
  counts = vec4(float(boundaries), bound, litLength, 0.0);
}
#endif
