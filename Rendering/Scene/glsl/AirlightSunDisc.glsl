// Suns that are seen as discs: see SunDisc.

uniform vec4 airlightSunTowards[AIRLIGHT_SUNS]; // and the square of the chord to the border
uniform vec3 airlightSunRadiance[AIRLIGHT_SUNS];

// What comes from the sky along the ray, with an alpha of 1 where that is a sun's disc. A chord
// resolves small angles, of which single precision would lose the cosine.
vec4 airlightSunDiscs(vec3 direction)
{
  vec4 sky = vec4(0.0);
  for (int k = 0; k < AIRLIGHT_SUNS; ++k)
  {
    vec3 chord = direction - airlightSunTowards[k].xyz;
    sky += dot(chord, chord) < airlightSunTowards[k].w ? vec4(airlightSunRadiance[k], 1.0)
                                                       : vec4(0.0);
  }
  return vec4(sky.rgb, min(sky.a, 1.0));
}
