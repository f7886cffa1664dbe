// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A small scene in a medium, drawn by vtkAirlightPass and compared with AirlightBruteForce.h.
 */

#ifndef AirlightTestScene_h
#define AirlightTestScene_h

#include "AirlightTestBuffers.h"

#include "vtkActor.h"
#include "vtkAirlightPass.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <functional>
#include <string>

namespace airlighttest
{
//------------------------------------------------------------------------------
// A copy of what the source makes, changed by nobody else.
inline vtkSmartPointer<vtkPolyData> Make(vtkPolyDataAlgorithm* source)
{
  source->Update();
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->DeepCopy(source->GetOutput());
  return data;
}

inline vtkSmartPointer<vtkPolyData> MakeSphere(double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(24);
  sphere->SetPhiResolution(24);
  return Make(sphere);
}

// Triangles that share nothing: each has its own three points.
inline vtkSmartPointer<vtkPolyData> MakeSoup(const std::vector<Triangle>& triangles)
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> cells;
  for (const Triangle& t : triangles)
  {
    vtkIdType ids[3];
    const glm::dvec3* corners[3] = { &t.A, &t.B, &t.C };
    for (int i = 0; i < 3; ++i)
    {
      ids[i] = points->InsertNextPoint(corners[i]->x, corners[i]->y, corners[i]->z);
    }
    cells->InsertNextCell(3, ids);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(cells);
  return data;
}

//------------------------------------------------------------------------------
inline glm::dvec3 TransformPoint(vtkMatrix4x4* matrix, const double p[3])
{
  const double in[4] = { p[0], p[1], p[2], 1.0 };
  glm::dvec4 out;
  matrix->MultiplyPoint(in, &out.x);
  return glm::dvec3(out);
}

// The triangles of convex polygons and of strips, in world coordinates.
inline std::vector<Triangle> GetTriangles(vtkPolyData* data, vtkMatrix4x4* matrix)
{
  std::vector<Triangle> result;
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  const auto corner = [&](int i) {
    double p[3];
    data->GetPoint(ids[i], p);
    return TransformPoint(matrix, p);
  };
  vtkCellArray* polygons = data->GetPolys();
  for (polygons->InitTraversal(); polygons->GetNextCell(size, ids);)
  {
    for (int i = 2; i < size; ++i)
    {
      result.push_back({ corner(0), corner(i - 1), corner(i) });
    }
  }
  vtkCellArray* strips = data->GetStrips();
  for (strips->InitTraversal(); strips->GetNextCell(size, ids);)
  {
    for (int i = 2; i < size; ++i)
    {
      result.push_back({ corner(i - 2), corner(i - 1), corner(i) });
    }
  }
  return result;
}

//------------------------------------------------------------------------------
class Scene
{
public:
  explicit Scene(int width = 200, int height = 150)
    : Width(width)
    , Height(height)
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(width, height);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetPass(this->Pass);
    this->Medium->SetScattering(0.05, 0.07, 0.1);
    this->Medium->SetAbsorption(0.02, 0.02, 0.01);
    this->Pass->SetMedium(this->Medium);
    this->Pass->RecordBuffersOn();
    this->Look({ 0, 1, 10 }, { 0, 0, 0 });
  }

  void Look(const glm::dvec3& from, const glm::dvec3& to)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    camera->SetPosition(from.x, from.y, from.z);
    camera->SetFocalPoint(to.x, to.y, to.z);
    camera->SetViewAngle(50.0);
    camera->SetClippingRange(0.1, 200.0);
  }

  vtkLight* AddPointLight(
    const glm::dvec3& position, const glm::dvec3& intensity = glm::dvec3(40.0, 30.0, 20.0))
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    vtkAirlight::SetRadiantIntensity(light, &intensity.x);
    light->SetPosition(position.x, position.y, position.z);
    return this->AddLight(light);
  }

  // `towards` points to the light.
  vtkLight* AddDirectionalLight(
    const glm::dvec3& towards, const glm::dvec3& irradiance = glm::dvec3(3.0))
  {
    vtkNew<vtkLight> light;
    light->SetLightTypeToSceneLight();
    vtkAirlight::SetIrradiance(light, &irradiance.x);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->SetPosition(towards.x, towards.y, towards.z);
    return this->AddLight(light);
  }

  vtkLight* AddLight(vtkLight* light)
  {
    this->Renderer->AddLight(light);
    this->Lights.push_back(light);
    return light;
  }

  // White and diffuse, one normal a triangle.
  static vtkSmartPointer<vtkActor> MakeActor(vtkMapper* mapper)
  {
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetInterpolationToFlat();
    return actor;
  }

  static vtkSmartPointer<vtkActor> MakeActor(vtkPolyData* data)
  {
    vtkNew<vtkPolyDataMapper> mapper;
    mapper->SetInputData(data);
    mapper->ScalarVisibilityOff();
    return MakeActor(mapper);
  }

  vtkActor* Add(vtkPolyData* data, const std::function<void(vtkActor*)>& place = {})
  {
    vtkSmartPointer<vtkActor> actor = MakeActor(data);
    if (place)
    {
      place(actor);
    }
    this->Renderer->AddActor(actor);
    this->AddTriangles(data, actor->GetMatrix());
    return actor;
  }

  vtkActor* Add(vtkPolyDataAlgorithm* source, const std::function<void(vtkActor*)>& place = {})
  {
    return this->Add(Make(source), place);
  }

  // To the reference only.
  void AddTriangles(vtkPolyData* data, vtkMatrix4x4* matrix)
  {
    const std::vector<Triangle> triangles = GetTriangles(data, matrix);
    this->Triangles.insert(this->Triangles.end(), triangles.begin(), triangles.end());
  }

  // The ray of a point of the picture, in pixels from the lower left corner.
  Ray GetRay(double px, double py)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    glm::dvec3 eye, focus, up;
    camera->GetPosition(&eye.x);
    camera->GetFocalPoint(&focus.x);
    camera->GetViewUp(&up.x);
    const glm::dvec3 forward = glm::normalize(focus - eye);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, up));
    const double x = (2.0 * px - this->Width) / this->Height;
    const double y = 2.0 * py / this->Height - 1.0;
    const glm::dvec3 across = x * right + y * glm::cross(right, forward);
    if (camera->GetParallelProjection())
    {
      return { eye + camera->GetParallelScale() * across, forward, camera->GetClippingRange()[0] };
    }
    const double slope = std::tan(glm::radians(0.5 * camera->GetViewAngle()));
    const glm::dvec3 along = forward + slope * across; // one unit deep
    return { eye, glm::normalize(along), camera->GetClippingRange()[0] * glm::length(along) };
  }

  Answer GetAnswer(double px, double py)
  {
    return Trace(this->Triangles, this->Lights, this->Medium, this->GetRay(px, py));
  }

  vtkImageData* GetBuffer(const char* name) { return this->Pass->GetBuffer(name); }

  // The last frame's buffers, kept.
  Buffers CopyBuffers()
  {
    Buffers copies;
    for (const char* name : { "Radiance", "Airlight", "Surface", "Transmittance", "Depth",
           "LitLength", "BoundaryCount", "ErrorBound" })
    {
      copies[name] = vtkSmartPointer<vtkImageData>::New();
      if (Check(this->GetBuffer(name) != nullptr, std::string("there is a buffer ") + name))
      {
        copies[name]->DeepCopy(this->GetBuffer(name));
      }
    }
    return copies;
  }

  Buffers Render()
  {
    this->Window->Render();
    return this->CopyBuffers();
  }

  int Width;
  int Height;
  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkAirlightPass> Pass;
  vtkNew<vtkParticipatingMedium> Medium;
  std::vector<vtkLight*> Lights;
  std::vector<Triangle> Triangles;
};
}

#endif
