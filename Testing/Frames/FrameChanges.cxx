// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// How a random scene changes between two frames.

#include "FrameScene.h"

#include "RandomParts.h"

#include "vtkInformation.h"
#include "vtkInformationIntegerKey.h"
#include "vtkMapper.h"
#include "vtkPlane.h"
#include "vtkPointGaussianMapper.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"

#include <algorithm>

namespace airlight_test
{
namespace
{
bool IsEmissive(vtkActor* actor)
{
  auto* mapper = vtkPointGaussianMapper::SafeDownCast(actor->GetMapper());
  return mapper && mapper->GetEmissive();
}
}

//------------------------------------------------------------------------------
// The mesh stays the same object, or is another one.
void FrameScene::ChangeMesh(FrameItem& item, Random& random)
{
  const int change = random.Index(6);
  this->Note("mesh change ", change);
  vtkPolyData* mesh = item.Mesh;
  switch (change)
  {
    case 0:
    case 1: // points that are older than the cells
    {
      const vtkSmartPointer<vtkPoints> points = mesh->GetPoints();
      mesh->SetPoints(item.Points);
      item.Points = points;
      break;
    }
    case 2: // older polygons
      mesh->SetPolys(item.Cells->GetPolys());
      break;
    case 3: // older strips
      mesh->SetStrips(item.Cells->GetStrips());
      break;
    case 4: // the same points at other places
      for (vtkIdType i = 0; i < mesh->GetNumberOfPoints(); i += 2)
      {
        double p[3];
        mesh->GetPoint(i, p);
        mesh->GetPoints()->SetPoint(i, p[0], 0.5 * p[1], p[2] + 0.2);
      }
      mesh->GetPoints()->Modified();
      break;
    default: // another, older mesh
      if (auto* mapper = item.Actors.empty()
          ? nullptr
          : vtkPolyDataMapper::SafeDownCast(item.Actors[0]->GetMapper()))
      {
        mapper->SetInputData(item.Cells);
        std::swap(item.Mesh, item.Cells);
      }
  }
}

//------------------------------------------------------------------------------
void FrameScene::ChangeItem(Random& random)
{
  if (this->Items.empty())
  {
    this->AddItem(random);
    return;
  }
  const size_t index = static_cast<size_t>(random.Index(static_cast<int>(this->Items.size())));
  FrameItem& item = this->Items[index];
  const int change = random.Index(8);
  this->Note("item ", index, " change ", change);
  vtkActor* actor = item.Actors.empty() ? nullptr : item.Actors.back().Get();
  switch (change)
  {
    case 0:
      item.Prop->SetVisibility(!item.Prop->GetVisibility());
      break;
    case 1:
      this->PlaceItem(item, random);
      break;
    case 2:
      if (actor && !IsEmissive(actor)) // see MakeGaussians()
      {
        const double opacity = actor->GetProperty()->GetOpacity();
        actor->GetProperty()->SetOpacity(opacity < 1.0 ? 1.0 : 0.4);
      }
      break;
    case 3:
    {
      vtkNew<vtkInformation> keys;
      const bool casts = random.Index(2);
      keys->Set(vtkAirlightPass::CASTS_SHADOW(), casts);
      item.Prop->SetPropertyKeys(keys);
      break;
    }
    case 4:
      if (item.Clip)
      {
        item.Clip->SetOrigin(0.2, random.Uniform(-0.5, 0.5), 0.1);
      }
      else if (actor)
      {
        actor->GetProperty()->SetColor(0.2, random.Uniform(0.0, 1.0), 0.8);
      }
      break;
    default:
      if (item.Mesh)
      {
        this->ChangeMesh(item, random);
      }
  }
}

//------------------------------------------------------------------------------
void FrameScene::RemoveItem(Random& random)
{
  if (!this->Items.empty())
  {
    const int index = random.Index(static_cast<int>(this->Items.size()));
    this->Renderer->RemoveViewProp(this->Items[static_cast<size_t>(index)].Prop);
    this->Items.erase(this->Items.begin() + index);
    this->Note("item ", index, " removed");
  }
}

//------------------------------------------------------------------------------
void FrameScene::ChangePass(Random& random)
{
  const int change = random.Index(7);
  this->Note("pass change ", change);
  switch (change)
  {
    case 0:
      this->Pass->SetSurfaceShadows(!this->Pass->GetSurfaceShadows());
      break;
    case 1:
      this->Pass->SetTranslucentShadows(!this->Pass->GetTranslucentShadows());
      break;
    case 2:
      this->Pass->SetLightRadius(this->Unit * random.LogUniform(1e-3, 1e-1));
      break;
    case 3:
      this->Pass->SetNumberOfSteps(8 + random.Index(20));
      this->Pass->SetShadowMapResolution(32 + random.Index(40));
      break;
    case 4: // and back
    {
      const int technique = this->Pass->GetShadowTechnique();
      this->Pass->SetShadowTechnique(
        technique == this->Group.Technique ? vtkAirlightPass::NONE : this->Group.Technique);
      break;
    }
    case 5: // the last medium goes, or all come back
      if (this->Pass->GetNumberOfMedia() < static_cast<int>(this->Media.size()))
      {
        this->Pass->RemoveAllMedia();
        for (vtkParticipatingMedium* medium : this->Media)
        {
          this->Pass->AddMedium(medium);
        }
      }
      else
      {
        this->Pass->RemoveMedium(this->Media.back());
      }
      break;
    default:
      break; // the same once more
  }
}

//------------------------------------------------------------------------------
void FrameScene::ChangeView(Random& random)
{
  switch (random.Index(3))
  {
    case 0:
    {
      this->Size[0] = 16 + random.Index(12);
      this->Size[1] = 12 + random.Index(10);
      this->Note("size ", this->Size[0], " x ", this->Size[1]);
      break;
    }
    case 1:
      this->SetViewport(random);
      break;
    default:
      this->PlaceCamera(random);
  }
}

//------------------------------------------------------------------------------
FrameWindowEvent FrameScene::Change(int step)
{
  Random random(Mix(100 + static_cast<std::uint64_t>(step), this->Seed));
  this->Note("step ", step);
  const int count = 1 + random.Index(2);
  for (int i = 0; i < count; ++i)
  {
    switch (random.Index(10))
    {
      case 0:
        this->AddItem(random);
        break;
      case 1:
        this->RemoveItem(random);
        break;
      case 2:
        this->ChangeLight(random);
        break;
      case 3:
        this->ChangeMedium(random);
        break;
      case 4:
        this->ChangePass(random);
        break;
      case 5:
        this->ChangeView(random);
        break;
      default:
        this->ChangeItem(random);
    }
  }
  if (this->Group.Recent)
  {
    Random recent(Mix(500 + static_cast<std::uint64_t>(step), this->Seed));
    this->ChangeRecent(recent);
  }
  if (random.Index(4) != 0)
  {
    return EVENT_NONE;
  }
  auto event = static_cast<FrameWindowEvent>(1 + random.Index(EVENT_KINDS - 1));
  if (event == EVENT_FINALIZE && random.Index(4) != 0)
  {
    event = EVENT_RELEASE; // cheaper: the window's shaders stay
  }
  const bool moves = event == EVENT_MOVE_RENDERER || event == EVENT_MOVE_PASS;
  if (moves && this->Group.Peeling)
  {
    // VTK's depth peeling draws nothing, or anything, after its renderer has moved to another window.
    event = EVENT_RELEASE;
  }
  else if (moves)
  {
    this->Window = 1 - this->Window;
  }
  this->Note("event ", event);
  return event;
}
}
