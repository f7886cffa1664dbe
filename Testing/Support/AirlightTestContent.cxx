// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestContent.h"

#include "vtkElevationFilter.h"
#include "vtkPlaneSource.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
void Open(Scene& scene)
{
  scene.Restart();
  scene.Renderer->SetPass(nullptr);
  scene.Renderer->SetBackground(0.1, 0.2, 0.3);
  scene.Pass->RecordBuffersOff();
  scene.Look({ 0.0, 0.0, 8.0 }, { 0.0, 0.0, 0.0 });
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetViewAngle(30.0);
  camera->SetClippingRange(0.5, 50.0);
}

//------------------------------------------------------------------------------
vtkLight* AddLamp(Scene& scene, const glm::dvec3& position)
{
  return scene.AddPointLight(position, { 7.0, 6.0, 5.0 });
}

//------------------------------------------------------------------------------
vtkActor* AddActor(Scene& scene, vtkMapper* mapper)
{
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.9, 0.5, 0.2);
  scene.Renderer->AddActor(actor);
  return actor;
}

//------------------------------------------------------------------------------
vtkActor* AddActor(Scene& scene, vtkPolyData* data, const glm::dvec3& position)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  vtkActor* actor = AddActor(scene, mapper);
  actor->SetPosition(position.x, position.y, position.z);
  return actor;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeSquare(double half, double z)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-half, -half, z);
  plane->SetPoint1(half, -half, z);
  plane->SetPoint2(-half, half, z);
  return Make(plane);
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakeScalarSphere(double radius)
{
  vtkNew<vtkElevationFilter> elevation;
  elevation->SetInputData(MakeSphere(radius));
  elevation->SetLowPoint(0.0, -radius, 0.0);
  elevation->SetHighPoint(0.0, radius, 0.0);
  elevation->Update();
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->DeepCopy(elevation->GetOutput());
  return data;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkPolyData> MakePoints(int n)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> vertices;
  for (int i = 0; i < n * n; ++i)
  {
    const vtkIdType id = points->InsertNextPoint(
      1.5 * (2 * (i % n) - n + 1) / (n - 1.0), 1.5 * (2 * (i / n) - n + 1) / (n - 1.0), 0.1 * i);
    vertices->InsertNextCell(1, &id);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetVerts(vertices);
  return data;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTexture> MakeTexture(int components, int shift)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(16, 16, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, components);
  auto* texel = static_cast<unsigned char*>(image->GetScalarPointer());
  for (int i = 0; i < components * 16 * 16; ++i)
  {
    const int place = i / components;
    texel[i] = static_cast<unsigned char>(
      i % components == 3 ? 16 * (place % 16) : (i * i * 7 + shift) % 256);
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  texture->InterpolateOn();
  return texture;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTexture> MakeCubeMap()
{
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->CubeMapOn();
  texture->InterpolateOn();
  texture->MipmapOn();
  for (int face = 0; face < 6; ++face)
  {
    vtkNew<vtkImageData> image;
    image->SetDimensions(16, 16, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    auto* texel = static_cast<unsigned char*>(image->GetScalarPointer());
    for (int i = 0; i < 16 * 16; ++i)
    {
      texel[3 * i] = static_cast<unsigned char>(8 * (i % 16) + 20 * face);
      texel[3 * i + 1] = static_cast<unsigned char>(8 * (i / 16) + 100);
      texel[3 * i + 2] = static_cast<unsigned char>(240 - 30 * face);
    }
    texture->SetInputDataObject(face, image);
  }
  return texture;
}
}
