// What translucent casters leave of a light, kept for surfaces: 21 bits a channel in two words.

layout(std430, binding = AIRLIGHT_BINDING_SHADOW_TRANSMITTANCE) buffer AirlightShadowTransmittance
{
  uint shadowTransmittance[]; // by light, row and column
};
uniform ivec2 airlightTransmittanceSize; // of the viewport, pixels

uvec2 airlightPack(vec3 passing)
{
  uvec3 q = uvec3(clamp(passing, 0.0, 1.0) * 2097151.0 + 0.5);
  return uvec2(q.r | (q.g << 21), (q.g >> 11) | (q.b << 10));
}

vec3 airlightUnpack(uvec2 bits)
{
  uvec3 q = uvec3(
    bits.x & 0x1fffffu, (bits.x >> 21) | ((bits.y & 0x3ffu) << 11), bits.y >> 10);
  return vec3(q) / 2097151.0;
}

// The first of the two words; `slot` is the light's place.
uint airlightTransmittanceWord(int slot, ivec2 pixel)
{
  return 2u *
    uint((slot * airlightTransmittanceSize.y + pixel.y) * airlightTransmittanceSize.x + pixel.x);
}

uvec2 airlightSurfaceTransmittance(int slot, ivec2 pixel)
{
  uint word = airlightTransmittanceWord(slot, pixel);
  return uvec2(shadowTransmittance[word], shadowTransmittance[word + 1u]);
}

void airlightSetSurfaceTransmittance(int slot, ivec2 pixel, uvec2 bits)
{
  uint word = airlightTransmittanceWord(slot, pixel);
  shadowTransmittance[word] = bits.x;
  shadowTransmittance[word + 1u] = bits.y;
}
