// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestPixelScene.h"

#include <cmath>

namespace airlight_test
{
namespace
{
glm::dvec3 Vector(const double* v) { return { v[0], v[1], v[2] }; }
}

//------------------------------------------------------------------------------
PixelScene::PixelScene()
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(Width, Height);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->SetBackground(0.0, 0.0, 0.0);
  this->Renderer->AutomaticLightCreationOff();
  this->Renderer->SetPass(this->Pass);
  this->Pass->RecordBuffersOn();
  this->Pass->SetMedium(this->Medium);
}

PixelScene::~PixelScene() { this->Pass->ReleaseGraphicsResources(this->Window); }

//------------------------------------------------------------------------------
void PixelScene::AddPlane(
  const glm::dvec3& corner, const glm::dvec3& first, const glm::dvec3& second)
{
  this->Plane->SetOrigin(corner.x, corner.y, corner.z);
  this->Plane->SetPoint1(first.x, first.y, first.z);
  this->Plane->SetPoint2(second.x, second.y, second.z);
  this->Mapper->SetInputConnection(this->Plane->GetOutputPort());
  this->Actor->SetMapper(this->Mapper);
  this->Renderer->AddActor(this->Actor);
}

void PixelScene::AddTiltedPlane()
{
  this->AddPlane({ -2.0, -3.0, -1.0 }, { 1.5, -2.5, 0.5 }, { -1.0, 2.0, -0.5 });
  this->Renderer->AddLight(this->Light);
  this->Pass->SetShadowTechniqueToNone();
}

void PixelScene::AddBroadPlane(const glm::dvec3& colour)
{
  this->AddPlane({ -20.0, -20.0, 0.0 }, { 20.0, -20.0, 0.0 }, { -20.0, 20.0, 0.0 });
  this->Actor->GetProperty()->SetColor(colour.x, colour.y, colour.z);
  this->Actor->GetProperty()->SetDiffuse(1.0);
  this->Actor->GetProperty()->SetAmbient(0.0);
  this->Actor->GetProperty()->SetSpecular(0.0);
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(1.0, -3.0, 5.0);
  camera->SetFocalPoint(0.2, 0.5, 0.0);
  camera->SetViewUp(0.0, 1.0, 0.3);
}

void PixelScene::RenderFitted()
{
  this->Renderer->ResetCameraClippingRange();
  this->Window->Render();
}

//------------------------------------------------------------------------------
PixelRay PixelScene::GetRay(double i, double j)
{
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  const glm::dvec3 position = Vector(camera->GetPosition());
  const glm::dvec3 forward = glm::normalize(Vector(camera->GetFocalPoint()) - position);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, Vector(camera->GetViewUp())));
  const glm::dvec3 up = glm::cross(right, forward);
  const double y = (2.0 * (j + 0.5) - Height) / Height;
  const double x = (2.0 * (i + 0.5) - Width) / Height; // the aspect ratio is in it
  if (camera->GetParallelProjection())
  {
    const double scale = camera->GetParallelScale(); // half the height
    return { position + scale * (x * right + y * up), forward };
  }
  const double half = std::tan(glm::radians(0.5 * camera->GetViewAngle()));
  return { position, glm::normalize(forward + half * (x * right + y * up)) };
}

const float* PixelScene::GetPixel(const char* name, int i, int j)
{
  vtkImageData* image = this->Pass->GetBuffer(name);
  return image ? static_cast<float*>(image->GetScalarPointer(i, j, 0)) : nullptr;
}

double PixelScene::GetEnd(int i, int j)
{
  const float depth = *this->GetPixel("Depth", i, j);
  return depth >= 0.0f ? depth : 1e18;
}
}
