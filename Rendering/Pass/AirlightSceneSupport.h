// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the props in view allow a frame to do.
 */

#ifndef AirlightSceneSupport_h
#define AirlightSceneSupport_h

#include <vector>

class vtkActor;
class vtkProp;
class vtkRenderPass;
class vtkRenderer;
class vtkVolume;

namespace airlight
{
class SceneProps;
struct SceneProp;

struct SceneSupport
{
  // Once the pipelines of what casts are up to date. `delegate`: the user's pass that draws the
  // scene, or null.
  SceneSupport(const SceneProps& props, vtkRenderer* renderer, const vtkRenderPass* delegate);

  // All that is drawn as opaque, but for point Gaussians, is drawn by shaders that the pass can add
  // to.
  bool AllShadersInjectable = true;

  // There are actors of point Gaussians, which blend over the medium where the plan has that.
  bool PointGaussians = false;

  // Each fragment of the opaque surfaces hides all that is behind it, as far as is known.
  bool AllOpaque = true;

  // Something blends over the medium. Assemblies and the like may hold volumes.
  bool DrawsOverMedium = false;

  // There are wireframes of which VTK removes hidden lines.
  bool HidesLines = false;

  // A vtkSSAOPass around this pass takes part in the props' shaders.
  bool OcclusionOutside = false;

  // Actors that are drawn as their mappers' inputs are, opaque everywhere; in the order of
  // pointers.
  std::vector<vtkProp*> Solids;

  std::vector<vtkVolume*> Volumes;

  // All that the props can draw.
  std::vector<vtkActor*> Actors;

  // All that draws in the view and has keys of its own to name the pass in: the props, and the
  // parts of those that keep theirs.
  std::vector<vtkProp*> KeyHolders;

  // Props that hold volumes whose mappers use shaders of the graphics card, and may be rewritten.
  std::vector<vtkProp*> RayCast;

private:
  void AddProp(const SceneProp& item);
  void AddGeometry(vtkProp* prop);
  void AddVolumes(const SceneProp& prop);
};
}

#endif
