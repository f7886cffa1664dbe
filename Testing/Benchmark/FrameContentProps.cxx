// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameContent.h"

#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkAxesActor.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkColorTransferFunction.h"
#include "vtkCubeAxesActor.h"
#include "vtkFollower.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkImageCanvasSource2D.h"
#include "vtkLODActor.h"
#include "vtkLightKit.h"
#include "vtkLookupTable.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRTAnalyticSource.h"
#include "vtkScalarBarActor.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkTexturedSphereSource.h"
#include "vtkVectorText.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace benchmarks
{
namespace
{
vtkSmartPointer<vtkActor> MakeBall(vtkActor* actor, double x, double y, double z, double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(x, y, z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(33);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  actor->SetMapper(mapper);
  return actor;
}

//------------------------------------------------------------------------------
void AddAssembly(FrameScene& scene)
{
  vtkNew<vtkAssembly> assembly;
  assembly->AddPart(MakeBall(vtkNew<vtkActor>(), -2.0, 1.0, 1.0, 0.7));
  scene.Renderer->AddActor(assembly);
}

void AddLevelsOfDetail(FrameScene& scene)
{
  scene.Renderer->AddActor(MakeBall(vtkNew<vtkLODActor>(), -2.0, 1.0, 1.0, 0.7));
}

void AddAxes(FrameScene& scene)
{
  vtkNew<vtkAxesActor> axes;
  axes->SetTotalLength(2.0, 2.0, 2.0);
  scene.Renderer->AddActor(axes);
}

void AddCubeAxes(FrameScene& scene)
{
  vtkNew<vtkCubeAxesActor> axes;
  axes->SetBounds(-3.0, 3.0, 0.0, 3.0, -3.0, 3.0);
  axes->SetCamera(scene.Renderer->GetActiveCamera());
  scene.Renderer->AddActor(axes);
}

void AddScalarBar(FrameScene& scene)
{
  vtkNew<vtkLookupTable> colours;
  colours->Build();
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(colours);
  bar->SetTitle("m/s");
  scene.Renderer->AddActor(bar);
}

void AddText(FrameScene& scene)
{
  vtkNew<vtkVectorText> text;
  text->SetText("Airlight");
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(text->GetOutputPort());
  vtkNew<vtkFollower> follower;
  follower->SetMapper(mapper);
  follower->SetScale(0.5);
  follower->SetPosition(-2.0, 2.2, 0.0);
  follower->SetCamera(scene.Renderer->GetActiveCamera());
  scene.Renderer->AddActor(follower);
}

void AddBillboards(FrameScene& scene)
{
  for (int i = 0; i < 20; ++i)
  {
    vtkNew<vtkBillboardTextActor3D> label;
    label->SetInput("label");
    label->SetPosition(0.5 * (i % 10) - 2.5, 2.0 + 0.5 * (i / 10), -1.0);
    scene.Renderer->AddActor(label);
  }
}

//------------------------------------------------------------------------------
void AddVolume(FrameScene& scene)
{
  vtkNew<vtkRTAnalyticSource> wavelet;
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputConnection(wavelet->GetOutputPort());
  vtkNew<vtkColorTransferFunction> colours;
  colours->AddRGBPoint(60.0, 0.0, 0.2, 0.9);
  colours->AddRGBPoint(260.0, 1.0, 0.5, 0.1);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(150.0, 0.0);
  opacities->AddPoint(260.0, 0.3);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetColor(colours);
  volume->GetProperty()->SetScalarOpacity(opacities);
  volume->GetProperty()->SetInterpolationTypeToLinear();
  volume->SetScale(0.08);
  volume->SetPosition(-2.0, 1.2, 0.5);
  scene.Renderer->AddVolume(volume);
}

// As vtkGLTFImporter makes actors: physically based, coloured by a texture.
void AddTextured(FrameScene& scene)
{
  vtkNew<vtkImageCanvasSource2D> canvas;
  canvas->SetExtent(0, 63, 0, 63, 0, 0);
  canvas->SetScalarTypeToUnsignedChar();
  canvas->SetNumberOfScalarComponents(3);
  canvas->SetDrawColor(220.0, 200.0, 180.0);
  canvas->FillBox(0, 63, 0, 63);
  canvas->SetDrawColor(60.0, 90.0, 140.0);
  canvas->FillBox(16, 47, 16, 47);
  vtkNew<vtkTexture> texture;
  texture->SetInputConnection(canvas->GetOutputPort());
  texture->UseSRGBColorSpaceOn();
  vtkNew<vtkTexturedSphereSource> sphere;
  sphere->SetRadius(0.7);
  sphere->SetThetaResolution(32);
  sphere->SetPhiResolution(32);
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->SetPosition(-2.0, 1.0, 1.0);
  actor->GetProperty()->SetInterpolationToPBR();
  actor->GetProperty()->SetBaseColorTexture(texture);
  scene.Renderer->AddActor(actor);
}

//------------------------------------------------------------------------------
void AddCameraLights(FrameScene& scene)
{
  vtkNew<vtkLightKit> kit;
  kit->AddLightsToRenderer(scene.Renderer);
}
}

//------------------------------------------------------------------------------
std::vector<Content> GetPropContent()
{
  return {
    { "assembly", AddAssembly },
    { "level-of-detail", AddLevelsOfDetail },
    { "axes", AddAxes },
    { "cube-axes", AddCubeAxes },
    { "scalar-bar", AddScalarBar },
    { "text", AddText },
    { "billboards", AddBillboards },
    { "volume", AddVolume },
    { "textured", AddTextured },
    { "camera-lights", AddCameraLights },
  };
}
}
