// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightPropParts.h"

#include "vtkActor.h"
#include "vtkAssemblyNode.h"
#include "vtkAssemblyPath.h"
#include "vtkLODProp3D.h"
#include "vtkMapper.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPropCollection.h"
#include "vtkProperty.h"

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
}

//------------------------------------------------------------------------------
void VisitParts(
  vtkProp* prop, const VisitActor& visit, const std::function<void(vtkProp* part)>& skip)
{
  const auto visitPart = [&](vtkProp* part, vtkMatrix4x4* matrix) {
    auto* levels = vtkLODProp3D::SafeDownCast(part);
    vtkActor* actor = levels ? GetShownLevel(levels) : vtkActor::SafeDownCast(part);
    actor ? visit(actor, matrix) : skip(part);
  };
  if (auto* actor = vtkActor::SafeDownCast(prop))
  {
    actor->ComputeMatrix();
    visit(actor, actor->GetMatrix());
    return;
  }
  prop->InitPathTraversal();
  while (vtkAssemblyPath* path = prop->GetNextPath())
  {
    vtkAssemblyNode* node = path->GetLastNode();
    if (node && node->GetViewProp()->GetVisibility())
    {
      visitPart(node->GetViewProp(), node->GetMatrix());
    }
  }
}
}
