// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * An opaque actor whose mapper draws something else than its input's polygons: point Gaussians,
 * imposters, glyphs that GetGlyphs() does not know.
 */

#ifndef AirlightNonPolygonalCaster_h
#define AirlightNonPolygonalCaster_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkMatrix4x4.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

class vtkActor;
class vtkProp;

namespace airlight
{
struct VTKAIRLIGHT_EXPORT NonPolygonalCaster
{
  NonPolygonalCaster(vtkActor* actor, vtkProp* owner, vtkMatrix4x4* toWorld);

  // The corners of its box in the world; empty if it has none.
  std::vector<glm::dvec3> GetCorners() const;

  // Whether it certainly draws the same, seen from the same place, as the other did.
  bool DrawsAs(const NonPolygonalCaster& other) const;

  vtkActor* Actor;
  vtkProp* Owner;                            // in the renderer: the actor, or what it is a part of
  vtkSmartPointer<vtkMatrix4x4> PartToWorld; // of a part, to the world; else null
  glm::dmat4 ToWorld;
  // When what it draws was modified: mapper, input, properties, texture. All 0: nobody knows.
  std::array<vtkMTimeType, 6> Times;
};
}

#endif
