// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameScene.h"

#include "RandomParts.h"

#include "vtkCubeAxesActor.h"
#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkPolyDataMapper.h"
#include "vtkProp3D.h"
#include "vtkProperty.h"
#include "vtkSphereSource.h"

#include <algorithm>

namespace airlight_test
{
//------------------------------------------------------------------------------
FrameScene::FrameScene(std::uint64_t seed, const std::string& photometry)
  : Seed(seed)
  , Group(seed / FrameGroupSize)
  , Photometry(photometry)
{
  Random random(Mix(21, seed));
  this->Steps = 1 + random.Index(4);
  // The whole scene is as large as a grain of sand or a country.
  this->Unit = random.Index(2) ? 1.0 : random.LogUniform(1e-3, 1e5);
  this->Note("unit ", this->Unit);
  this->Renderer->AutomaticLightCreationOff();
  this->Renderer->SetPass(this->Pass);
  this->PlaceCamera(random);
  this->SetUpPass(random);
  this->SetViewport(random);
  if (this->Group.Layered)
  {
    this->AddLayer();
  }
  this->AddLights(random);
  for (size_t i = 0; i < this->Group.Regions.size(); ++i)
  {
    this->AddMedium(i, random);
  }
  const int count = random.Index(5);
  for (int i = 0; i < count; ++i)
  {
    this->AddItem(random);
  }
  if (this->Group.Recent)
  {
    Random recent(Mix(31, seed));
    this->AddRecent(recent);
  }
}

//------------------------------------------------------------------------------
// In front of the scene, in it, or on whole numbers and along an axis.
void FrameScene::PlaceCamera(Random& random)
{
  const glm::dvec3 side = RandomUnit(random);
  glm::dvec3 focus = RandomPoint(random, 0.7);
  glm::dvec3 eye = random.Uniform(2.0, 7.0) * side;
  const int place = random.Index(4);
  if (place == 1)
  {
    eye = RandomPoint(random, 1.5);
  }
  else if (place == 2)
  {
    focus = glm::dvec3(0.0);
    eye = glm::dvec3(0.0);
    eye[random.Index(3)] = random.Index(2) ? 3.0 : -4.0;
  }
  vtkCamera* camera = this->Renderer->GetActiveCamera();
  camera->SetPosition(this->Unit * eye.x, this->Unit * eye.y, this->Unit * eye.z);
  camera->SetFocalPoint(this->Unit * focus.x, this->Unit * focus.y, this->Unit * focus.z);
  camera->SetViewUp(0.1, random.Uniform(0.5, 1.0), 0.2);
  camera->SetViewAngle(random.Index(4) ? random.Uniform(20.0, 70.0) : random.Uniform(1.0, 140.0));
  camera->SetParallelProjection(this->Group.Parallel);
  camera->SetParallelScale(this->Unit * random.LogUniform(0.5, 5.0));
  const double near = random.LogUniform(1e-2, 3e-1);
  camera->SetClippingRange(this->Unit * near, this->Unit * random.LogUniform(8.0, 1000.0));
  this->Note("camera ", Text3(&eye.x), " to ", Text3(&focus.x), " angle ", camera->GetViewAngle(),
    " near ", near);
}

//------------------------------------------------------------------------------
void FrameScene::SetUpPass(Random& random)
{
  const FrameGroup& group = this->Group;
  this->Pass->SetShadowTechnique(group.Technique);
  this->Pass->DitheringOff(); // pictures are compared with radiances, within their rounding
  this->Pass->SetShadowMapResolution(64);
  this->Pass->SetNumberOfSteps(16);
  this->Pass->SetScatteredSurfaceLight(group.ScatteredSurfaceLight);
  this->Pass->SetLinearInput(group.LinearInput);
  this->Pass->SetSurfaceShadows(random.Index(6) != 0);
  this->Pass->SetTranslucentShadows(random.Index(6) != 0);
  this->Pass->SetLightRadius(random.Index(3) ? this->Unit * random.LogUniform(1e-3, 1e-1) : 0.0);
  this->Renderer->SetUseFXAA(group.Fxaa);
  this->Renderer->SetUseDepthPeeling(group.Peeling);
  this->Renderer->SetMaximumNumberOfPeels(3);
  if (random.Index(3) == 0)
  {
    this->Renderer->SetBackground(0.1, random.Uniform(0.0, 1.0), 0.4);
  }
  this->Renderer->SetGradientBackground(random.Index(8) == 0);
}

//------------------------------------------------------------------------------
void FrameScene::SetViewport(Random& random)
{
  if (random.Index(4) == 0)
  {
    const double right = random.Uniform(0.6, 1.0);
    this->Renderer->SetViewport(random.Uniform(0.0, 0.4), 0.0, right, 1.0);
    this->Note("viewport to ", right);
  }
  else
  {
    this->Renderer->SetViewport(0.0, 0.0, 1.0, 1.0);
  }
}

//------------------------------------------------------------------------------
// A ball of VTK's own, without the pass.
void FrameScene::AddLayer()
{
  vtkNew<vtkPolyDataMapper> mapper;
  vtkNew<vtkSphereSource> ball;
  mapper->SetInputConnection(ball->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  this->Under = vtkSmartPointer<vtkRenderer>::New();
  this->Under->SetBackground(0.3, 0.2, 0.1);
  this->Under->AddActor(actor);
  this->Under->GetActiveCamera()->SetPosition(0.0, 0.0, 3.0);
  this->Under->GetActiveCamera()->SetClippingRange(0.1, 10.0);
  this->Renderer->SetLayer(1);
}

//------------------------------------------------------------------------------
void FrameScene::PlaceItem(FrameItem& item, Random& random)
{
  const double size = random.Index(8) ? random.LogUniform(0.2, 1.5) : random.LogUniform(1e-3, 1e3);
  const glm::dvec3 place = this->Unit * RandomPoint(random, 1.5);
  const glm::dvec3 axis = RandomUnit(random);
  const double angle = random.Index(3) ? random.Uniform(0.0, 180.0) : 0.0;
  const double mirror = random.Index(5) ? 1.0 : -1.0;
  const double scale = this->Unit * size;
  this->Note(
    GetFramePartName(item.Kind), " at ", Text3(&place.x), " size ", size, " mirror ", mirror);
  if (auto* axes = vtkCubeAxesActor::SafeDownCast(item.Prop))
  {
    double bounds[6];
    for (int i = 0; i < 6; ++i)
    {
      bounds[i] = place[i / 2] + (i % 2 ? scale : -scale);
    }
    axes->SetBounds(bounds);
    return;
  }
  std::vector<vtkProp3D*> props;
  if (auto* prop = vtkProp3D::SafeDownCast(item.Prop))
  {
    props.push_back(prop);
  }
  else
  {
    props.insert(props.end(), item.Actors.begin(), item.Actors.end());
  }
  for (vtkProp3D* prop : props)
  {
    prop->SetOrientation(0.0, 0.0, 0.0);
    prop->SetPosition(place.x, place.y, item.Kind == FRAME_GROUND ? 0.0 : place.z);
    prop->SetScale(scale, mirror * scale, scale);
    if (item.Kind != FRAME_GROUND)
    {
      prop->RotateWXYZ(angle, axis.x, axis.y, axis.z);
    }
  }
}

//------------------------------------------------------------------------------
void FrameScene::AddItem(Random& random)
{
  const int kind = this->Group.Parts[static_cast<size_t>(random.Index(3))];
  FrameItem item = MakeFrameItem(kind, random, this->Renderer->GetActiveCamera());
  this->PlaceItem(item, random);
  if (random.Index(8) == 0 && kind != FRAME_GLASS)
  {
    vtkNew<vtkInformation> keys;
    keys->Set(vtkAirlightPass::CASTS_SHADOW(), 0);
    item.Prop->SetPropertyKeys(keys);
    this->Note("no shadow");
  }
  this->Renderer->AddViewProp(item.Prop);
  this->Items.push_back(item);
}

//------------------------------------------------------------------------------
// What the buffers, which hold opaque surfaces and the medium, do not show.
bool FrameScene::MayBlend() const
{
  const auto isMesh = [](const FrameItem& item) {
    return item.Kind < FRAME_MESH_KINDS && item.Actors[0]->GetProperty()->GetOpacity() == 1.0;
  };
  return !this->Group.LinearInput || this->Group.Layered || this->Renderer->GetUseFXAA() ||
    !std::all_of(this->Items.begin(), this->Items.end(), isMesh);
}

//------------------------------------------------------------------------------
std::string FrameScene::Describe() const
{
  return airlight_test::Text(
    "seed ", this->Seed, ", ", this->Group.Describe(), "; ", this->Steps, " steps", this->Notes);
}
}
