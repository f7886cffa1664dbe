// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casters/AirlightGlyphs.h"

#include "vtkBitArray.h"
#include "vtkDataArray.h"
#include "vtkDataSet.h"
#include "vtkGlyph3DMapper.h"
#include "vtkMath.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkTransform.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
// Makes the mapper's arrays accessible.
struct Arrays : public vtkGlyph3DMapper
{
  using vtkGlyph3DMapper::GetMaskArray;
  using vtkGlyph3DMapper::GetOrientationArray;
  using vtkGlyph3DMapper::GetScaleArray;
  using vtkGlyph3DMapper::GetSourceIndexArray;
};

using Getter = vtkDataArray* (vtkGlyph3DMapper::*)(vtkDataSet*);

vtkDataArray* Get(vtkGlyph3DMapper* mapper, vtkDataSet* data, bool used, Getter getter)
{
  return used ? (mapper->*getter)(data) : nullptr;
}

double GetMagnitude(vtkDataArray* array, vtkIdType i)
{
  double sum = 0.0;
  for (int k = 0; k < array->GetNumberOfComponents(); ++k)
  {
    sum += array->GetComponent(i, k) * array->GetComponent(i, k);
  }
  return array->GetNumberOfComponents() == 1 ? array->GetComponent(i, 0) : std::sqrt(sum);
}

// Half a turn about the axis midway between x and the direction.
void TurnTo(vtkTransform* transform, const double d[3])
{
  if (d[1] != 0.0 || d[2] != 0.0)
  {
    transform->RotateWXYZ(180.0, d[0] + vtkMath::Norm(d), d[1], d[2]);
  }
  else if (d[0] < 0.0)
  {
    transform->RotateWXYZ(180.0, 0.0, 1.0, 0.0);
  }
}

void Orient(vtkTransform* transform, int mode, vtkDataArray* array, vtkIdType i)
{
  double v[4] = { 0.0, 0.0, 0.0, 0.0 };
  for (int k = 0; k < std::min(4, array->GetNumberOfComponents()); ++k)
  {
    v[k] = array->GetComponent(i, k);
  }
  switch (mode)
  {
    case vtkGlyph3DMapper::ROTATION:
      transform->RotateZ(v[2]);
      transform->RotateX(v[0]);
      transform->RotateY(v[1]);
      break;
    case vtkGlyph3DMapper::QUATERNION:
      transform->RotateWXYZ(
        vtkMath::DegreesFromRadians(2.0 * std::atan2(vtkMath::Norm(v + 1), v[0])), v + 1);
      break;
    default:
      TurnTo(transform, v);
      break;
  }
}

void Scale(vtkTransform* transform, vtkGlyph3DMapper* mapper, vtkDataArray* array, vtkIdType i)
{
  const int mode = mapper->GetScaleMode();
  const double* range = mapper->GetRange();
  const double width = range[1] != range[0] ? range[1] - range[0] : 1.0;
  double scale[3] = { 1.0, 1.0, 1.0 };
  for (int k = 0; k < 3; ++k)
  {
    if (array && mode == vtkGlyph3DMapper::SCALE_BY_MAGNITUDE)
    {
      scale[k] = GetMagnitude(array, i);
    }
    else if (array && mode == vtkGlyph3DMapper::SCALE_BY_COMPONENTS)
    {
      scale[k] = k < array->GetNumberOfComponents() ? array->GetComponent(i, k) : 1.0;
    }
    if (mapper->GetClamping() && mode != vtkGlyph3DMapper::NO_DATA_SCALING)
    {
      scale[k] = (std::min(std::max(scale[k], range[0]), range[1]) - range[0]) / width;
    }
    scale[k] *= mapper->GetScaleFactor();
  }
  transform->Scale(scale);
}
}

//------------------------------------------------------------------------------
bool HasSupportedGlyphs(vtkGlyph3DMapper* mapper)
{
  return vtkDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0)) &&
    !mapper->GetUseSourceTableTree();
}

//------------------------------------------------------------------------------
std::vector<Glyph> GetGlyphs(vtkGlyph3DMapper* mapper)
{
  std::vector<Glyph> glyphs;
  auto* data = vtkDataSet::SafeDownCast(mapper->GetInputDataObject(0, 0));
  const int sources = mapper->GetNumberOfInputConnections(1);
  if (sources == 0 || !HasSupportedGlyphs(mapper))
  {
    return glyphs;
  }
  // The mapper takes no other kind of array for a mask.
  vtkDataArray* mask =
    vtkBitArray::SafeDownCast(Get(mapper, data, mapper->GetMasking(), &Arrays::GetMaskArray));
  vtkDataArray* orientation = Get(mapper, data, mapper->GetOrient(), &Arrays::GetOrientationArray);
  vtkDataArray* scale = Get(mapper, data, mapper->GetScaling(), &Arrays::GetScaleArray);
  vtkDataArray* index =
    Get(mapper, data, mapper->GetSourceIndexing(), &Arrays::GetSourceIndexArray);
  vtkNew<vtkTransform> transform;
  for (vtkIdType i = 0; i < data->GetNumberOfPoints(); ++i)
  {
    // The mapper takes the norm of one component, too.
    const int number = index ? static_cast<int>(std::abs(GetMagnitude(index, i))) : 0;
    vtkPolyData* source = mapper->GetSource(std::clamp(number, 0, sources - 1));
    if (!source || (mask && mask->GetComponent(i, 0) == 0.0))
    {
      continue;
    }
    transform->Identity();
    transform->Translate(data->GetPoint(i));
    if (orientation)
    {
      Orient(transform, mapper->GetOrientationMode(), orientation, i);
    }
    if (mapper->GetScaling())
    {
      Scale(transform, mapper, scale, i);
    }
    auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
    matrix->DeepCopy(transform->GetMatrix());
    glyphs.push_back({ source, matrix });
  }
  return glyphs;
}
}
