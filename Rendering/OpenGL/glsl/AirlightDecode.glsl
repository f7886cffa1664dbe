// Colours as VTK's mappers leave them.

// A light whose numbers are not finite makes VTK shade with NaN.
vec3 airlightFinite(vec3 colour)
{
  return min(mix(vec3(0.0), colour, equal(colour, colour)), vec3(1e30));
}

// Of those that VTK's physically based shading has encoded for display.

vec3 airlightDecode(vec3 colour)
{
  return pow(max(colour, vec3(0.0)), vec3(2.2));
}
