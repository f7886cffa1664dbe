// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightGaussianFragments.h"

#include "Integration/AirlightMatrix.h"
#include "Pass/AirlightScenePass.h"
#include "Scene/AirlightCameraUniforms.h"
#include "Scene/AirlightSceneProps.h"

#include "vtkActor.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyData.h"

#include <glm/gtc/constants.hpp>

#include <cmath>

namespace airlight
{
namespace
{
// So many points tell the area of all.
constexpr vtkIdType EstimatedPoints = 2000;
// VTK draws a Gaussian up to so many standard deviations.
constexpr double Deviations = 3.0;

// Of the picture, by one actor.
double GetCoveredShare(
  const ScenePart& part, vtkPolyData* points, double radius, const CameraUniforms& view)
{
  const glm::dmat4 toWorld = ToGlm(part.ToWorld);
  const glm::dmat4 toClip(view.GetClipMatrix(view.GetEye()));
  const glm::dmat4 rows = glm::transpose(toClip);
  const double across = glm::length(glm::dvec3(rows[0])) * glm::length(glm::dvec3(rows[1]));
  const double scale = radius * std::cbrt(std::abs(glm::determinant(glm::dmat3(toWorld))));
  const vtkIdType count = points->GetNumberOfPoints();
  const vtkIdType stride = 1 + count / EstimatedPoints;
  double area = 0.0;
  for (vtkIdType i = 0; i < count; i += stride)
  {
    double point[3];
    points->GetPoint(i, point);
    const glm::dvec3 place(toWorld * glm::dvec4(point[0], point[1], point[2], 1.0));
    const glm::dvec4 clip = toClip * glm::dvec4(place - view.GetEye(), 1.0);
    if (clip.w > 0.0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w)
    {
      area += glm::pi<double>() * across * scale * scale / (clip.w * clip.w);
    }
  }
  // The picture's area is 4.
  return 0.25 * area * static_cast<double>(stride);
}
}

//------------------------------------------------------------------------------
double EstimateGaussianFragments(const SceneProps& props, const CameraUniforms& view)
{
  double sum = 0.0;
  for (const SceneProp& prop : props.GetProps())
  {
    for (const ScenePart& part : prop.Parts)
    {
      auto* mapper = vtkPointGaussianMapper::SafeDownCast(part.Actor->GetMapper());
      if (prop.InView && mapper && AirlightScenePass::IsPointGaussians(part.Actor) &&
        mapper->GetNumberOfInputConnections(0) > 0 && mapper->GetInput())
      {
        sum +=
          GetCoveredShare(part, mapper->GetInput(), Deviations * mapper->GetScaleFactor(), view);
      }
    }
  }
  return sum;
}
}
