// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A small window whose content is exchanged, so that its shaders are compiled once, and the small
 * pieces that contents are made of.
 */

#ifndef AirlightTestContent_h
#define AirlightTestContent_h

#include "AirlightTestScene.h"

#include "vtkElevationFilter.h"
#include "vtkPlaneSource.h"
#include "vtkTexture.h"

namespace airlighttest
{
//------------------------------------------------------------------------------
// One renderer and pass at a time in one window. Nothing of a content outlives Clear().
class Theatre
{
public:
  static constexpr int Width = 120;
  static constexpr int Height = 90;

  Theatre()
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetAlphaBitPlanes(1);
    this->Window->SetSize(Width, Height);
    this->Window->SetNumberOfLayers(1);
  }
  ~Theatre() { this->Clear(); }
  Theatre(const Theatre&) = delete;
  void operator=(const Theatre&) = delete;

  // A new renderer, without its pass, that looks along -z at a square of about 4 by 4 units around the origin.
  void Open()
  {
    this->Clear();
    this->Pass = vtkSmartPointer<vtkAirlightPass>::New();
    this->Pass->SetMedium(this->Medium);
    this->Renderer = vtkSmartPointer<vtkRenderer>::New();
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetBackground(0.1, 0.2, 0.3);
    this->Window->AddRenderer(this->Renderer);
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(0.0, 0.0, 8.0);
    camera->SetFocalPoint(0.0, 0.0, 0.0);
    camera->SetViewAngle(30.0);
    camera->SetClippingRange(0.5, 50.0);
  }

  void Clear()
  {
    if (this->Renderer)
    {
      this->Pass->ReleaseGraphicsResources(this->Window);
      this->Renderer->SetPass(nullptr);
      this->Window->RemoveRenderer(this->Renderer);
      this->Renderer = nullptr;
    }
  }

  // Weak enough that nothing is overexposed, since VTK cuts at 1 what it blends into 8 bits and the
  // pass does not. One kind of light: the shaders of translucent surfaces hold the closed forms of all there are.
  vtkLight* AddLamp(const glm::dvec3& position = { 2.0, 2.0, 3.0 })
  {
    vtkNew<vtkLight> lamp;
    const double intensity[3] = { 7.0, 6.0, 5.0 };
    vtkAirlight::SetRadiantIntensity(lamp, intensity);
    lamp->SetLightTypeToSceneLight();
    lamp->SetPosition(position.x, position.y, position.z);
    this->Renderer->AddLight(lamp);
    return lamp;
  }

  vtkActor* Add(vtkMapper* mapper)
  {
    vtkNew<vtkActor> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(0.9, 0.5, 0.2);
    this->Renderer->AddActor(actor);
    return actor;
  }

  vtkActor* Add(vtkPolyData* data)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    mapper->ScalarVisibilityOff();
    return this->Add(mapper);
  }

  // At a place.
  vtkActor* Add(vtkPolyData* data, double x, double y, double z)
  {
    vtkActor* actor = this->Add(data);
    actor->SetPosition(x, y, z);
    return actor;
  }

  vtkNew<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkAirlightPass> Pass;
  vtkNew<vtkParticipatingMedium> Medium;
};

//------------------------------------------------------------------------------
// A square of this half width across the z axis, facing +z.
inline vtkSmartPointer<vtkPolyData> MakeSquare(double half, double z = 0.0)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-half, -half, z);
  plane->SetPoint1(half, -half, z);
  plane->SetPoint2(-half, half, z);
  return Make(plane);
}

// With scalars from 0 to 1 at the points.
inline vtkSmartPointer<vtkPolyData> MakeScalarSphere(double radius)
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

// A grid of n by n points in the square of half width 1.5.
inline vtkSmartPointer<vtkPolyData> MakePoints(int n)
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

// Some pattern; its last component, where there are four, goes from clear to opaque.
inline vtkSmartPointer<vtkTexture> MakeTexture(int components, int shift = 0)
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

// Six faces of smooth colours, a cube map.
inline vtkSmartPointer<vtkTexture> MakeCubeMap()
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

#endif
