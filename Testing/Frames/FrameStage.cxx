// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameStage.h"

#include "vtkAirlight.h"
#include "vtkPolyDataMapper.h"
#include "vtkSphereSource.h"
#include "vtkUnsignedCharArray.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
FrameStage::FrameStage()
{
  for (auto& window : this->Windows)
  {
    window = vtkSmartPointer<vtkRenderWindow>::New();
    window->SetOffScreenRendering(1);
    window->SetMultiSamples(0);
    window->SetAlphaBitPlanes(1);
    window->SetDesiredUpdateRate(1e-4); // levels of detail must not follow from time
  }
}

//------------------------------------------------------------------------------
FrameStage::~FrameStage() { this->Clear(); }

//------------------------------------------------------------------------------
void FrameStage::Clear()
{
  for (auto& window : this->Windows)
  {
    window->Finalize();
  }
}

//------------------------------------------------------------------------------
void FrameStage::Add(vtkRenderWindow* window, FrameScene& scene)
{
  window->SetNumberOfLayers(scene.Under ? 2 : 1);
  if (scene.Under)
  {
    window->AddRenderer(scene.Under);
  }
  window->AddRenderer(scene.Renderer);
}

//------------------------------------------------------------------------------
void FrameStage::Remove(vtkRenderWindow* window, FrameScene& scene)
{
  window->RemoveRenderer(scene.Renderer);
  if (scene.Under)
  {
    window->RemoveRenderer(scene.Under);
  }
  window->SetNumberOfLayers(1);
}

//------------------------------------------------------------------------------
void FrameStage::SetPass(vtkRenderer* renderer, FrameScene& scene) const
{
  renderer->SetPass(this->UsesPass ? scene.Pass.Get() : nullptr);
}

//------------------------------------------------------------------------------
void FrameStage::Enter(FrameScene& scene)
{
  this->SetPass(scene.Renderer, scene);
  this->GetWindow(scene)->SetSize(scene.Size);
  Add(this->GetWindow(scene), scene);
}

//------------------------------------------------------------------------------
void FrameStage::Leave(FrameScene& scene)
{
  scene.Pass->ReleaseGraphicsResources(this->GetWindow(scene));
  scene.Renderer->SetPass(nullptr);
  Remove(this->GetWindow(scene), scene);
}

//------------------------------------------------------------------------------
// The same pass in the other window, at a ball that casts a shadow.
void FrameStage::DrawOther(FrameScene& scene)
{
  vtkRenderWindow* window = this->Windows[1 - scene.Window];
  vtkNew<vtkRenderer> renderer;
  renderer->AutomaticLightCreationOff();
  vtkNew<vtkSphereSource> ball;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  renderer->AddActor(actor);
  vtkNew<vtkLight> light;
  const double power[3] = { 3.0, 4.0, 5.0 };
  vtkAirlight::SetRadiantIntensity(light, power);
  light->SetLightTypeToSceneLight();
  light->SetPosition(0.0, 2.0, 1.0);
  renderer->AddLight(light);
  renderer->GetActiveCamera()->SetPosition(0.0, 0.0, 3.0);
  renderer->GetActiveCamera()->SetClippingRange(0.1, 20.0);
  this->SetPass(renderer, scene);
  window->SetSize(20, 20);
  window->AddRenderer(renderer);
  window->Render();
  renderer->SetPass(nullptr);
  window->RemoveRenderer(renderer);
}

//------------------------------------------------------------------------------
void FrameStage::Apply(FrameScene& scene, FrameWindowEvent event)
{
  vtkRenderWindow* window = this->GetWindow(scene);
  vtkRenderWindow* other = this->Windows[1 - scene.Window];
  switch (event)
  {
    case EVENT_FINALIZE:
      window->Finalize();
      break;
    case EVENT_RELEASE:
      scene.Pass->ReleaseGraphicsResources(window);
      break;
    case EVENT_MOVE_RENDERER:
      Remove(other, scene);
      Add(window, scene);
      break;
    case EVENT_MOVE_PASS:
      scene.Renderer->SetPass(nullptr);
      Remove(other, scene);
      Add(window, scene);
      this->SetPass(scene.Renderer, scene);
      break;
    case EVENT_SHARE:
      this->DrawOther(scene);
      break;
    case EVENT_PLAIN:
      scene.Renderer->SetPass(nullptr);
      window->Render();
      this->SetPass(scene.Renderer, scene);
      break;
    default:
      break;
  }
  window->SetSize(scene.Size);
}

//------------------------------------------------------------------------------
FrameRecord FrameStage::Draw(FrameScene& scene, bool record)
{
  vtkRenderWindow* window = this->GetWindow(scene);
  scene.Pass->SetRecordBuffers(record);
  window->Render();
  FrameRecord frame;
  std::vector<std::string> names = { "Radiance", "Airlight", "Surface", "Transmittance", "Depth",
    "LitLength", "BoundaryCount", "ErrorBound" };
  for (size_t i = 0; i < scene.Lights.size(); ++i)
  {
    names.push_back("Airlight:" + std::to_string(i));
  }
  for (const std::string& name : names)
  {
    vtkImageData* buffer = record && this->UsesPass ? scene.Pass->GetBuffer(name.c_str()) : nullptr;
    if (buffer)
    {
      frame.Buffers[name] = vtkSmartPointer<vtkImageData>::New();
      frame.Buffers[name]->DeepCopy(buffer);
    }
  }
  const int* origin = scene.Renderer->GetOrigin();
  const int* size = scene.Renderer->GetSize();
  vtkNew<vtkUnsignedCharArray> pixels;
  window->GetPixelData(
    origin[0], origin[1], origin[0] + size[0] - 1, origin[1] + size[1] - 1, 1, pixels);
  frame.Picture.assign(pixels->GetPointer(0), pixels->GetPointer(0) + pixels->GetNumberOfValues());
  return frame;
}
}
