// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The shaders of vtkAirlightPolyDataMapper: the media, the lights and the text that it adds.
 */

#ifndef AirlightPolyDataMapperShader_h
#define AirlightPolyDataMapperShader_h

#include "MapperShaders/AirlightSurfaceUniforms.h"
#include "Medium/AirlightMediaList.h"
#include "OpenGL/AirlightProgram.h"
#include "Scene/AirlightCameraUniforms.h"
#include "Scene/AirlightSceneArrays.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkWeakPointer.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

class vtkActor;
class vtkObject;
class vtkOpenGLHelper;
class vtkRenderer;

namespace airlight
{
class PolyDataMapperShader
{
public:
  PolyDataMapperShader() { this->Options.InPass = false; }

  // The window that Arrays is for; releases what was there for another one.
  void SetWindow(vtkOpenGLRenderWindow* window);

  // What the next piece is drawn with. False with a reason in Error if OpenGL refuses.
  bool Prepare(vtkRenderer* renderer, double radius);

  // Whether what was added to the actor's shaders compiles, as far as nobody changes them once
  // more: VTK's mappers do not survive one that does not.
  bool Compiles(
    vtkActor* actor, const std::string& vertex, std::string& fragment, const std::string& geometry);

  // Says what is wrong with media, lights and graphics card, and afterwards with shaders, each
  // once.
  void Check(vtkObject* mapper);
  void CheckShaders(vtkObject* mapper);

  // What the text added to the shaders reads.
  SurfaceUniforms GetUniforms()
  {
    SurfaceUniforms values;
    values.Stage = SurfaceStage::Translucent;
    values.Rays = &*this->Rays;
    values.ViewportX = this->Viewport[0];
    values.ViewportY = this->Viewport[1];
    values.Media = &this->Converted;
    values.SceneLights = &this->SceneLights;
    values.Data = this->Arrays.GetTexture();
    return values;
  }

  // What the shaders of a kind of primitive were made for.
  struct Build
  {
    bool Shades = false;
    int OptionsVersion = 0;
  };

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  MediaList Media;
  SceneArrays Arrays;
  SurfaceShaderOptions Options;
  int OptionsVersion = 0;
  std::map<const vtkOpenGLHelper*, Build> Built;
  std::string Error;
  std::string ReportedError;
  ProgramMaker Programs;
  bool NotCompiled = false; // something of this piece
  bool Retries = false;     // as something of the last one did not
  bool ReportedShaders = false;
  bool WarnedMedia = false;
  bool WarnedLights = false;
  bool WarnedCameraLights = false;

  // This piece's.
  bool Shades = false; // behind the medium; else as the superclass does
  int Viewport[4] = { 0, 0, 0, 0 };
  std::optional<CameraUniforms> Rays;
  f64::AirlightMedia Converted{};
  std::vector<SceneLight> SceneLights;
  int ScatteredOnce = 0; // lights that multiple scattering leaves out
  bool WarnedScatteredOnce = false;
};
}

#endif
