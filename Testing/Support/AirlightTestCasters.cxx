// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestCasters.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
glm::dmat3 RandomAxes(Random& random)
{
  const glm::dvec3 x = RandomUnit(random);
  const glm::dvec3 y = glm::normalize(glm::cross(x, RandomUnit(random)));
  return glm::dmat3(x, y, glm::cross(x, y));
}

//------------------------------------------------------------------------------
glm::dvec4 Project(vtkCamera* camera, double aspect, const glm::dvec3& point)
{
  const double in[4] = { point.x, point.y, point.z, 1.0 };
  glm::dvec4 clip;
  camera->GetCompositeProjectionTransformMatrix(aspect, -1, 1)->MultiplyPoint(in, &clip.x);
  return clip;
}

//------------------------------------------------------------------------------
bool IsInPicture(const glm::dvec4& clip)
{
  return clip.w > 0.0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
}

//------------------------------------------------------------------------------
void MakeUnknown(vtkActor* actor)
{
  actor->GetShaderProperty()->AddFragmentShaderReplacement(
    "//VTK::Color::Impl", true, "//VTK::Color::Impl\n // as it was\n", false);
}
}
