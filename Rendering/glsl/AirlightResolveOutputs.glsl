// What AirlightResolveFS.glsl and AirlightTurnedFS.glsl take and give.

uniform sampler2D distances;
uniform vec4 litBit; // what to add where the surface is lit
#ifdef AIRLIGHT_RECORD
uniform float phaseError; // of the medium's fitted phase function, relative
uniform float error;      // of the integration, of the ray's airlight without shadows
#endif

layout(location = 0) out vec4 airlight; // radiance; lit length
layout(location = 1) out vec4 lit;
#ifdef AIRLIGHT_RECORD
layout(location = 2) out vec4 counts; // boundaries; error bound
layout(location = 3) out vec4 single; // this light's own

float brightest(vec3 colour)
{
  return max(colour.r, max(colour.g, colour.b));
}
#endif
