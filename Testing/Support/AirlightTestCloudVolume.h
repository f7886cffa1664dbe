// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A cloud that VTK draws as a volume, and what it takes away of light, by brute force.
 */

#ifndef AirlightTestCloudVolume_h
#define AirlightTestCloudVolume_h

#include "AirlightTestDensity.h"

#include "vtkColorTransferFunction.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkPiecewiseFunction.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace airlight_test
{
// Opacity 0 up to a tenth of the largest scalar, then in two slopes up to `opacity`.
inline vtkSmartPointer<vtkVolume> MakeCloudVolume(
  vtkImageData* image, double opacity, double unitDistance)
{
  const double most = image->GetPointData()->GetScalars()->GetRange()[1];
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0.0, 0.0);
  opacities->AddPoint(0.1 * most, 0.0);
  opacities->AddPoint(0.5 * most, 0.7 * opacity);
  opacities->AddPoint(most, opacity);
  vtkNew<vtkColorTransferFunction> colours;
  colours->AddRGBPoint(0.0, 0.8, 0.8, 0.8);
  vtkNew<vtkVolumeProperty> property;
  property->SetScalarOpacity(opacities);
  property->SetColor(colours);
  property->SetScalarOpacityUnitDistance(unitDistance);
  property->SetInterpolationTypeToLinear();
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(image);
  mapper->UseJitteringOff();
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  return volume;
}

// The extinction there, of a volume whose matrix scales all lengths by `scale`.
inline double GetExtinctionAt(vtkVolume* volume, const glm::dvec3& point, double scale)
{
  auto* image = vtkImageData::SafeDownCast(volume->GetMapper()->GetDataSetInput());
  vtkNew<vtkMatrix4x4> toData;
  vtkMatrix4x4::Invert(volume->GetMatrix(), toData);
  const double world[4] = { point.x, point.y, point.z, 1.0 };
  double data[4];
  double place[3];
  toData->MultiplyPoint(world, data);
  image->TransformPhysicalPointToContinuousIndex(data, place);
  const int* extent = image->GetExtent();
  double scalar = 0.0;
  for (int axis = 0; axis < 3; ++axis)
  {
    if (place[axis] < extent[2 * axis] || place[axis] > extent[2 * axis + 1])
    {
      return 0.0;
    }
  }
  for (int corner = 0; corner < 8; ++corner)
  {
    int at[3];
    double share = 1.0;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int first = std::min(static_cast<int>(place[axis]), extent[2 * axis + 1] - 1);
      const int far = (corner >> axis) & 1;
      at[axis] = first + far;
      share *= far ? place[axis] - first : 1.0 - (place[axis] - first);
    }
    scalar += share * image->GetScalarComponentAsDouble(at[0], at[1], at[2], 0);
  }
  vtkVolumeProperty* property = volume->GetProperty();
  return -std::log(1.0 - property->GetScalarOpacity()->GetValue(scalar)) /
    (property->GetScalarOpacityUnitDistance() * scale);
}
}

#endif
