// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestContent.h"

#include "vtkActor2D.h"
#include "vtkAssembly.h"
#include "vtkAxesActor.h"
#include "vtkBillboardTextActor3D.h"
#include "vtkColorTransferFunction.h"
#include "vtkCubeAxesActor.h"
#include "vtkFollower.h"
#include "vtkLookupTable.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper2D.h"
#include "vtkPropAssembly.h"
#include "vtkProperty2D.h"
#include "vtkScalarBarActor.h"
#include "vtkSkybox.h"
#include "vtkTextActor.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
// A ball of density in a cube of half width 1.5.
static vtkSmartPointer<vtkImageData> MakeDensities()
{
  const int n = 24;
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(n, n, n);
  image->SetSpacing(3.0 / (n - 1), 3.0 / (n - 1), 3.0 / (n - 1));
  image->SetOrigin(-1.5, -1.5, -1.5);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  auto* voxel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < n * n * n; ++i)
  {
    double p[3];
    image->GetPoint(i, p);
    const double r = std::sqrt(p[0] * p[0] + p[1] * p[1] + p[2] * p[2]);
    voxel[i] = static_cast<unsigned char>(255.0 * std::max(0.0, 1.0 - r / 1.5));
  }
  return image;
}

//------------------------------------------------------------------------------
void AddVolume(Scene& scene, vtkVolumeMapper* mapper, bool shade)
{
  mapper->SetInputDataObject(MakeDensities());
  vtkNew<vtkColorTransferFunction> colours;
  colours->AddRGBPoint(0.0, 0.0, 0.2, 0.9);
  colours->AddRGBPoint(255.0, 1.0, 0.5, 0.1);
  vtkNew<vtkPiecewiseFunction> opacities;
  opacities->AddPoint(0.0, 0.0);
  opacities->AddPoint(255.0, 0.5);
  vtkNew<vtkVolumeProperty> property;
  property->SetColor(colours);
  property->SetScalarOpacity(opacities);
  property->SetInterpolationTypeToLinear();
  property->SetShade(shade);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->SetProperty(property);
  scene.Renderer->AddVolume(volume);
  // Before and inside it.
  AddActor(scene, MakeSphere(0.4), { 1.0, 0.5, 0.2 });
  AddActor(scene, MakeSphere(0.3), { -0.8, 0.0, 1.6 });
}

//------------------------------------------------------------------------------
void AddAssemblies(Scene& scene)
{
  vtkNew<vtkAssembly> assembly;
  vtkNew<vtkPropAssembly> props;
  for (int i = 0; i < 4; ++i)
  {
    const auto actor = Scene::MakeActor(MakeSphere(0.5));
    actor->SetPosition(i - 1.5, i % 2, 0.5 * i);
    actor->GetProperty()->SetOpacity(i == 3 ? 0.5 : 1.0);
    i < 2 ? assembly->AddPart(actor) : props->AddPart(actor);
  }
  assembly->SetScale(1.2);
  assembly->RotateZ(30.0);
  scene.Renderer->AddActor(assembly);
  scene.Renderer->AddActor(props);
}

//------------------------------------------------------------------------------
void AddFollower(Scene& scene)
{
  vtkNew<vtkFollower> follower;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(MakeSquare(0.8));
  follower->SetMapper(mapper);
  follower->SetCamera(scene.Renderer->GetActiveCamera());
  follower->SetPosition(-0.8, 0.5, 0.0);
  scene.Renderer->AddActor(follower);
  AddActor(scene, MakeSphere(0.5), { 1.0, -0.8, 1.0 });
}

//------------------------------------------------------------------------------
void AddBillboard(Scene& scene)
{
  AddActor(scene, MakeSphere(0.5));
  vtkNew<vtkBillboardTextActor3D> text;
  text->SetInput("Billboard");
  text->SetPosition(-0.8, 0.0, 1.0);
  scene.Renderer->AddActor(text);
}

//------------------------------------------------------------------------------
void AddAnnotations(Scene& scene)
{
  AddActor(scene, MakeSphere(0.8), { -0.5, 0.0, 0.0 });
  vtkNew<vtkTextActor> text;
  text->SetInput("Text");
  text->SetPosition(5, 5);
  scene.Renderer->AddActor(text);
  vtkNew<vtkLookupTable> colours;
  colours->Build();
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(colours);
  bar->SetTitle("m");
  bar->SetNumberOfLabels(3);
  scene.Renderer->AddActor(bar);
  vtkNew<vtkPolyDataMapper2D> mapper;
  vtkNew<vtkPlaneSource> square;
  square->SetOrigin(10.0, 60.0, 0.0);
  square->SetPoint1(30.0, 60.0, 0.0);
  square->SetPoint2(10.0, 80.0, 0.0);
  mapper->SetInputData(Make(square));
  vtkNew<vtkActor2D> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.2, 0.6);
  actor->GetProperty()->SetOpacity(0.5);
  scene.Renderer->AddActor(actor);
}

//------------------------------------------------------------------------------
void AddAxes(Scene& scene)
{
  AddActor(scene, MakeSphere(0.8));
  vtkNew<vtkAxesActor> axes;
  scene.Renderer->AddActor(axes);
  vtkNew<vtkCubeAxesActor> cube;
  cube->SetBounds(-1.0, 1.0, -1.0, 1.0, -1.0, 1.0);
  cube->SetCamera(scene.Renderer->GetActiveCamera());
  scene.Renderer->AddActor(cube);
}

//------------------------------------------------------------------------------
void AddSkybox(Scene& scene)
{
  vtkNew<vtkSkybox> box;
  box->SetTexture(MakeCubeMap());
  scene.Renderer->AddActor(box);
  AddActor(scene, MakeSphere(1.0));
  scene.Renderer->GetActiveCamera()->SetPosition(5.0, 2.0, 6.0);
}

//------------------------------------------------------------------------------
void AddGradient(Scene& scene)
{
  AddActor(scene, MakeSphere(1.0));
  scene.Renderer->GradientBackgroundOn();
  scene.Renderer->SetBackground2(0.9, 0.6, 0.2);
}

//------------------------------------------------------------------------------
void AddTexturedBackground(Scene& scene)
{
  AddActor(scene, MakeSphere(1.0));
  scene.Renderer->TexturedBackgroundOn();
  scene.Renderer->SetBackgroundTexture(MakeTexture(3));
}
}
