// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestVolume.h"

#include "vtkCellData.h"
#include "vtkColorTransferFunction.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkUnsignedCharArray.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
vtkSmartPointer<vtkImageData> MakeSlabImage(const Slab& slab, int components)
{
  const int n = 16;
  const glm::dvec3 spacing = (slab.High - slab.Low) / double(n);
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n + 1, n + 1, n + 1);
  image->SetOrigin(&slab.Low.x);
  image->SetSpacing(&spacing.x);
  vtkNew<vtkUnsignedCharArray> values;
  values->SetNumberOfComponents(components);
  values->SetNumberOfTuples(n * n * n);
  for (int i = 0; i < n * n * n * components; ++i)
  {
    values->SetValue(i, static_cast<unsigned char>(10 * (i / components / (n * n))));
  }
  image->GetCellData()->SetScalars(values);
  return image;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkVolumeProperty> MakeSlabProperty(const Slab& slab)
{
  vtkNew<vtkColorTransferFunction> colours;
  vtkNew<vtkPiecewiseFunction> opacities;
  for (const double x : { 0.0, 255.0 })
  {
    colours->AddRGBPoint(x, slab.Colour.x, slab.Colour.y, slab.Colour.z);
    opacities->AddPoint(x, 1.0 - std::exp(-slab.Kappa));
  }
  auto property = vtkSmartPointer<vtkVolumeProperty>::New();
  property->SetColor(colours);
  property->SetScalarOpacity(opacities);
  property->SetScalarOpacityUnitDistance(1.0);
  property->SetInterpolationTypeToLinear();
  property->SetShade(slab.Lit);
  property->SetAmbient(0.0);
  property->SetDiffuse(1.0);
  property->SetSpecular(0.0);
  return property;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkVolume> AddSlab(Scene& scene, const Slab& slab)
{
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(MakeSlabImage(slab));
  mapper->SetScalarModeToUseCellData();
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetSampleDistance(static_cast<float>(slab.Step));
  mapper->UseJitteringOff();
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->SetProperty(MakeSlabProperty(slab));
  scene.Renderer->AddVolume(volume);
  return volume;
}
}
