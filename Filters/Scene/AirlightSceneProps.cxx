// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightSceneProps.h"

#include "Scene/AirlightCasterKeys.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkLODProp3D.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"

#include <algorithm>
#include <unordered_set>

namespace airlight
{
namespace
{
// Whether the actor is that of a level of detail: two of them may share a mapper.
bool IsLevel(vtkLODProp3D* prop, int id, vtkActor* actor)
{
  vtkMapper* mapper = vtkMapper::SafeDownCast(prop->GetLODMapper(id));
  if (!mapper || mapper != actor->GetMapper())
  {
    return false;
  }
  vtkProperty* property = nullptr;
  prop->GetLODProperty(id, &property);
  return property == actor->GetProperty();
}

// Null if it is a volume or an image. VTK hands out the actors, but not which level is whose.
vtkActor* GetShownLevel(vtkLODProp3D* prop)
{
  vtkNew<vtkPropCollection> actors;
  prop->GetActors(actors);
  const int id =
    prop->GetAutomaticLODSelection() ? prop->GetLastRenderedLODID() : prop->GetSelectedLODID();
  vtkCollectionSimpleIterator it = nullptr;
  actors->InitTraversal(it);
  while (vtkProp* level = actors->GetNextProp(it))
  {
    auto* actor = vtkActor::SafeDownCast(level);
    if (id < 0 || IsLevel(prop, id, actor))
    {
      return actor;
    }
  }
  return nullptr;
}

// VTK keeps the matrix of a path until it goes to the next one.
vtkSmartPointer<vtkMatrix4x4> Copy(vtkMatrix4x4* matrix)
{
  auto copy = vtkSmartPointer<vtkMatrix4x4>::New();
  copy->DeepCopy(matrix);
  return copy;
}

void AddPart(SceneProp& to, vtkProp* part, vtkMatrix4x4* toWorld)
{
  auto* levels = vtkLODProp3D::SafeDownCast(part);
  vtkActor* actor = levels ? GetShownLevel(levels) : vtkActor::SafeDownCast(part);
  if (actor)
  {
    to.Parts.push_back({ actor, Copy(toWorld), to.Casts && CastsShadow(actor) });
  }
  else
  {
    to.OtherParts.push_back(part);
    auto* volume = vtkVolume::SafeDownCast(part);
    if (volume && volume->GetMapper())
    {
      // One that scatters dims as a medium.
      to.VolumeParts.push_back(
        { volume, Copy(toWorld), to.Casts && CastsShadow(volume) && !IsMedium(volume, to.Prop) });
    }
  }
}

void AddParts(SceneProp& to)
{
  if (auto* actor = vtkActor::SafeDownCast(to.Prop))
  {
    actor->ComputeMatrix();
    to.Parts.push_back({ actor, actor->GetMatrix(), to.Casts });
    return;
  }
  to.Prop->InitPathTraversal();
  while (vtkAssemblyPath* path = to.Prop->GetNextPath())
  {
    vtkAssemblyNode* node = path->GetLastNode();
    if (node && node->GetViewProp()->GetVisibility())
    {
      AddPart(to, node->GetViewProp(), node->GetMatrix());
    }
  }
}

// What a prop gives by vtkProp::GetActors() or vtkProp::GetVolumes().
template <typename Item>
std::vector<Item*> List(vtkProp* prop, void (vtkProp::*get)(vtkPropCollection*))
{
  vtkNew<vtkPropCollection> found;
  (prop->*get)(found);
  std::vector<Item*> items;
  vtkCollectionSimpleIterator it = nullptr;
  found->InitTraversal(it);
  while (vtkProp* next = found->GetNextProp(it))
  {
    if (auto* item = Item::SafeDownCast(next))
    {
      items.push_back(item);
    }
  }
  return items;
}

std::vector<vtkVolume*> ListVisibleVolumes(vtkProp* prop)
{
  std::vector<vtkVolume*> volumes = List<vtkVolume>(prop, &vtkProp::GetVolumes);
  volumes.erase(
    std::remove_if(volumes.begin(), volumes.end(),
      [](vtkVolume* volume) { return !volume->GetVisibility() || !volume->GetMapper(); }),
    volumes.end());
  return volumes;
}
}

//------------------------------------------------------------------------------
SceneProps::SceneProps(vtkRenderer* renderer)
{
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it = nullptr;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    this->Add(prop, prop->GetVisibility() != 0);
  }
}

//------------------------------------------------------------------------------
SceneProps::SceneProps(vtkRenderer* renderer, vtkProp** inView, int count)
{
  std::unordered_set<vtkProp*> drawn(inView, inView + count);
  vtkPropCollection* props = renderer->GetViewProps();
  vtkCollectionSimpleIterator it = nullptr;
  props->InitTraversal(it);
  while (vtkProp* prop = props->GetNextProp(it))
  {
    this->Add(prop, drawn.erase(prop) > 0);
  }
  for (int i = 0; i < count && !drawn.empty(); ++i)
  {
    if (drawn.erase(inView[i]) > 0)
    {
      this->Add(inView[i], true);
      this->Props.back().Casts = false;
      this->Props.back().Parts.clear();
      this->Props.back().VolumeParts.clear();
    }
  }
}

//------------------------------------------------------------------------------
// A pass is given visible props by VTK, but by its users any.
void SceneProps::Add(vtkProp* prop, bool inView)
{
  const bool visible = prop->GetVisibility() != 0;
  if (!visible && !inView)
  {
    return;
  }
  SceneProp item;
  item.Prop = prop;
  item.InView = inView;
  item.Casts = visible && CastsShadow(prop);
  if (visible)
  {
    AddParts(item);
  }
  if (auto* actor = vtkActor::SafeDownCast(prop))
  {
    item.Actors.push_back(actor); // which holds no other
  }
  else if (inView && visible)
  {
    item.Actors = List<vtkActor>(prop, &vtkProp::GetActors);
    item.Volumes = ListVisibleVolumes(prop);
  }
  this->Props.push_back(std::move(item));
}
}
