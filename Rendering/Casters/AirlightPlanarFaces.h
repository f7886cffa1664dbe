// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The planar faces of meshes that have little else: floors, walls, boxes.
 *
 * Not installed; exported for the module's own tests.
 */

#ifndef AirlightPlanarFaces_h
#define AirlightPlanarFaces_h

#include "vtkAirlightModule.h" // for export macro

#include <glm/glm.hpp>

#include <vector>

namespace airlight
{
class CasterMesh;

// A convex face of three or four corners, one after the other around it, in the mesh's coordinates.
// However many triangles it is made of, they cover it, each place once, and nothing beside it.
using PlanarFace = std::vector<glm::dvec3>;

// Faces of other outlines, and those with holes, are left out. None where the triangles lie in more
// than six planes. Takes time in proportion to the mesh's triangles, of which it looks at few where
// it is curved.
VTKAIRLIGHT_EXPORT std::vector<PlanarFace> FindPlanarFaces(const CasterMesh& mesh);
}

#endif
