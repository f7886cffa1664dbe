// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The two windows in which random scenes are drawn, and what is read back of a frame.
 */

#ifndef FrameStage_h
#define FrameStage_h

#include "FrameScene.h"

#include "vtkImageData.h"
#include "vtkRenderWindow.h"

#include <map>
#include <string>
#include <vector>

namespace airlight_test
{
struct FrameRecord
{
  std::map<std::string, vtkSmartPointer<vtkImageData>> Buffers; // none if not recorded
  std::vector<unsigned char> Picture;                           // RGB, of the renderer's viewport
};

class FrameStage
{
public:
  FrameStage();
  ~FrameStage();
  FrameStage(const FrameStage&) = delete;
  void operator=(const FrameStage&) = delete;

  void Enter(FrameScene& scene);
  void Leave(FrameScene& scene);

  // After the scene's change, of which this is the result.
  void Apply(FrameScene& scene, FrameWindowEvent event);

  FrameRecord Draw(FrameScene& scene, bool record);

  // False: scenes that enter from now on are drawn without their pass, by VTK alone.
  void SetUsesPass(bool uses) { this->UsesPass = uses; }

  // Forgets all shaders.
  void Clear();

private:
  vtkRenderWindow* GetWindow(const FrameScene& scene) { return this->Windows[scene.Window].Get(); }
  void DrawOther(FrameScene& scene);
  static void Add(vtkRenderWindow* window, FrameScene& scene);
  static void Remove(vtkRenderWindow* window, FrameScene& scene);

  void SetPass(vtkRenderer* renderer, FrameScene& scene) const;

  vtkSmartPointer<vtkRenderWindow> Windows[2];
  bool UsesPass = true;
};
}

#endif
