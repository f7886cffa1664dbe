// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What vtkAirlightPolyDataMapper keeps, and what it finds out before it draws.
 */

#ifndef vtkAirlightPolyDataMapperInternals_h
#define vtkAirlightPolyDataMapperInternals_h

#include "MapperShaders/AirlightSurfaceShader.h"
#include "Medium/AirlightMediaList.h"
#include "OpenGL/AirlightProgram.h"
#include "Scene/AirlightCameraUniforms.h"
#include "vtkAirlightPolyDataMapper.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkWeakPointer.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

class vtkOpenGLHelper;
class vtkRenderer;

class vtkAirlightPolyDataMapper::Internals
{
public:
  Internals() { this->Options.InPass = false; }

  // The window that Data is for; releases what was there for another one.
  void SetWindow(vtkOpenGLRenderWindow* window);

  // What the next piece is drawn with. False with a reason in Error where it cannot be had.
  bool Prepare(vtkRenderer* renderer, double radius);

  // Whether what was added to the actor's shaders compiles, as far as nobody changes them once more:
  // VTK's mappers do not survive one that does not.
  bool Compiles(
    vtkActor* actor, const std::string& vertex, std::string& fragment, const std::string& geometry);

  // Says what is wrong with media, lights and graphics card, and afterwards with shaders, each once.
  void Check(vtkAirlightPolyDataMapper* self);
  void CheckShaders(vtkAirlightPolyDataMapper* self);

  // What the text added to the shaders reads.
  airlight::SurfaceUniforms GetUniforms()
  {
    airlight::SurfaceUniforms values;
    values.Stage = airlight::SurfaceStage::Translucent;
    values.Rays = &*this->Rays;
    values.ViewportX = this->Viewport[0];
    values.ViewportY = this->Viewport[1];
    values.Media = &this->Converted;
    values.Lamps = &this->Lamps;
    values.Data = this->Data.GetTexture();
    return values;
  }

  // What the shaders of a kind of primitive were made for.
  struct Build
  {
    bool Shades = false;
    int OptionsVersion = 0;
  };

  vtkWeakPointer<vtkOpenGLRenderWindow> Window;
  airlight::MediaList Media;
  airlight::LightSwitches Switches;
  airlight::SceneData Data;
  airlight::SurfaceShaderOptions Options;
  int OptionsVersion = 0;
  std::map<const vtkOpenGLHelper*, Build> Built;
  std::string Error;
  std::string ReportedError;
  airlight::ProgramMaker Programs;
  bool NotCompiled = false; // something of this piece
  bool Retries = false;     // as something of the last one did not
  bool ReportedShaders = false;
  bool WarnedMedia = false;
  bool WarnedLights = false;
  bool WarnedCameraLights = false;

  // This piece's.
  bool Shades = false; // behind the medium; else as the superclass does
  int Viewport[4] = { 0, 0, 0, 0 };
  std::optional<airlight::CameraUniforms> Rays;
  airlight::f64::AirlightMedia Converted{};
  std::vector<airlight::Lamp> Lamps;
};

#endif
