// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestScene.h"

#include "vtkCubeSource.h"
#include "vtkRegressionTestImage.h"
#include "vtkShaderProperty.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cstdlib>
#include <string>

namespace airlight_test
{
//------------------------------------------------------------------------------
Scene::Scene(int width, int height)
  : Width(width)
  , Height(height)
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Medium->SetScattering(0.05, 0.07, 0.1);
  this->Medium->SetAbsorption(0.02, 0.02, 0.01);
  this->Restart();
}

Scene::~Scene()
{
  if (this->ReleasesPass)
  {
    this->ReleasePass();
  }
}

// OpenGL objects go while there is a context.
void Scene::ReleasePass()
{
  this->Pass->ReleaseGraphicsResources(this->Window);
  this->Renderer->SetPass(nullptr);
}

void Scene::Restart()
{
  if (this->Renderer)
  {
    this->ReleasePass();
    this->Window->RemoveRenderer(this->Renderer);
    this->ReleasesPass = true;
  }
  this->Lights.clear();
  this->Triangles.clear();
  this->Renderer = vtkSmartPointer<vtkRenderer>::New();
  this->Pass = vtkSmartPointer<vtkAirlightPass>::New();
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->AutomaticLightCreationOff();
  this->Renderer->SetPass(this->Pass);
  this->Pass->SetMedium(this->Medium);
  this->Pass->RecordBuffersOn();
  this->Look({ 0, 1, 10 }, { 0, 0, 0 });
}

void Scene::Look(const glm::dvec3& from, const glm::dvec3& to)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(from.x, from.y, from.z);
  camera->SetFocalPoint(to.x, to.y, to.z);
  camera->SetViewAngle(50.0);
  camera->SetClippingRange(0.1, 200.0);
}

//------------------------------------------------------------------------------
vtkLight* Scene::AddPointLight(const glm::dvec3& position, const glm::dvec3& intensity)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  vtkAirlight::SetRadiantIntensity(light, &intensity.x);
  light->SetPosition(position.x, position.y, position.z);
  return this->AddLight(light);
}

vtkLight* Scene::AddDirectionalLight(const glm::dvec3& towards, const glm::dvec3& irradiance)
{
  vtkNew<vtkLight> light;
  light->SetLightTypeToSceneLight();
  vtkAirlight::SetIrradiance(light, &irradiance.x);
  light->SetFocalPoint(0.0, 0.0, 0.0);
  light->SetPosition(towards.x, towards.y, towards.z);
  return this->AddLight(light);
}

vtkLight* Scene::AddLight(vtkLight* light)
{
  this->Renderer->AddLight(light);
  this->Lights.push_back(light);
  return light;
}

//------------------------------------------------------------------------------
vtkSmartPointer<vtkActor> Scene::MakeActor(vtkMapper* mapper)
{
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetInterpolationToFlat();
  return actor;
}

vtkSmartPointer<vtkActor> Scene::MakeActor(vtkPolyData* data)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  return MakeActor(mapper);
}

vtkActor* Scene::Add(vtkPolyData* data, const std::function<void(vtkActor*)>& place)
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

vtkActor* Scene::Add(vtkPolyDataAlgorithm* source, const std::function<void(vtkActor*)>& place)
{
  return this->Add(Make(source), place);
}

void Scene::AddTriangles(vtkPolyData* data, vtkMatrix4x4* matrix)
{
  const std::vector<Triangle> triangles = GetTriangles(data, matrix);
  this->Triangles.insert(this->Triangles.end(), triangles.begin(), triangles.end());
}

void Scene::Paint(vtkActor* actor, const glm::dvec3& albedo, double ambient)
{
  actor->GetProperty()->SetColor(albedo.x, albedo.y, albedo.z);
  actor->GetProperty()->SetAmbient(ambient);
}

vtkActor* Scene::AddBox(const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& albedo)
{
  vtkNew<vtkCubeSource> cube;
  cube->SetBounds(low.x, high.x, low.y, high.y, low.z, high.z);
  vtkActor* actor = this->Add(cube);
  Paint(actor, albedo, this->AmbientLight);
  return actor;
}

vtkActor* Scene::AddBall(const glm::dvec3& centre, double radius, const glm::dvec3& albedo)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(centre.x, centre.y, centre.z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(48);
  sphere->SetPhiResolution(48);
  vtkActor* actor = this->Add(sphere);
  actor->GetProperty()->SetInterpolationToPhong();
  Paint(actor, albedo, this->AmbientLight);
  return actor;
}

//------------------------------------------------------------------------------
Ray Scene::GetRay(double px, double py) const
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

Answer Scene::GetAnswer(double px, double py)
{
  return Trace(this->Triangles, this->Lights, this->Medium, this->GetRay(px, py));
}

// The picture's middle and the rays one pixel beside it and above it span the view.
glm::ivec2 Scene::GetPixel(const glm::dvec3& point) const
{
  const glm::dvec2 middle(0.5 * this->Width, 0.5 * this->Height);
  const Ray centre = this->GetRay(middle.x, middle.y);
  const auto perPixel = [&](double x, double y) {
    const glm::dvec3 d = this->GetRay(middle.x + x, middle.y + y).Direction;
    return d / glm::dot(d, centre.Direction) - centre.Direction;
  };
  const glm::dvec3 right = perPixel(1.0, 0.0);
  const glm::dvec3 up = perPixel(0.0, 1.0);
  glm::dvec3 along = point - centre.Origin;
  along /= glm::dot(along, centre.Direction);
  return { static_cast<int>(middle.x + glm::dot(along, right) / glm::dot(right, right)),
    static_cast<int>(middle.y + glm::dot(along, up) / glm::dot(up, up)) };
}

//------------------------------------------------------------------------------
Buffers Scene::CopyBuffers()
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

Buffers Scene::Render()
{
  this->Window->Render();
  return this->CopyBuffers();
}

double Scene::GetPercentile99(const char* name)
{
  std::vector<double> values;
  for (int pixel = 0; pixel < this->Width * this->Height; ++pixel)
  {
    const glm::dvec3 rgb =
      GetColour(this->GetBuffer(name), pixel % this->Width, pixel / this->Width);
    values.push_back(std::max({ rgb.x, rgb.y, rgb.z }));
  }
  return Quantile(values, 0.99);
}

//------------------------------------------------------------------------------
Picture Scene::Show(vtkRenderPass* pass)
{
  this->ReleasesPass = true;
  this->Renderer->SetPass(pass);
  return Capture(this->Window);
}

Picture Scene::ShowOnce(vtkRenderPass* pass)
{
  const Picture picture = this->Show(pass);
  pass->ReleaseGraphicsResources(this->Window);
  this->Renderer->SetPass(nullptr);
  return picture;
}

void Scene::SmoothEdges()
{
  this->Antialiased->SetDelegatePass(this->Pass);
  this->Renderer->SetPass(this->Antialiased);
}

// vtkRegressionTestImage() takes the arguments by their names.
int Scene::Finish(int argc, char* argv[])
{
  const int result = vtkRegressionTestImage(this->Window);
  return result != vtkTesting::FAILED && Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}

//------------------------------------------------------------------------------
glm::dvec4 Project(vtkCamera* camera, double aspect, const glm::dvec3& point)
{
  const double in[4] = { point.x, point.y, point.z, 1.0 };
  glm::dvec4 clip;
  camera->GetCompositeProjectionTransformMatrix(aspect, -1, 1)->MultiplyPoint(in, &clip.x);
  return clip;
}

//------------------------------------------------------------------------------
bool IsInPicture(const glm::dvec4& clip)
{
  return clip.w > 0.0 && std::abs(clip.x) <= clip.w && std::abs(clip.y) <= clip.w;
}

//------------------------------------------------------------------------------
void MakeUnknown(vtkActor* actor)
{
  actor->GetShaderProperty()->AddFragmentShaderReplacement(
    "//VTK::Color::Impl", true, "//VTK::Color::Impl\n // as it was\n", false);
}
}
