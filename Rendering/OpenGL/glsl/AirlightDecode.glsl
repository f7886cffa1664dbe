// Colours that VTK's physically based shading has encoded for display.

vec3 airlightDecode(vec3 colour)
{
  return pow(max(colour, vec3(0.0)), vec3(2.2));
}
