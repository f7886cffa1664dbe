// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Flat faces that hide much of what lies behind them from the eye: a floor, a wall. Shadow planes
 * that go through one of them need not be drawn beyond it.
 *
 * Not installed; exported for the module's own tests.
 */

#ifndef AirlightPlanarOccluders_h
#define AirlightPlanarOccluders_h

#include "Casters/AirlightCasters.h"
#include "vtkAirlightModule.h" // for export macro

#include <glm/glm.hpp>

#include <array>
#include <vector>

class vtkProp;

namespace airlight
{
class CameraRays;

// A point x from the eye is hidden by the face in all pixels of the view if it is
//
//   behind its plane, dot(Plane.xyz, x) + Plane.w < 0, and
//   between its sides, dot(side, x) >= 0 for each:
//
// planes through the eye and its edges, or the lines where the clipping planes cut the face off. In
// place of a side that the whole view is inside of, and of those that a triangle lacks, there is
// one that all behind the plane is inside of: pixels are not outside of it, though places beside
// the view are.
struct PlanarOccluder
{
  static constexpr size_t SideCount = 6;
  glm::dvec4 Plane;
  std::array<glm::dvec3, SideCount> Sides;
};

// The faces of these casters that hide most of the view, the most first, at most
// MostPlanarOccluders. A caster counts if its prop is among `solid`, in order: those whose
// triangles all are drawn by now, each fragment opaque. None in parallel projection: there what
// moves away behind a face leaves its outline.
constexpr size_t MostPlanarOccluders = 3;
VTKAIRLIGHT_EXPORT std::vector<PlanarOccluder> FindPlanarOccluders(
  const std::vector<Caster>& casters, const std::vector<vtkProp*>& solid, const CameraRays& rays);

// For each caster the plane of a face that hides all of its shadow planes from where they meet it,
// for a light at a homogeneous position in the world; 0 where there is none, and once more after
// the last. All planes of a caster end at the same face, so that they meet along their sides to the
// last bit.
VTKAIRLIGHT_EXPORT std::vector<glm::vec4> FindTruncationPlanes(const std::vector<Caster>& casters,
  const std::vector<PlanarOccluder>& faces, const glm::dvec4& light, const glm::dvec3& eye);
}

#endif
