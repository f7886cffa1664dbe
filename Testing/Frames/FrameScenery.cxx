// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Contents that no actor of the item shows: volumes, images, text and axes.

#include "FrameParts.h"

#include "vtkAxesActor.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkCamera.h"
#include "vtkColorTransferFunction.h"
#include "vtkCubeAxesActor.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageActor.h"
#include "vtkImageData.h"
#include "vtkImageMapper3D.h"
#include "vtkNew.h"
#include "vtkPiecewiseFunction.h"
#include "vtkTextActor.h"
#include "vtkTextActor3D.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace airlight_test
{
namespace
{
vtkSmartPointer<vtkImageData> MakeImage(Random& random, int depth)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(6, 6, depth);
  image->SetSpacing(0.4, 0.4, 0.4);
  image->SetOrigin(-1.0, -1.0, depth > 1 ? -1.0 : 0.0);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    voxel[i] = static_cast<unsigned char>(random.Index(256));
  }
  return image;
}

void MakeVolume(FrameItem& item, Random& random)
{
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputDataObject(MakeImage(random, 6));
  mapper->UseJitteringOff();
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetSampleDistance(0.2f);
  if (random.Index(4) == 0)
  {
    mapper->SetBlendModeToMaximumIntensity();
  }
  vtkNew<vtkColorTransferFunction> colours;
  colours->AddRGBPoint(0.0, 0.0, 0.2, 0.9);
  colours->AddRGBPoint(255.0, 1.0, 0.5, 0.1);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0.0, 0.0);
  opacities->AddPoint(255.0, random.Uniform(0.1, 0.9));
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(colours);
  property->SetScalarOpacity(opacities);
  property->SetInterpolationTypeToLinear();
  property->SetShade(random.Index(2));
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  item.Prop = volume;
}

void MakeText(FrameItem& item, Random& random)
{
  switch (random.Index(3))
  {
    case 0:
    {
      vtkNew<vtkTextActor> text;
      text->SetInput("Ag");
      text->SetPosition(1, 1);
      item.Prop = text;
      break;
    }
    case 1:
    {
      vtkNew<vtkTextActor3D> text;
      text->SetInput("Ag");
      text->SetScale(0.05);
      item.Prop = text;
      break;
    }
    default:
    {
      vtkNew<vtkBillboardTextActor3D> text;
      text->SetInput("Ag");
      item.Prop = text;
    }
  }
}

vtkSmartPointer<vtkProp> MakeCubeAxes(vtkCamera* camera)
{
  auto axes = vtkSmartPointer<vtkCubeAxesActor>::New();
  axes->SetBounds(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
  axes->SetCamera(camera);
  return axes;
}
}

//------------------------------------------------------------------------------
void MakeFrameScenery(FrameItem& item, Random& random, vtkCamera* camera)
{
  const vtkSmartPointer<vtkProp> actor = item.Prop;
  switch (item.Kind)
  {
    case FRAME_VOLUME:
      MakeVolume(item, random);
      break;
    case FRAME_CUBE_AXES:
      item.Prop = MakeCubeAxes(camera);
      break;
    case FRAME_AXES:
    {
      vtkNew<vtkAxesActor> axes;
      axes->AxisLabelsOff();
      item.Prop = axes;
      break;
    }
    case FRAME_TEXT:
      MakeText(item, random);
      break;
    case FRAME_IMAGE:
    {
      vtkNew<vtkImageActor> image;
      image->GetMapper()->SetInputDataObject(MakeImage(random, 1));
      item.Prop = image;
      break;
    }
    default:
      break;
  }
  if (item.Prop != actor)
  {
    item.Actors.clear();
    item.Mesh = nullptr;
  }
}
}
