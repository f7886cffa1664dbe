// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A renderer's scene in one frame, as the steps of the frame take it. Valid while the frame is
 * drawn.
 */

#ifndef AirlightFrameScene_h
#define AirlightFrameScene_h

#include "Scene/AirlightCameraUniforms.h"
#include "Scene/AirlightSceneLights.h"

#include <vector>

class vtkOpenGLRenderWindow;
class vtkTextureObject;

namespace airlight
{
struct FrameScene
{
  vtkOpenGLRenderWindow* Window;
  const f64::AirlightMedia& Media;
  const std::vector<SceneLight>& Lights;
  const CameraUniforms& Rays;
  vtkTextureObject* Data;    // surfaces, tables and images of media and lights
  vtkTextureObject* Samples; // of images, where these are whole numbers; else null
  int Width;                 // of the viewport
  int Height;
};

// The numbers of the lights that the medium scatters.
std::vector<int> FindScattering(const std::vector<SceneLight>& lights);
}

#endif
