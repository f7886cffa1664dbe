// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameScene.h"

#include "vtkActor.h"
#include "vtkActorCollection.h"
#include "vtkAirlight.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkMapper.h"
#include "vtkPolyData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRendererCollection.h"
#include "vtkSilhouetteEdgesFilter.h"

#include <chrono>
#include <cmath>
#include <ctime>
#include <sstream>

namespace benchmarks
{
namespace
{
// Null where the mapper draws anything else.
vtkPolyData* GetData(vtkActor* actor)
{
  vtkMapper* mapper = actor->GetMapper();
  if (!mapper || mapper->GetNumberOfInputConnections(0) == 0)
  {
    return nullptr;
  }
  mapper->Update();
  return vtkPolyData::SafeDownCast(mapper->GetInputDataObject(0, 0));
}

// "2e-3" for 0.002.
std::string FormatError(double error)
{
  const int power = static_cast<int>(std::floor(std::log10(error) + 1e-9));
  std::ostringstream text;
  text << error * std::pow(10.0, -power) << "e" << power;
  return text.str();
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

Way MakeUnshadowed() { return { "no shadows", false, vtkAirlightPass::NONE }; }

Way MakeAutomatic() { return { "automatic", false, vtkAirlightPass::AUTOMATIC }; }

Way MakePlanes(bool moves)
{
  return { moves ? "shadow planes, moving" : "shadow planes", false, vtkAirlightPass::SHADOW_PLANES,
    0, moves };
}

Way MakeSmooth(Way way, Antialiasing smooth)
{
  const char* names[] = { "", " in a multisampled window", ", multisampled", ", SSAA" };
  way.Name += names[static_cast<int>(smooth)];
  way.Smooth = smooth;
  return way;
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

Way MakeRayMarchTo(double error)
{
  return { "equiangular march to " + FormatError(error), false, vtkAirlightPass::RAY_MARCH, 0,
    false, error };
}

//------------------------------------------------------------------------------
FrameScene::FrameScene(vtkRenderWindow* window)
  : Window(window)
{
  this->Window->AddRenderer(this->Renderer);
  this->Renderer->AutomaticLightCreationOff();
  this->Medium->SetScattering(0.1, 0.1, 0.1);
  this->Medium->SetAbsorption(0.02, 0.02, 0.02);
  this->Pass->SetMedium(this->Medium);
  this->Larger->SetDelegatePass(this->Pass);
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
void FrameScene::AddMedium(vtkParticipatingMedium* medium) { this->Pass->AddMedium(medium); }

//------------------------------------------------------------------------------
vtkActor* FrameScene::GetFirstActor()
{
  return vtkActor::SafeDownCast(this->Renderer->GetActors()->GetItemAsObject(0));
}

vtkLight* FrameScene::GetFirstLamp()
{
  return vtkLight::SafeDownCast(this->Renderer->GetLights()->GetItemAsObject(0));
}

//------------------------------------------------------------------------------
FrameScene::~FrameScene() { this->Window->RemoveRenderer(this->Renderer); }

//------------------------------------------------------------------------------
vtkIdType FrameScene::CountTriangles()
{
  vtkIdType count = 0;
  vtkActorCollection* actors = this->Renderer->GetActors();
  vtkCollectionSimpleIterator it = nullptr;
  actors->InitTraversal(it);
  while (vtkActor* actor = actors->GetNextActor(it))
  {
    if (vtkPolyData* data = GetData(actor))
    {
      vtkCellArray* polys = data->GetPolys(); // of n corners n - 2 triangles
      count += polys->GetNumberOfConnectivityIds() - 2 * polys->GetNumberOfCells();
    }
  }
  return count;
}

//------------------------------------------------------------------------------
// The actors have not been moved yet: their data are in world coordinates.
vtkIdType FrameScene::CountSilhouetteEdges()
{
  vtkIdType count = 0;
  vtkActorCollection* actors = this->Renderer->GetActors();
  vtkCollectionSimpleIterator it = nullptr;
  actors->InitTraversal(it);
  while (vtkActor* actor = actors->GetNextActor(it))
  {
    vtkPolyData* data = GetData(actor);
    count += data && data->GetNumberOfPolys() > 0 ? this->CountSilhouetteEdges(data) : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
vtkIdType FrameScene::CountSilhouetteEdges(vtkPolyData* data)
{
  vtkIdType count = 0;
  vtkNew<vtkSilhouetteEdgesFilter> filter;
  filter->SetInputData(data);
  vtkLightCollection* lights = this->Renderer->GetLights();
  for (int i = 0; i < lights->GetNumberOfItems(); ++i)
  {
    auto* light = vtkLight::SafeDownCast(lights->GetItemAsObject(i));
    if (light->LightTypeIsSceneLight())
    {
      filter->SetLight(light);
      filter->Update();
      count += filter->GetOutput()->GetNumberOfLines();
    }
  }
  return count;
}

//------------------------------------------------------------------------------
// Scenes that share a window are drawn one at a time.
void FrameScene::Set(const Way& way)
{
  vtkRendererCollection* renderers = this->Window->GetRenderers();
  vtkCollectionSimpleIterator it = nullptr;
  renderers->InitTraversal(it);
  while (vtkRenderer* renderer = renderers->GetNextRenderer(it))
  {
    renderer->SetDraw(renderer == this->Renderer);
  }
  vtkRenderPass* pass = this->Pass;
  if (way.Smooth == Antialiasing::Larger)
  {
    pass = this->Larger;
  }
  this->Renderer->SetPass(way.Plain ? nullptr : pass);
  this->Pass->SetShadowTechnique(way.Technique);
  const bool samples = way.Smooth == Antialiasing::Window || way.Smooth == Antialiasing::Edges;
  this->Window->SetMultiSamples(samples ? 4 : 0);
  this->Pass->SetMultisampling(way.Smooth == Antialiasing::Edges);
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
    vtkLight* lamp = this->GetFirstLamp();
    const double* p = lamp->GetPosition();
    lamp->SetPosition(p[0] + 0.1 * angle, p[1], p[2] + 0.05 * angle);
    this->GetFirstActor()->AddPosition(0.1 * angle, 0.0, 0.0);
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
  return this->TimeOne(way);
}

FrameTime FrameScene::TimeOne(const Way& way)
{
  this->Set(way);
  this->Turn(way);
  const std::clock_t processor = std::clock(); // of all threads
  const auto clock = std::chrono::steady_clock::now();
  this->Draw();
  const std::chrono::duration<double> duration = std::chrono::steady_clock::now() - clock;
  return { duration.count(), double(std::clock() - processor) / CLOCKS_PER_SEC };
}

//------------------------------------------------------------------------------
bool FrameScene::IsDrawnAs(const Way& way)
{
  return way.Plain || way.Technique == vtkAirlightPass::AUTOMATIC ||
    this->Pass->GetEffectiveShadowTechnique() == way.Technique;
}

//------------------------------------------------------------------------------
vtkAirlightPass* FrameScene::Record(const Way& way)
{
  this->Set(way);
  this->Pass->RecordBuffersOn();
  this->Draw();
  this->Pass->RecordBuffersOff();
  return this->Pass;
}
}
