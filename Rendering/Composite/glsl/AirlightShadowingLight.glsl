// The one light that casts shadows on surfaces: what they are without it, and whether it reaches
// them.

uniform sampler2D withoutLight; // the scene
#if AIRLIGHT_SHADOWING_LIGHT >= AIRLIGHT_BITS
uniform sampler2D lit; // bits of the lights for which `bits` has no more room
#endif

bool airlightIsLit(ivec2 pixel, float bits)
{
#if AIRLIGHT_SHADOWING_LIGHT >= AIRLIGHT_BITS
  bits = texelFetch(lit, pixel, 0)[AIRLIGHT_SHADOWING_LIGHT / AIRLIGHT_BITS - 1];
#endif
  return ((uint(bits) >> uint(AIRLIGHT_SHADOWING_LIGHT % AIRLIGHT_BITS)) & 1u) != 0u;
}

vec4 airlightInShadow(ivec2 pixel, float bits, vec4 colour)
{
  return airlightIsLit(pixel, bits) ? colour : texelFetch(withoutLight, pixel, 0);
}
