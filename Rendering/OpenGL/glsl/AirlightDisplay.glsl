// Colours as they are encoded for display, by VTK's physically based shading and by tone mapping.

vec3 airlightDecode(vec3 colour)
{
  return pow(max(colour, vec3(0.0)), vec3(2.2));
}

// Of a colour, or where it is to be blended of a colour times its opacity. VTK's backgrounds have
// no opacity, and are not blended.
vec4 airlightEncode(vec4 colour, bool blended)
{
  float opacity = blended ? max(colour.a, 1e-6) : 1.0;
  vec3 straight = max(colour.rgb, vec3(0.0)) / opacity;
  return vec4(pow(straight, vec3(1.0 / 2.2)) * opacity, colour.a);
}
