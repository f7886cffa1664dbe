// A shadow map along view rays: each row is the plane of a ray and the light, an epipolar slice, so
// that a ray is a part of one row. After Baran, Chen, Ragan-Kelley, Durand and Lehtinen, "A
// Hierarchical Volumetric Shadow Algorithm for Single Scattering" (SIGGRAPH Asia 2010), and Chen,
// Baran, Durand and Jarosz, "Real-Time Volumetric Shadows using 1D Min-Max Mipmaps" (I3D 2011).
//
// A light at a place: the pole is the direction from the light to the eye, or against a parallel
// view. A row is an angle around the pole, a column an angle from it, as seen from the light.
// A directional light: a point's place across the light. In perspective, a row is an angle around
// the eye, a column a distance from it; in a parallel view both are lengths.

// Columns of a word, whose least and most value are known (EpipolarSlices::Word): a bit each.
const int AIRLIGHT_SLICE_WORD = 32;

uniform vec3 sliceAxes[3]; // two across the pole or the light, and it
uniform vec2 sliceRow;     // the first row's border, rows per unit
uniform vec2 sliceColumn;  // the same of columns
uniform ivec2 sliceSize;   // columns, rows; no rows: the slices are of no use
uniform int sliceFan;      // 1: rows are angles
