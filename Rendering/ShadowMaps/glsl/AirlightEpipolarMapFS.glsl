// Draws a shadow map's epipolar slices (AirlightSliceLayout.glsl), after AirlightMapLookup.glsl.

layout(location = 0) out uvec4 sliceColumns;

// The value of row a, which is a direction or a place, and of column u, an angle with this cosine
// and sine; far below 0 if nothing is in the light's way.
float getValue(float a, vec3 across, float u, vec2 turned)
{
  vec3 point = mapKind == 3
    ? (sliceFan != 0 ? u * across : a * sliceAxes[1] + u * sliceAxes[0]) - mapOrigin
    : turned.x * sliceAxes[2] + turned.y * across;
  AirlightMapPosition position = airlightMapPosition(point);
  ivec2 texel = clamp(ivec2(floor(position.texel)), ivec2(0), ivec2(mapResolution - 1));
  float way = position.inside ? texelFetch(shadowMap, position.face + texel, 0).r : 1e30;
  way += mapSlack + mapRelativeSlack * abs(way);
  return mapKind == 3 ? -way : way >= 1e29 ? -1e30 : 1.0 / way;
}

// Rays are up to half a row away: what a slanted face is nearer to the light there is not its
// shadow. What rises more is another face.
vec4 getLeast(vec4 values)
{
  vec4 rise = abs(dFdy(values));
  vec4 most = mapKind == 3 ? vec4(0.1 * length(1.0 / mapScale)) : 0.1 * abs(values);
  return values - 0.5 * mix(vec4(0.0), rise, lessThan(rise, most));
}

// The bits of four columns from one on.
uvec4 getColumns(float a, vec3 across, float first)
{
  float u = sliceColumn.x + (first + 0.5) / sliceColumn.y;
  float column = 1.0 / sliceColumn.y;
  vec2 turned = vec2(cos(u), sin(u));
  vec2 turn = vec2(cos(column), sin(column));
  vec4 values;
  for (int i = 0; i < 4; i++)
  {
    values[i] = getValue(a, across, u, turned);
    u += column;
    turned = vec2(
      turned.x * turn.x - turned.y * turn.y, turned.y * turn.x + turned.x * turn.y);
  }
  return airlightPackSlice(getLeast(values));
}

void main()
{
  vec2 p = gl_FragCoord.xy;
  float a = sliceRow.x + p.y / sliceRow.y;
  vec3 across = cos(a) * sliceAxes[0] + sin(a) * sliceAxes[1];
  float first = float(AIRLIGHT_SLICE_TEXEL) * floor(p.x);
  sliceColumns = getColumns(a, across, first) | getColumns(a, across, first + 4.0) << 16u;
}
