// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The targets of a frame into which VTK draws the scene's geometry: binds and clears them, and sets
 * OpenGL's state for it.
 */

#ifndef AirlightGeometryPass_h
#define AirlightGeometryPass_h

#include "Frame/AirlightFramePlan.h"
#include "Frame/AirlightTargets.h"
#include "OpenGL/AirlightQuad.h"
#include "Scene/AirlightFrameScene.h"

#include <string>

class vtkRenderer;

namespace airlight
{
class GeometryPass
{
public:
  explicit GeometryPass(Targets& targets);

  // Of a mask, whose pixels alone are drawn, those where it is above 0: null for all.
  void SetMask(vtkTextureObject* mask) { this->Mask = mask; }

  // Hides whatever is drawn later at the others in the depth that is bound; the steps below do so.
  void HideOthers(const FrameScene& scene);

  // For the distances and depths of the opaque surfaces. Here and below false with a reason in
  // GetError() where OpenGL refuses.
  bool BindDistances(const FrameScene& scene, const FramePlan& plan);

  // Afterwards: takes the distances of props whose shaders do not write them from their depths.
  bool CompleteDistances(const FrameScene& scene, const FramePlan& plan);

  // For the colours of the opaque surfaces and the background; and for their distances, where the
  // plan has a single geometry pass.
  bool BindColours(const FrameScene& scene, const FramePlan& plan, vtkRenderer* renderer);

  // Between the background and the opaque surfaces, and after these.
  void BeginSurfaces(const FrameScene& scene, const FramePlan& plan);
  void EndSurfaces(const FrameScene& scene, const FramePlan& plan);

  // For fragments that are collected in front of the opaque surfaces: their depths alone.
  bool BindDepth(const FrameScene& scene);

  // For translucent surfaces and volumes, over the radiance of all that is behind them.
  bool BindRadiance(const FrameScene& scene);

  const std::string& GetError() const { return this->Error; }
  void Release();

private:
  bool Fail(const std::string& reason);
  bool BindScene(const FrameScene& scene);
  bool BindSceneAndDistances(const FrameScene& scene, const FramePlan& plan, vtkRenderer* renderer);

  Targets& Textures;
  vtkTextureObject* Mask = nullptr;
  Quad DistancesQuad;
  Quad MaskQuad;
  std::string Error;
};
}

#endif
