// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What the walk over a renderer's props finds: visible props, those in view, their parts in place,
// what casts, and volumes.

#include "Scene/AirlightSceneProps.h"

#include "AirlightTestCheck.h"

#include "Scene/AirlightCasterKeys.h"
#include "vtkActor.h"
#include "vtkAssembly.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkLODProp3D.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderer.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cstdlib>

using airlight_test::Check;
using namespace airlight;

namespace
{
const SceneProp* Find(const SceneProps& props, vtkProp* prop)
{
  for (const SceneProp& item : props.GetProps())
  {
    if (item.Prop == prop)
    {
      return &item;
    }
  }
  return nullptr;
}

double GetX(const ScenePart& part) { return part.ToWorld->GetElement(0, 3); }

void CheckView()
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkActor> seen;
  vtkNew<vtkActor> outside;
  vtkNew<vtkActor> hidden;
  vtkNew<vtkActor> foreign;
  seen->SetPosition(3.0, 0.0, 0.0);
  hidden->VisibilityOff();
  SetCastsShadow(outside, false);
  renderer->AddActor(seen);
  renderer->AddActor(outside);
  renderer->AddActor(hidden);
  vtkProp* inView[] = { seen, foreign };
  const SceneProps props(renderer, inView, 2);

  Check(props.GetProps().size() == 3, "two props of the renderer and one that is not its");
  const SceneProp* item = Find(props, seen);
  Check(item && item->InView && item->Casts && item->Parts.size() == 1 && item->OtherParts.empty(),
    "an actor in view is its only part");
  Check(item && item->Parts[0].Actor == seen && GetX(item->Parts[0]) == 3.0,
    "an actor's matrix is up to date");
  item = Find(props, outside);
  Check(item && !item->InView && !item->Casts && !item->Parts[0].Casts,
    "an actor out of view whose key says that it casts nothing");
  Check(!Find(props, hidden), "hidden props are left out");
  item = Find(props, foreign);
  Check(item && item->InView && !item->Casts && item->Parts.empty(),
    "props that are none of the renderer's cast nothing");

  const SceneProps all(renderer);
  Check(all.GetProps().size() == 2 && Find(all, outside)->InView,
    "without a list all visible props are in view");
}

void CheckAssembly()
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkAssembly> assembly;
  vtkNew<vtkActor> first;
  vtkNew<vtkActor> second;
  vtkNew<vtkActor> hidden;
  vtkNew<vtkVolume> volume;
  vtkNew<vtkVolume> empty;
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  volume->SetMapper(mapper);
  assembly->SetPosition(10.0, 0.0, 0.0);
  first->SetPosition(1.0, 0.0, 0.0);
  second->SetPosition(2.0, 0.0, 0.0);
  hidden->VisibilityOff();
  SetCastsShadow(second, false);
  for (vtkProp3D* part : { static_cast<vtkProp3D*>(first), static_cast<vtkProp3D*>(second),
         static_cast<vtkProp3D*>(hidden), static_cast<vtkProp3D*>(volume),
         static_cast<vtkProp3D*>(empty) })
  {
    assembly->AddPart(part);
  }
  renderer->AddActor(assembly);
  const SceneProps props(renderer);
  const SceneProp* item = Find(props, assembly);
  if (!Check(item && item->Parts.size() == 2 && item->OtherParts.size() == 2,
        "visible actors and volumes of an assembly"))
  {
    return;
  }
  Check(item->Parts[0].Actor == first && GetX(item->Parts[0]) == 11.0, "the first part's place");
  Check(item->Parts[1].Actor == second && GetX(item->Parts[1]) == 12.0, "the second part's place");
  Check(item->Parts[0].Casts && !item->Parts[1].Casts, "each part by its own key");
  Check(item->Volumes.size() == 1 && item->Volumes[0] == volume, "volumes that have a mapper");
  Check(item->Actors.size() == 3, "all actors that an assembly can draw");

  SetCastsShadow(assembly, false);
  const SceneProps none(renderer);
  Check(!Find(none, assembly)->Parts[0].Casts, "an assembly's key goes before those of its parts");
}

void CheckLevels()
{
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkLODProp3D> levels;
  vtkNew<vtkPolyDataMapper> fine;
  vtkNew<vtkPolyDataMapper> coarse;
  vtkNew<vtkProperty> property;
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  vtkNew<vtkVolumeProperty> volumeProperty;
  levels->AddLOD(fine, property, 0.0);
  const int id = levels->AddLOD(coarse, property, 0.0);
  const int volume = levels->AddLOD(mapper, volumeProperty, 0.0);
  levels->AutomaticLODSelectionOff();
  levels->SetSelectedLODID(id);
  renderer->AddViewProp(levels);
  const SceneProps selected(renderer);
  const SceneProp* item = Find(selected, levels);
  Check(item && item->Parts.size() == 1 && item->Parts[0].Actor->GetMapper() == coarse,
    "the level that is selected");
  Check(item && item->Actors.size() == 2, "all levels that are actors");
  levels->SetSelectedLODID(volume);
  const SceneProps other(renderer);
  item = Find(other, levels);
  Check(item && item->Parts.empty() && item->OtherParts.size() == 1 &&
      item->OtherParts[0] == levels.Get(),
    "a level that is a volume draws no actor");
}
}

int TestSceneProps(int, char*[])
{
  CheckView();
  CheckAssembly();
  CheckLevels();
  return airlight_test::Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
