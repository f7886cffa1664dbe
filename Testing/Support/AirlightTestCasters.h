// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Casters in random places and what a camera sees of points of them.
 */

#ifndef AirlightTestCasters_h
#define AirlightTestCasters_h

#include "AirlightTestDirections.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkShaderProperty.h"

namespace airlight_test
{
// Three unit vectors at right angles.
inline glm::dmat3 RandomAxes(Random& random)
{
  const glm::dvec3 x = RandomUnit(random);
  const glm::dvec3 y = glm::normalize(glm::cross(x, RandomUnit(random)));
  return glm::dmat3(x, y, glm::cross(x, y));
}

// In clip coordinates by VTK's own matrix: in a perspective w is the depth. `aspect`: of the picture, width by
// height.
inline glm::dvec4 Project(vtkCamera* camera, double aspect, const glm::dvec3& point)
{
  const double in[4] = { point.x, point.y, point.z, 1.0 };
  glm::dvec4 clip;
  camera->GetCompositeProjectionTransformMatrix(aspect, -1, 1)->MultiplyPoint(in, &clip.x);
  return clip;
}

// Whether it is in the picture, in or outside of the clipping range. Behind the eye no ray of a perspective
// comes along.
inline bool IsInPicture(const glm::dvec4& clip)
{
  return clip.w > 0.0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
}

// A replacement that changes nothing in the actor's shader, of which the pass cannot know that.
inline void MakeUnknown(vtkActor* actor)
{
  actor->GetShaderProperty()->AddFragmentShaderReplacement(
    "//VTK::Color::Impl", true, "//VTK::Color::Impl\n // as it was\n", false);
}
}

#endif
