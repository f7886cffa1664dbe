// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A point of a surface as VTK's mappers shade it: the material with the colours of scalars, and the
 * interpolated normal.
 */

#ifndef AirlightReferenceSurface_h
#define AirlightReferenceSurface_h

#include "Reference/AirlightReferenceScene.h"

#include <glm/glm.hpp>

namespace airlight
{
struct ReferenceSurface
{
  // Of the side that a ray of this direction meets; `position` in the world.
  ReferenceSurface(const ReferencePart& part, const OccluderTriangle& triangle,
    const glm::dvec3& position, const glm::dvec3& direction);

  // Of a Lambertian surface that looks alike: the diffuse colour, 1 at most.
  glm::dvec3 GetAlbedo() const { return glm::clamp(this->Material.Diffuse, 0.0, 1.0); }

  ReferenceMaterial Material;
  glm::dvec3 Normal; // unit, on the viewer's side unless the given normals are off; 0 without one
};
}

#endif
