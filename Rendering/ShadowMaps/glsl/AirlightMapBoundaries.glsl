// The boundaries of a pixel from a shadow map, by its epipolar slices: the ray is lit in a column
// where its own value is not below the slice's. A first loop asks for each word of columns whether
// all of it or none is lit; a second one looks up the columns of the words that are neither.

uniform usampler2D slices;
uniform sampler2D sliceRanges; // least and most of each word of columns, two words a texel

// Columns at most.
const int AIRLIGHT_SLICE_WORDS = 32;
// Of a ray with no more boundaries, each is found within its column; where there are more, errors
// of either sign even out, and shadows that are thinner than a column are half of them missed.
const int AIRLIGHT_FEW_BOUNDARIES = 8;
const int AIRLIGHT_HALVINGS = 3;

struct AirlightSliceRay
{
  AirlightRay ray;
  int row;
  vec2 columns; // between which the ray is
  // Directional light: how far across it the ray starts, and goes a unit.
  float origin;
  float way;
  // The ray's scaled number is scale times what grows by perUnit from the border of column 0, or
  // for a light at a place the cosine of that.
  float start;
  float perUnit;
  float scale;
  bool point;
};

AirlightSliceRay sliceRay;
float sliceEnd;   // distance of the surface, below 0: none
bool sliceLit;    // what is before the next boundary
bool sliceFlips;  // whether the surface is not as the ray before it
float sliceError; // what may be wrong, as a share of the ray's airlight without shadows
#define AIRLIGHT_BOUNDARY_ERROR sliceError

// A bit for each column that is not as the one before it, of words that are lit in part. A bit for
// each of these words; a bit for each word that has such columns and is left; what is left of the
// one that is read, and its number.
uint sliceChanges[AIRLIGHT_SLICE_WORDS];
uint sliceParts;
uint sliceWords;
uint sliceChange;
int sliceWord;

int airlightBoundaryCount;
int airlightBoundaryWeights;
int sliceNumber;                         // of the next boundary
bool sliceIsFew;                         // there are so few of them
float sliceFew[AIRLIGHT_FEW_BOUNDARIES]; // then their distances

// Of the part of a ray from `from` on.
AirlightSliceRay airlightMakeSliceRay(AirlightRay ray, float from)
{
  AirlightSliceRay slice;
  slice.ray = ray;
  slice.point = mapKind != 3;
  vec3 side = airlightParallel != 0 && slice.point ? ray.origin - mapOrigin : ray.direction;
  vec2 across = vec2(dot(side, sliceAxes[0]), dot(side, sliceAxes[1]));
  // In any direction where the ray goes through the light.
  float place = sliceFan != 0 ? atan(across.y, across == vec2(0.0) ? 1.0 : across.x)
                              : dot(ray.origin, sliceAxes[1]);
  slice.row = int(floor((place - sliceRow.x) * sliceRow.y));
  slice.perUnit = 1.0;
  slice.origin = sliceFan != 0 ? 0.0 : dot(ray.origin, sliceAxes[0]);
  slice.way = length(across);
  float h = ray.foot.h;
  if (slice.point)
  {
    // Of the eye, as seen from the foot of the light.
    slice.start =
      airlightParallel != 0 ? -1.57079633 : -atan(ray.range.x + ray.foot.tL, h);
    slice.scale = sliceValue.x / max(h, 1e-30);
    slice.columns = vec2(atan(airlightFromFoot(ray, from), h),
                      atan(airlightFromFoot(ray, ray.lit.y), h)) - slice.start;
    slice.start += sliceColumn.x;
  }
  else
  {
    float along = dot(ray.direction, sliceAxes[2]);
    slice.scale = 1.0;
    slice.columns = slice.origin + slice.way * vec2(from, ray.lit.y);
    slice.perUnit = sliceValue.x * (-along / max(slice.way, 1e-30));
    slice.start = sliceValue.y + sliceValue.x * dot(mapOrigin - ray.origin, sliceAxes[2]) +
      (sliceColumn.x - slice.origin) * slice.perUnit;
    slice.row = slice.way > 0.0 ? slice.row : -1;
  }
  slice.columns = (slice.columns - sliceColumn.x) * sliceColumn.y;
  return slice;
}

// What four columns, and the four before them, add to the border that they begin at: by cosines and
// sines for a light at a place.
struct AirlightSliceSteps
{
  vec4 after;
  vec4 before;
  vec4 cosAfter;
  vec4 sinAfter;
  vec4 cosBefore;
  vec4 sinBefore;
  float twice; // what the values of columns times this less those before are the next
};

AirlightSliceSteps airlightSliceSteps(AirlightSliceRay slice)
{
  AirlightSliceSteps steps;
  float column = slice.perUnit / sliceColumn.y;
  steps.after = column * vec4(0.5, 1.5, 2.5, 3.5);
  steps.before = column * vec4(-3.5, -2.5, -1.5, -0.5);
  steps.cosAfter = cos(steps.after);
  steps.sinAfter = sin(steps.after);
  steps.cosBefore = cos(steps.before);
  steps.sinBefore = sin(steps.before);
  steps.twice = slice.point ? 2.0 * cos(4.0 * column) : 2.0;
  return steps;
}

// Whether light reaches four columns, the first of which has this bit.
uint airlightReaches(vec4 value, uvec4 columns, uint first)
{
  vec4 least = airlightUnpackSlice(columns);
  value = max(value, vec4(1.0)); // where nothing is in the way
  // Constants to choose from: shifts of a truth value take longer.
  return (value.x >= least.x ? first : 0u) | (value.y >= least.y ? first << 1u : 0u) |
    (value.z >= least.z ? first << 2u : 0u) | (value.w >= least.w ? first << 3u : 0u);
}

// Whether light reaches the columns of a word: a bit each.
uint airlightSliceBits(AirlightSliceRay slice, AirlightSliceSteps steps, int word)
{
  float u = slice.start + float(AIRLIGHT_SLICE_WORD * word) / sliceColumn.y * slice.perUnit;
  float c = slice.scale * cos(u);
  float s = slice.scale * sin(u);
  vec4 before = slice.point ? c * steps.cosBefore - s * steps.sinBefore : u + steps.before;
  vec4 value = slice.point ? c * steps.cosAfter - s * steps.sinAfter : u + steps.after;
  uint bits = 0u;
  const int texels = AIRLIGHT_SLICE_WORD / AIRLIGHT_SLICE_TEXEL;
  for (int i = 0; i < texels; i++)
  {
    uvec4 columns = texelFetch(slices, ivec2(texels * word + i, slice.row), 0);
    uint first = 1u << uint(AIRLIGHT_SLICE_TEXEL * i);
    vec4 next = steps.twice * value - before;
    bits |= airlightReaches(value, columns & 0xffffu, first) |
      airlightReaches(next, columns >> 16u, first << 4u);
    before = next;
    value = steps.twice * next - value;
  }
  return bits;
}

// Whether light reaches each of the words between two: a bit each.
struct AirlightSliceWords
{
  uint lit;   // all of it
  uint parts; // or only a part, perhaps
};

AirlightSliceWords airlightSliceWords(AirlightSliceRay slice, ivec2 words)
{
  float column = slice.perUnit / sliceColumn.y;
  float width = float(AIRLIGHT_SLICE_WORD) * column; // of a word
  ivec2 pairs = words / 2;
  float start = slice.start + column * (float(2 * AIRLIGHT_SLICE_WORD * pairs.x) + 0.5);
  // Middles of the first column of both words, and of the last ones.
  vec4 ends = vec4(0.0, width, width - column, 2.0 * width - column);
  vec4 cosEnds = cos(ends);
  vec4 sinEnds = sin(ends);
  vec2 turn = vec2(cos(2.0 * width), sin(2.0 * width));
  vec2 at = slice.scale * vec2(cos(start), sin(start));
  // Roundings of this and of airlightSliceBits().
  float slack = slice.point ? 1e-4 * slice.scale
                            : 1e-5 * (abs(start) + float(AIRLIGHT_SLICE_WORDS) * abs(width));
  AirlightSliceWords result = AirlightSliceWords(0u, 0u);
  for (int pair = pairs.x; pair <= pairs.y; pair++)
  {
    vec4 u = start + 2.0 * width * float(pair - pairs.x) + ends;
    vec4 values = slice.point ? at.x * cosEnds - at.y * sinEnds : u;
    vec2 least = min(values.xy, values.zw);
    vec2 most = max(values.xy, values.zw);
    // Few columns are so wide that a word goes through the lowest value, too.
    least.x = slice.point && u.z > 3.14159 ? -slice.scale : least.x;
    least.y = slice.point && u.w > 3.14159 ? -slice.scale : least.y;
    least = max(least - slack, vec2(1.0)); // where nothing is in the way
    most.x = slice.point && u.x * u.z < 0.0 ? slice.scale : most.x;
    most.y = slice.point && u.y * u.w < 0.0 ? slice.scale : most.y;
    most = max(most + slack, vec2(1.0));
    vec4 ranges = texelFetch(sliceRanges, ivec2(pair, slice.row), 0);
    uint bit = 1u << uint(2 * pair);
    result.lit |= (least.x >= ranges.y ? bit : 0u) | (least.y >= ranges.w ? bit << 1u : 0u);
    result.parts |= (least.x < ranges.y && most.x >= ranges.x ? bit : 0u) |
      (least.y < ranges.w && most.y >= ranges.z ? bit << 1u : 0u);
    at = vec2(at.x * turn.x - at.y * turn.y, at.y * turn.x + at.x * turn.y);
  }
  uint within = 0xffffffffu << uint(words.x) & 0xffffffffu >> uint(31 - words.y);
  result.lit &= within;
  result.parts &= within;
  return result;
}

// Finds and counts all changes between two columns, and whether the first one is lit.
void airlightMarchSlice(ivec2 ends)
{
  ivec2 words = ends / AIRLIGHT_SLICE_WORD;
  ivec2 bit = ends % AIRLIGHT_SLICE_WORD;
  AirlightSliceWords seen = airlightSliceWords(sliceRay, words);
  AirlightSliceSteps steps = airlightSliceSteps(sliceRay);
  uint lasts = seen.lit; // whether the last column of each word is lit
  sliceLit = (lasts >> uint(words.x) & 1u) != 0u;
  sliceParts = seen.parts;
  for (uint left = sliceParts; left != 0u; left &= left - 1u)
  {
    int word = findLSB(left);
    uint bits = airlightSliceBits(sliceRay, steps, word);
    bool first = word == words.x;
    sliceLit = first ? (bits >> uint(bit.x) & 1u) != 0u : sliceLit;
    uint before = lasts << 1u >> uint(word) & 1u;
    uint changes = bits ^ (bits << 1u | before);
    changes &= first ? 0xfffffffeu << uint(bit.x) : 0xffffffffu;
    changes &= word == words.y ? 0xffffffffu >> uint(31 - bit.y) : 0xffffffffu;
    sliceChanges[word] = changes;
    airlightBoundaryCount += bitCount(changes);
    sliceWords |= changes != 0u ? 1u << uint(word) : 0u;
    lasts |= bits >> 31u << uint(word);
  }
  // Other words change where they begin, if at all.
  uint later = 0xfffffffeu << uint(words.x) & 0xffffffffu >> uint(31 - words.y);
  uint starts = (lasts ^ lasts << 1u) & later & ~sliceParts;
  airlightBoundaryCount += bitCount(starts);
  sliceWords |= starts;
}

// The distance of a place in columns.
float airlightSliceDistance(float column)
{
  float u = column / sliceColumn.y;
  if (sliceRay.point)
  {
    float angle = clamp(sliceRay.start + u, -1.5707, 1.5707);
    return sliceRay.ray.range.x + sliceRay.ray.foot.tL + sliceRay.ray.foot.h * tan(angle);
  }
  return (sliceColumn.x + u - sliceRay.origin) / sliceRay.way;
}

// The next column that is not as the one before; -1 if there is none.
int airlightSliceNext()
{
  bool read = sliceChange == 0u && sliceWords != 0u;
  sliceWord = read ? findLSB(sliceWords) : sliceWord;
  sliceWords &= read ? sliceWords - 1u : 0xffffffffu;
  bool isPart = (sliceParts >> uint(sliceWord) & 1u) != 0u;
  sliceChange = read ? (isPart ? sliceChanges[sliceWord] : 1u) : sliceChange;
  int column = sliceChange != 0u ? AIRLIGHT_SLICE_WORD * sliceWord + findLSB(sliceChange) : -1;
  sliceChange &= sliceChange - 1u;
  return column;
}

// Finds the boundary between the middles of a column and of the one before it in the map.
float airlightRefine(int column, bool before)
{
  float a = airlightSliceDistance(float(column) - 0.5);
  float b = airlightSliceDistance(float(column) + 0.5);
  for (int i = 0; i < AIRLIGHT_HALVINGS; i++)
  {
    float middle = 0.5 * (a + b);
    bool same = airlightIsLit(sliceRay.ray.origin + middle * sliceRay.ray.direction) == before;
    a = same ? middle : a;
    b = same ? b : middle;
  }
  return 0.5 * (a + b);
}

void airlightRefineFew(int count)
{
  uint words = sliceWords;
  bool before = sliceLit;
  for (int i = 0; i < count; i++)
  {
    sliceFew[i] = airlightRefine(airlightSliceNext(), before);
    before = !before;
  }
  sliceWords = words;
  sliceChange = 0u;
}

// What may be wrong, as a share of the ray's airlight: about a column for each boundary and one for
// the start, of either sign. The first column has the largest share, as the light fades.
float airlightSliceError(AirlightRay ray, float from, float passed)
{
  float x = airlightFromFoot(ray, from);
  float h = max(ray.foot.h, 1e-30);
  float first =
    (sliceRay.point ? h + x * x / h : 1.0 / max(sliceRay.way, 1e-30)) / sliceColumn.y;
  float share = 1.0 / passed;
  for (int i = 0; i < AIRLIGHT_MEDIUM_COUNT; i++)
  {
    vec3 sigmaT = airlightMedia.item[i].sigmaT;
    share = max(share, first * max(sigmaT.x, max(sigmaT.y, sigmaT.z)));
  }
  return min(2.0 * sqrt(float(airlightBoundaryCount + 1)) * share, 1.0);
}

bool airlightOpenBoundaries(ivec2 pixel, float unit, float surface)
{
  sliceEnd = unit * surface;
  return true;
}

void airlightBeginBoundaries(AirlightRay ray, inout float from, inout int shadows)
{
  sliceLit = true;
  sliceParts = 0u;
  sliceWords = 0u;
  sliceChange = 0u;
  sliceWord = 0;
  sliceError = 0.0;
  airlightBoundaryCount = 0;
  sliceRay = airlightMakeSliceRay(ray, from);
  bool surface = mapKind != 0 && sliceEnd >= 0.0;
  bool surfaceLit =
    !surface || airlightIsSurfaceLit(ray.origin + sliceEnd * ray.direction);
  vec2 ends = vec2(ceil(sliceRay.columns.x - 0.5), floor(sliceRay.columns.y - 0.5));
  bool within = ends.x > ends.y; // one column
  ends = within ? vec2(floor(0.5 * (sliceRay.columns.x + sliceRay.columns.y))) : ends;
  if (mapKind != 0 && sliceRay.row >= 0 && sliceRay.row < sliceSize.y)
  {
    ends = clamp(ends, vec2(0.0), vec2(sliceSize.x - 1));
    airlightMarchSlice(ivec2(ends));
    sliceError = airlightSliceError(ray, from, ends.y - ends.x + 1.0);
  }
  // What is as long as a column or shorter is as the surface at its end; so are all rays of a light
  // that shines along a parallel view.
  bool reaches = sliceEnd <= 1.0001 * ray.lit.y;
  sliceLit = sliceSize.y == 0 || (within && surface && reaches) ? surfaceLit : sliceLit;
  sliceNumber = 0;
  sliceIsFew = airlightBoundaryCount <= AIRLIGHT_FEW_BOUNDARIES;
  airlightRefineFew(sliceIsFew ? airlightBoundaryCount : 0);
  bool endsLit = sliceLit == (airlightBoundaryCount % 2 == 0);
  sliceFlips = surface && surfaceLit != endsLit;
  airlightBoundaryCount += sliceFlips ? 1 : 0;
  shadows = sliceLit ? 0 : 1;
  airlightBoundaryWeights = airlightBoundaryCount % 2 == 0 ? 0 : 1 - 2 * shadows;
}

int airlightNextBoundary(out float t, out int weight)
{
  weight = sliceLit ? 1 : -1;
  int column = airlightSliceNext();
  bool more = column >= 0;
  t = sliceIsFew ? sliceFew[min(sliceNumber, AIRLIGHT_FEW_BOUNDARIES - 1)]
                 : airlightSliceDistance(float(column));
  t = more ? t : sliceEnd;
  sliceNumber++;
  bool flips = sliceFlips;
  sliceFlips = sliceFlips && more;
  more = more || flips;
  sliceLit = more ? !sliceLit : sliceLit;
  return more ? AIRLIGHT_MORE : AIRLIGHT_END;
}

void airlightCloseBoundaries(ivec2 pixel, int state, float from, int shadows) {}
