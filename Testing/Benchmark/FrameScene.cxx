// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameScene.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkAirlight.h"
#include "vtkAirlightReference.h"
#include "vtkCamera.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <chrono>
#include <cmath>
#include <ctime>

namespace benchmarks
{
namespace
{
constexpr int ErrorWidth = 160; // of the pictures that errors are measured in
constexpr int ErrorHeight = 120;

constexpr double SameDepth = 1e-3;

// Whether both see the same surface, or none: -1 stands for none.
bool IsSame(double depth, double expected)
{
  return std::abs(depth - expected) <= SameDepth * std::abs(expected);
}
}

//------------------------------------------------------------------------------
Way MakePlain()
{
  Way way;
  way.Name = "plain";
  way.Plain = true;
  return way;
}

Way MakeUnshadowed() { return { "no shadows", false, vtkAirlightPass::NONE, 0, false }; }

Way MakePlanes(bool moves)
{
  return { moves ? "shadow planes, moving" : "shadow planes", false, vtkAirlightPass::SHADOW_PLANES,
    0, moves };
}

Way MakeShadowMap(int steps)
{
  return { "shadow map, " + std::to_string(steps) + " steps", false, vtkAirlightPass::SHADOW_MAP,
    steps, false };
}

Way MakeRayMarch(int steps)
{
  return { "equiangular march, " + std::to_string(steps) + " steps", false,
    vtkAirlightPass::RAY_MARCH, steps, false };
}

//------------------------------------------------------------------------------
FrameScene::FrameScene(int width, int height)
{
  this->Window->SetOffScreenRendering(1);
  this->Window->SetMultiSamples(0);
  this->Window->SetSize(width, height);
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->AutomaticLightCreationOff();
  this->Medium->SetScattering(0.1, 0.1, 0.1);
  this->Medium->SetAbsorption(0.02, 0.02, 0.02);
  this->Pass->SetMedium(this->Medium);
}

//------------------------------------------------------------------------------
vtkActor* FrameScene::Add(vtkPolyData* data)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputData(data);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(0.8, 0.75, 0.7);
  this->Renderer->AddActor(actor);
  return actor;
}

//------------------------------------------------------------------------------
vtkLight* FrameScene::AddLamp(double x, double y, double z)
{
  vtkNew<vtkLight> lamp;
  const double intensity[3] = { 30.0, 28.0, 25.0 };
  vtkAirlight::SetRadiantIntensity(lamp, intensity);
  lamp->SetLightTypeToSceneLight();
  lamp->SetPosition(x, y, z);
  this->Renderer->AddLight(lamp);
  return lamp;
}

//------------------------------------------------------------------------------
vtkIdType FrameScene::CountTriangles()
{
  vtkIdType count = 0;
  vtkActorCollection* actors = this->Renderer->GetActors();
  vtkCollectionSimpleIterator it = nullptr;
  actors->InitTraversal(it);
  while (vtkActor* actor = actors->GetNextActor(it))
  {
    count +=
      vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0))->GetNumberOfPolys();
  }
  return count;
}

//------------------------------------------------------------------------------
void FrameScene::Set(const Way& way)
{
  this->Renderer->SetPass(way.Plain ? nullptr : this->Pass.Get());
  this->Pass->SetShadowTechnique(way.Technique);
  if (way.Steps > 0)
  {
    this->Pass->SetNumberOfSteps(way.Steps);
  }
}

//------------------------------------------------------------------------------
// To and fro, so that the frames of all ways see the same on average.
void FrameScene::Turn(const Way& way)
{
  const double angle = this->Frames++ % 2 == 0 ? 0.4 : -0.4;
  this->Renderer->GetActiveCamera()->Azimuth(angle);
  if (way.Moves)
  {
    auto* lamp = vtkLight::SafeDownCast(this->Renderer->GetLights()->GetItemAsObject(0));
    const double* p = lamp->GetPosition();
    lamp->SetPosition(p[0] + 0.1 * angle, p[1], p[2] + 0.05 * angle);
    auto* actor = vtkActor::SafeDownCast(this->Renderer->GetActors()->GetItemAsObject(0));
    actor->AddPosition(0.1 * angle, 0.0, 0.0);
  }
}

//------------------------------------------------------------------------------
void FrameScene::Draw()
{
  this->Window->Render();
  this->Window->WaitForCompletion();
}

//------------------------------------------------------------------------------
FrameTime FrameScene::Time(const Way& way)
{
  this->Set(way);
  this->Turn(way);
  this->Draw();
  this->Turn(way);
  const std::clock_t processor = std::clock(); // of all threads
  const auto clock = std::chrono::steady_clock::now();
  this->Draw();
  const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - clock;
  return { duration.count(), double(std::clock() - processor) / CLOCKS_PER_SEC };
}

//------------------------------------------------------------------------------
double FrameScene::MeasureError(const Way& way, vtkPointData* expected)
{
  this->Set(way);
  this->Pass->RecordBuffersOn();
  this->Draw();
  vtkDataArray* airlight = this->Pass->GetBuffer("Airlight")->GetPointData()->GetScalars();
  vtkDataArray* depth = this->Pass->GetBuffer("Depth")->GetPointData()->GetScalars();
  vtkDataArray* expectedAirlight = expected->GetArray("Airlight");
  vtkDataArray* expectedDepth = expected->GetArray("Depth");
  double squares = 0.0;
  double sum = 0.0;
  double count = 0.0;
  for (vtkIdType i = 0; i < expectedAirlight->GetNumberOfTuples(); ++i)
  {
    for (int j = 0; j < 3 && IsSame(depth->GetTuple1(i), expectedDepth->GetTuple1(i)); ++j)
    {
      const double value = expectedAirlight->GetComponent(i, j);
      squares += std::pow(airlight->GetComponent(i, j) - value, 2);
      sum += value;
      ++count;
    }
  }
  this->Pass->RecordBuffersOff();
  return std::sqrt(squares / count) / (sum / count);
}

//------------------------------------------------------------------------------
std::map<std::string, double> FrameScene::MeasureErrors(const std::vector<Way>& ways)
{
  vtkNew<vtkAirlightReference> reference;
  reference->SetRenderer(this->Renderer);
  reference->SetMedium(this->Medium);
  reference->SetSize(ErrorWidth, ErrorHeight);
  reference->Update();
  const int* size = this->Window->GetSize();
  const int width = size[0];
  const int height = size[1];
  this->Window->SetSize(ErrorWidth, ErrorHeight);
  std::map<std::string, double> errors;
  for (const Way& way : ways)
  {
    if (!way.Plain)
    {
      errors[way.Name] = this->MeasureError(way, reference->GetOutput()->GetPointData());
    }
  }
  this->Window->SetSize(width, height);
  return errors;
}
}
