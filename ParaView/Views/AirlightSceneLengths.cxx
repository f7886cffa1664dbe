// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightSceneLengths.h"

#include "vtkMath.h"
#include "vtkParticipatingMedium.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
// What a box leaves around the scene, in diagonals: a flat scene needs some.
constexpr double Margin = 0.05;

// The density falls to exp(-2) over the scene.
constexpr double ScaleHeights = 2.0;

// As in vtkParticipatingMedium, of an unknown scene.
constexpr double UnknownBounds[6] = { -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };
constexpr double UnknownLength = 1.0;

// How long a box is along a direction of length 1.
double GetExtent(const vtkBoundingBox& box, const double direction[3])
{
  double extent = 0.0;
  for (int i = 0; i < 3; ++i)
  {
    extent += std::abs(direction[i]) * box.GetLength(i);
  }
  return extent;
}

// The largest distance of a box's corners from the line through its centre.
double GetRadiusAround(const vtkBoundingBox& box, const double axis[3])
{
  double radius = 0.0;
  for (int corner = 0; corner < 4; ++corner)
  {
    const double half[3] = { 0.5 * box.GetLength(0), (corner & 1 ? -0.5 : 0.5) * box.GetLength(1),
      (corner & 2 ? -0.5 : 0.5) * box.GetLength(2) };
    double across[3];
    vtkMath::Cross(half, axis, across);
    radius = std::max(radius, vtkMath::Norm(across));
  }
  return radius;
}
}

//------------------------------------------------------------------------------
bool SceneLengths::IsKnown() const
{
  const double diagonal = this->Scene.IsValid() ? this->Scene.GetDiagonalLength() : 0.0;
  return std::isfinite(diagonal) && diagonal > 0.0;
}

//------------------------------------------------------------------------------
void SceneLengths::Apply(vtkParticipatingMedium* medium) const
{
  this->ApplyBox(medium);
  this->ApplyRound(medium);
  this->ApplyHeights(medium);
}

//------------------------------------------------------------------------------
void SceneLengths::ApplyBox(vtkParticipatingMedium* medium) const
{
  if (std::any_of(this->Bounds, this->Bounds + 6, [](double value) { return value != 0.0; }))
  {
    medium->SetBounds(this->Bounds);
  }
  else if (this->IsKnown())
  {
    vtkBoundingBox box = this->Scene;
    box.Inflate(Margin * box.GetDiagonalLength());
    double bounds[6];
    box.GetBounds(bounds);
    medium->SetBounds(bounds);
  }
  else
  {
    medium->SetBounds(UnknownBounds);
  }
}

//------------------------------------------------------------------------------
// The sphere and the cylinder round the scene have its corners on them.
void SceneLengths::ApplyRound(vtkParticipatingMedium* medium) const
{
  const bool isSphere = medium->GetRegion() == vtkParticipatingMedium::SPHERE;
  const double* axis = medium->GetAxis();
  double center[3];
  std::copy(this->Center, this->Center + 3, center);
  double radius = this->Radius > 0.0 ? this->Radius : UnknownLength;
  double height = this->Height > 0.0 ? this->Height : UnknownLength;
  if (this->IsKnown() && this->Radius == 0.0)
  {
    this->Scene.GetCenter(center);
    radius = isSphere ? 0.5 * this->Scene.GetDiagonalLength() : GetRadiusAround(this->Scene, axis);
  }
  const double extent = this->IsKnown() ? GetExtent(this->Scene, axis) : 0.0;
  if (this->Height == 0.0 && extent > 0.0)
  {
    height = extent;
  }
  medium->SetCenter(center);
  medium->SetRadius(radius);
  medium->SetHeight(height);
}

//------------------------------------------------------------------------------
void SceneLengths::ApplyHeights(vtkParticipatingMedium* medium) const
{
  const double* up = medium->GetUp();
  const double extent = this->IsKnown() ? GetExtent(this->Scene, up) : 0.0;
  if (this->ScaleHeight == 0.0 && extent > 0.0)
  {
    double center[3];
    this->Scene.GetCenter(center);
    medium->SetScaleHeight(extent / ScaleHeights);
    medium->SetReferenceHeight(vtkMath::Dot(center, up) - 0.5 * extent);
    return;
  }
  medium->SetScaleHeight(this->ScaleHeight > 0.0 ? this->ScaleHeight : UnknownLength);
  medium->SetReferenceHeight(this->ReferenceHeight);
}
}
