// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casters/AirlightNonPolygonalCaster.h"

#include "Integration/AirlightMatrix.h"
#include "Scene/AirlightClassTraits.h"
#include "Scene/AirlightGeometryTimes.h"

#include "vtkActor.h"
#include "vtkCommand.h"
#include "vtkMapper.h"
#include "vtkMath.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlaneCollection.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkShaderProperty.h"
#include "vtkTexture.h"

namespace airlight
{
namespace
{
// Whether what a mapper draws may change without a trace in its time: by blocks, sources of glyphs,
// clipping planes that move, functions of point Gaussians, and observers that set uniforms.
bool MayChangeUnseen(vtkMapper* mapper)
{
  auto* gaussians = vtkPointGaussianMapper::SafeDownCast(mapper);
  return !vtkPolyDataMapper::SafeDownCast(mapper) ||
    !vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0)) ||
    (mapper->GetClippingPlanes() && mapper->GetClippingPlanes()->GetNumberOfItems() > 0) ||
    (gaussians && (gaussians->GetScaleFunction() || gaussians->GetScalarOpacityFunction())) ||
    mapper->HasObserver(vtkCommand::UpdateShaderEvent);
}

// Other actors may draw with other mappers than theirs. An actor's own time changes with the
// assembly that draws it.
std::array<vtkMTimeType, 6> GetTimes(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!HasTrait(actor, ClassTrait::DrawsItself) || MayChangeUnseen(mapper))
  {
    return {};
  }
  return { mapper->GetMTime(), mapper->GetInputDataObject(0, 0)->GetMTime(),
    actor->GetProperty()->GetMTime(), GetTime(actor->GetBackfaceProperty()),
    GetTime(actor->GetTexture()), actor->GetShaderProperty()->GetMTime() };
}
}

//------------------------------------------------------------------------------
NonPolygonalCaster::NonPolygonalCaster(vtkActor* actor, vtkProp* owner, vtkMatrix4x4* toWorld)
  : Actor(actor)
  , Owner(owner)
  , PartToWorld(actor != owner ? toWorld : nullptr)
  , ToWorld(ToGlm(toWorld))
  , Times(GetTimes(actor))
{
}

//------------------------------------------------------------------------------
std::vector<glm::dvec3> NonPolygonalCaster::GetCorners() const
{
  // A part's own bounds are those of where it stands without the assembly.
  const double* b =
    this->PartToWorld ? this->Actor->GetMapper()->GetBounds() : this->Actor->GetBounds();
  std::vector<glm::dvec3> corners;
  for (int i = 0; i < 8 && b && vtkMath::AreBoundsInitialized(b); ++i)
  {
    const glm::dvec4 corner(b[i & 1], b[2 + (i >> 1 & 1)], b[4 + (i >> 2)], 1.0);
    corners.emplace_back(this->PartToWorld ? this->ToWorld * corner : corner);
  }
  return corners;
}

//------------------------------------------------------------------------------
bool NonPolygonalCaster::DrawsAs(const NonPolygonalCaster& other) const
{
  return this->Times[0] != 0 && this->Times == other.Times && this->ToWorld == other.ToWorld &&
    this->Actor == other.Actor && this->Owner == other.Owner;
}
}
