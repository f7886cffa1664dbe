// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkShadowPlanesFilter.h"

#include "Medium/AirlightConvert.h"
#include "Scene/AirlightVTKVersions.h"
#include "Silhouette/AirlightWritePieces.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include <algorithm>

namespace
{
// What the preparation of the mesh leaves of the work.
constexpr double StartProgress = 0.8;
// FarDistance by default, in diagonals of the mesh.
constexpr double DefaultDiagonals = 2.0;
}

vtkStandardNewMacro(vtkShadowPlanesFilter);

//------------------------------------------------------------------------------
void vtkShadowPlanesFilter::SetFarDistance(double distance)
{
  if (!(distance >= 0.0 && distance <= 1e100))
  {
    vtkErrorMacro(<< "FarDistance " << distance
                  << " must be finite, at least 0 and at most 1e100; it stays " << this->FarDistance
                  << ".");
    return;
  }
  if (this->FarDistance != distance)
  {
    this->FarDistance = distance;
    this->Modified();
  }
}

//------------------------------------------------------------------------------
void vtkShadowPlanesFilter::SetBounds(
  double xmin, double xmax, double ymin, double ymax, double zmin, double zmax)
{
  const double bounds[6] = { xmin, xmax, ymin, ymax, zmin, zmax };
  this->SetBounds(bounds);
}

//------------------------------------------------------------------------------
void vtkShadowPlanesFilter::SetBounds(const double bounds[6])
{
  for (int i = 0; i < 6; ++i)
  {
    if (!(bounds[i] >= -1e100 && bounds[i] <= 1e100))
    {
      vtkErrorMacro(<< "Bounds[" << i << "] " << bounds[i]
                    << " must be finite and at most 1e100 in size; the old bounds stay.");
      return;
    }
  }
  if (!std::equal(bounds, bounds + 6, this->Bounds))
  {
    std::copy(bounds, bounds + 6, this->Bounds);
    this->Modified();
  }
}

//------------------------------------------------------------------------------
bool vtkShadowPlanesFilter::CheckProperties()
{
  const double* b = this->Bounds;
  if (this->Extent == BOUNDS && !(b[0] < b[1] && b[2] < b[3] && b[4] < b[5]))
  {
    vtkErrorMacro(<< "Bounds (" << b[0] << ", " << b[1] << ", " << b[2] << ", " << b[3] << ", "
                  << b[4] << ", " << b[5]
                  << ") hold no volume: set each minimum below its maximum, "
                  << "or SetExtentToFarDistance(). The output is empty.");
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
void vtkShadowPlanesFilter::MakeOutput(
  const airlight::CasterMesh& mesh, const double light[4], vtkPolyData* input, vtkPolyData* output)
{
  airlight::PieceOptions options;
  options.InBounds = this->Extent == BOUNDS;
  options.FarDistance = this->FarDistance > 0.0
    ? this->FarDistance
    : DefaultDiagonals * glm::distance(mesh.BoundsMin, mesh.BoundsMax);
  options.BoundsMin = { this->Bounds[0], this->Bounds[2], this->Bounds[4] };
  options.BoundsMax = { this->Bounds[1], this->Bounds[3], this->Bounds[5] };
  options.LightCap = this->LightCap;
  options.FarCap = this->FarCap;
  const airlight::ShadowPieces pieces = airlight::MakeShadowPieces(
    mesh, { light[0], light[1], light[2], light[3] }, options, [this](double progress) {
      this->UpdateProgress(StartProgress + (1.0 - StartProgress) * progress);
      return !airlight::IsAborted(this);
    });
  if (!airlight::IsAborted(this))
  {
    airlight::WritePieces(mesh, pieces, input, output);
  }
}

//------------------------------------------------------------------------------
void vtkShadowPlanesFilter::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  const double* b = this->Bounds;
  os << indent << "Extent: " << (this->Extent == BOUNDS ? "Bounds" : "FarDistance") << "\n"
     << indent << "FarDistance: " << this->FarDistance << "\n"
     << indent << "Bounds: (" << b[0] << ", " << b[1] << ", " << b[2] << ", " << b[3] << ", "
     << b[4] << ", " << b[5] << ")\n"
     << indent << "LightCap: " << this->LightCap << "\n"
     << indent << "FarCap: " << this->FarCap << "\n";
}
