// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneBuilder_h
#define SceneBuilder_h

#include "scene/Scene.h"

#include <vtkAirlightPass.h>
#include <vtkLight.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include <vector>

namespace airlight
{

/**
 * Properties of vtkAirlightPass of the same names: how radiance is shown on a screen.
 */
struct DisplaySettings
{
  double Exposure = 1.0;
  bool AutomaticExposure = false;
  int ToneMapping = vtkAirlightPass::NEUTRAL_PBR;
  int OutputColorSpace = vtkAirlightPass::SRGB;
  bool Dithering = true;
};

constexpr int PictureFrames = 16; ///< whose mean is smooth; numbers are of the pixels' middles

struct RenderSettings
{
  bool OffScreen = true;
  bool UseMedium = true;      ///< false: VTK's plain lighting, without medium and shadows
  bool RecordBuffers = false; ///< for vtkAirlightPass::GetBuffer()
  int ShadowTechnique = vtkAirlightPass::AUTOMATIC;
  int Steps = 64;             ///< vtkAirlightPass::SetNumberOfSteps()
  int SubpixelFrames = 1;     ///< vtkAirlightPass::SetSubpixelFrames()
  bool Multisampling = false; ///< vtkAirlightPass::SetMultisampling(), and of the window
  DisplaySettings Display;
};

/**
 * A scene ready to render, as VTK objects.
 */
struct RenderedScene
{
  vtkSmartPointer<vtkRenderWindow> Window;
  vtkSmartPointer<vtkRenderer> Renderer;
  vtkSmartPointer<vtkAirlightPass> Pass; ///< null without medium
  std::vector<vtkSmartPointer<vtkLight>> Lights;
  double Brightness = 1.0; ///< Scene::Brightness

  /**
   * Draw a frame. Throws UserError with VTK's first error if there was one, and prints its first
   * warning.
   */
  void Render();
};

/**
 * Open a window on a scene: black background, two-sided lighting and the scene's
 * lamps alone. Throws UserError if there is no display to open it on.
 */
RenderedScene BuildScene(const Scene& scene, const RenderSettings& settings);

/**
 * The same scene without a window and a pass, for vtkAirlightReference.
 */
RenderedScene BuildSceneWithoutWindow(const Scene& scene);

/**
 * Warn if a mean of so many frames shows lamps of finite size as points: each frame takes another
 * point of a lamp.
 */
void WarnOfPoints(const Scene& scene, const RenderSettings& settings, int frames);

}

#endif
