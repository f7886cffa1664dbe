// A shadow map along view rays: each row is the plane of a ray and the light, an epipolar slice, so
// that a ray is a part of one row. After Baran, Chen, Ragan-Kelley, Durand and Lehtinen, "A
// Hierarchical Volumetric Shadow Algorithm for Single Scattering" (SIGGRAPH Asia 2010), and Chen,
// Baran, Durand and Jarosz, "Real-Time Volumetric Shadows using 1D Min-Max Mipmaps" (I3D 2011).
//
// A light at a place: the pole is the direction from the light to the eye, or against a parallel
// view. A row is an angle around the pole, a column an angle from it, as seen from the light.
// A directional light: a point's place across the light. In perspective, a row is an angle around
// the eye, a column a distance from it; in a parallel view both are lengths.
//
// A column holds how far the light goes there, as a value: for a light at a place the reciprocal of
// the distance, for a directional light the distance below 0. It is scaled to a number above 1, of
// which 16 bits are kept; they are 0 where nothing is in the light's way. A texel has eight
// columns, the first four in the lower halves of its numbers, since four are compared at once: to
// read texels takes most of the time of following a ray.

// Columns of a word, whose least and most value are known (EpipolarSlices::Word): a bit each.
const int AIRLIGHT_SLICE_WORD = 32;

uniform vec3 sliceAxes[3]; // two across the pole or the light, and it
uniform vec2 sliceRow;     // the first row's border, rows per unit
uniform vec2 sliceColumn;  // the same of columns
uniform ivec2 sliceSize;   // columns, rows; no rows: the slices are of no use
uniform int sliceFan;      // 1: rows are angles
uniform vec2 sliceValue;   // factor and summand of the scaled number
uniform int sliceShift;    // bits of its float below those that are kept

const int AIRLIGHT_SLICE_TEXEL = 8;          // columns (EpipolarSlices::ColumnsPerTexel)
const uint AIRLIGHT_SLICE_ONE = 0x3f800000u; // the bits of 1.0

uvec4 airlightPackSlice(vec4 values)
{
  uvec4 bits = floatBitsToUint(max(sliceValue.x * values + sliceValue.y, vec4(1.0)));
  bits = clamp((bits - AIRLIGHT_SLICE_ONE) >> uint(sliceShift), uvec4(1u), uvec4(0xffffu));
  return bits * uvec4(greaterThan(values, vec4(-1e29)));
}

// The scaled number, or a little less: what is lit before a surface stays lit.
vec4 airlightUnpackSlice(uvec4 bits)
{
  return uintBitsToFloat((bits << uint(sliceShift)) + AIRLIGHT_SLICE_ONE);
}
