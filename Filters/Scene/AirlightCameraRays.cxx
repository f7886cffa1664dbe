// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightCameraRays.h"

#include "Integration/AirlightMatrix.h"
#include "vtkCamera.h"

#include <cmath>

namespace airlight
{
namespace
{
bool IsFinite(const glm::dmat4& m)
{
  for (int i = 0; i < 4; ++i)
  {
    for (int j = 0; j < 4; ++j)
    {
      if (!std::isfinite(m[i][j]))
      {
        return false;
      }
    }
  }
  return true;
}
}

//------------------------------------------------------------------------------
CameraRays::CameraRays(vtkCamera* camera, double aspect, int width, int height)
  : Width(width)
  , Height(height)
{
  this->WorldToView = ToGlm(camera->GetModelViewTransformMatrix());
  const glm::dmat4 viewToClip = ToGlm(camera->GetProjectionTransformMatrix(aspect, -1, 1));
  this->WorldToClip = viewToClip * this->WorldToView;
  const glm::dmat4 viewToWorld = glm::inverse(this->WorldToView);
  const glm::dmat4 clipToView = glm::inverse(viewToClip);
  this->Valid = width > 0 && height > 0 && IsFinite(viewToWorld) && IsFinite(clipToView);
  if (!this->Valid)
  {
    return;
  }
  this->Parallel = camera->GetParallelProjection() != 0;
  this->Forward = -glm::normalize(glm::dvec3(viewToWorld[2]));
  camera->GetClippingRange(this->Near, this->Far);

  // Where all rays meet. The cameras of a stereo pair have their projections sheared by VTK, which
  // takes them from the origin of the view; in parallel projection it tilts the rays.
  const glm::dvec4 apex = clipToView * glm::dvec4(0.0, 0.0, 1.0, 0.0);
  const glm::dvec3 eye = this->Parallel ? glm::dvec3(0.0) : glm::dvec3(apex) / apex.w;
  const glm::dvec3 tilt = this->Parallel ? glm::dvec3(apex) / -apex.z : glm::dvec3(0.0);
  const glm::dmat3 axes(viewToWorld);
  this->Eye = glm::dvec3(viewToWorld[3]) + axes * eye;

  // Of a pixel, affine in its position: the direction of its ray, one unit deep; in parallel
  // projection the point where its ray leaves the camera's plane.
  const auto viewPoint = [&](double px, double py) {
    const glm::dvec4 q =
      clipToView * glm::dvec4(2.0 * px / width - 1.0, 2.0 * py / height - 1.0, 0.0, 1.0);
    const glm::dvec3 point = glm::dvec3(q) / q.w - eye;
    return this->Parallel ? point + point.z * tilt : point / -point.z;
  };
  const glm::dvec3 corner = viewPoint(0.0, 0.0);
  this->Affine[0] = axes * corner;
  this->Affine[1] = axes * (viewPoint(width, 0.0) - corner) / static_cast<double>(width);
  this->Affine[2] = axes * (viewPoint(0.0, height) - corner) / static_cast<double>(height);
  if (this->Parallel)
  {
    this->Along = glm::normalize(axes * tilt);
    this->PerDepth = glm::length(tilt);
  }
}

//------------------------------------------------------------------------------
CameraRays::Ray CameraRays::GetRay(double x, double y) const
{
  const glm::dvec3 point = this->Affine[0] + x * this->Affine[1] + y * this->Affine[2];
  if (this->Parallel)
  {
    return { point, this->Along, this->PerDepth * this->Near, this->PerDepth * this->Far };
  }
  const double perDepth = glm::length(point);
  return { glm::dvec3(0.0), point / perDepth, perDepth * this->Near, perDepth * this->Far };
}

//------------------------------------------------------------------------------
std::array<CameraRays::Ray, 4> CameraRays::GetCornerRays() const
{
  const double right = this->Width + 1.0;
  const double top = this->Height + 1.0;
  return { this->GetRay(-1.0, -1.0), this->GetRay(right, -1.0), this->GetRay(right, top),
    this->GetRay(-1.0, top) };
}
}
