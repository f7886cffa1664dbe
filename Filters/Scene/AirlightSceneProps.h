// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The one walk over the props of a renderer: what there is to draw, and which actors draw it. The
 * pass makes it once a frame; the CPU reference reads the same.
 *
 * Not installed; exported for the module's own tests.
 */

#ifndef AirlightSceneProps_h
#define AirlightSceneProps_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkSmartPointer.h"

#include <vector>

class vtkActor;
class vtkMatrix4x4;
class vtkProp;
class vtkRenderer;
class vtkVolume;

namespace airlight
{
// An actor that a prop draws: the prop itself, a part of an assembly, or a level of detail.
struct ScenePart
{
  vtkActor* Actor = nullptr;
  vtkSmartPointer<vtkMatrix4x4> ToWorld;
  bool Casts = true; // its key and that of its prop allow it
};

// A volume that a prop draws, likewise. Only vtkVolume, not what a vtkLODProp3D shows.
struct SceneVolume
{
  vtkVolume* Volume = nullptr;
  vtkSmartPointer<vtkMatrix4x4> ToWorld;
  bool Casts = true;
};

// A visible prop of the renderer.
struct SceneProp
{
  vtkProp* Prop = nullptr;
  bool InView = false; // this frame draws it; else it can cast shadows into the view
  bool Casts = true;   // as far as its key says
  // Visible actors. A vtkLODProp3D draws the level of detail that VTK chose for its last frame;
  // before its first frame, the one that is selected or was added first.
  std::vector<ScenePart> Parts;
  // What draws no actor: volumes, annotations, a vtkLODProp3D that shows a volume or an image.
  std::vector<vtkProp*> OtherParts;
  // Those of them that are volumes with a mapper.
  std::vector<SceneVolume> VolumeParts;
  // Of props in view alone: visible volumes with a mapper, and all actors that it can draw, hidden
  // parts and all levels of detail included.
  std::vector<vtkVolume*> Volumes;
  std::vector<vtkActor*> Actors;
};

class VTKAIRLIGHT_EXPORT SceneProps
{
public:
  SceneProps() = default;
  // With all props in view.
  explicit SceneProps(vtkRenderer* renderer);
  // With these in view. Some may be none of the renderer's: these cast no shadows.
  SceneProps(vtkRenderer* renderer, vtkProp** inView, int count);

  const std::vector<SceneProp>& GetProps() const { return this->Props; }

private:
  void Add(vtkProp* prop, bool inView);

  std::vector<SceneProp> Props;
};
}

#endif
