// How a shadow technique gives the boundaries on a pixel's ray to an integrator. A boundary is
// (t, +-): at the distance t along the unit ray it enters a shadow volume, or leaves it, whose
// weight is added to the counts of AirlightShadowCounts.glsl. Each technique has a text with these
// functions. Integrators know nothing else of how boundaries are found or stored.
//
//   bool airlightOpenBoundaries(ivec2 pixel, float unit, float surface)
//     Comes first. False where the pixel is another draw's. The ray ends at `surface` on the unit
//     of airlightDirection(), which is `unit` long; below 0: nowhere.
//   void airlightBeginBoundaries(AirlightRay ray, inout float from, inout AirlightCounts shadows)
//     Comes next, with the start of what is to be integrated and the counts there. Changes them
//     if the technique knows better: where a draw before this one has come further, or a map shows
//     what the start is in.
//   int airlightNextBoundary(out float t, out AirlightCounts weight)
//     Then again and again: AIRLIGHT_MORE with a boundary, in order of t and up to the surface, or
//     one of the others without.
//   void airlightCloseBoundaries(ivec2 pixel, int state, float from, AirlightCounts shadows)
//     Comes last, with what airlightNextBoundary() returned, and after a pause from where on, with
//     which counts, the next draw goes on.
//
// Readers that count (LightShadow::CountsBoundaries()) know all boundaries when they have begun and
// never pause, so that they need no closing. They have the number of boundaries and the sum of
// their weights:
//
//   int airlightBoundaryCount
//   int airlightBoundaryWeights

const int AIRLIGHT_MORE = 0;  // a boundary
const int AIRLIGHT_PAUSE = 1; // the rest is the next draw's
const int AIRLIGHT_END = 2;   // none is left
