// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the pass does when VTK's mappers build their shaders: which text they get, and when they
 * have to be built again.
 */

#ifndef AirlightMapperHooks_h
#define AirlightMapperHooks_h

#include "Frame/AirlightFramePlan.h"
#include "MapperShaders/AirlightMaterialSpecializations.h"
#include "MapperShaders/AirlightSurfaceShader.h"
#include "OpenGL/AirlightProgram.h"
#include "Scene/AirlightSceneLights.h"

#include "vtkTimeStamp.h"

#include <string>
#include <vector>

class vtkAbstractMapper;
class vtkActor;
class vtkObjectBase;
class vtkOpenGLRenderWindow;
class vtkProp;

namespace airlight
{
class MapperHooks
{
public:
  explicit MapperHooks(const vtkObjectBase* pass)
    : Pass(pass)
  {
  }

  // Before a frame. `parallel`: the camera's projection; `delegate`: a user's pass draws the scene.
  struct FrameInput
  {
    vtkOpenGLRenderWindow* Window;
    bool StorageBuffers;
    bool Parallel;
    bool Delegate;
    const std::vector<vtkActor*>& Actors; // all that the frame can draw
  };
  void Update(const FramePlan& plan, const f64::AirlightMedia& media,
    const std::vector<SceneLight>& sceneLights, const FrameInput& input);

  // Within a frame: casters let light through.
  void AddShadowTransmittance();

  // vtkOpenGLRenderPass::PreReplaceShaderValues() and PostReplaceShaderValues().
  static void MarkShader(std::string& fragment, vtkProp* prop);
  void ChangeShader(const std::string& vertex, std::string& geometry, std::string& fragment,
    vtkAbstractMapper* mapper, vtkProp* prop);

  // After a frame: whether all shaders compiled. False with a reason in `error`; the next frame
  // then asks for them again.
  bool CheckCompiled(std::string& error);

  // The window's context goes.
  void Release() { this->Window = nullptr; }

  // vtkOpenGLRenderPass::GetShaderStageMTime().
  vtkMTimeType GetTime() const { return this->ShaderTime; }

private:
  void UpdateOptions(const FramePlan& plan, const f64::AirlightMedia& media,
    const std::vector<SceneLight>& sceneLights, const FrameInput& input);
  void ChangeSurfaceShader(std::string& shader, bool splats);

  // The last change of a surface's shader: of many actors' shaders most are the same.
  struct Change
  {
    std::string Source;
    std::string After;
    bool PointGaussians = false;
    bool Records = false;
    vtkMTimeType Time = 0;
  };

  const vtkObjectBase* Pass;
  vtkOpenGLRenderWindow* Window = nullptr;
  SurfaceShaderOptions Options;
  MaterialSpecializations Materials;
  Change LastChange;
  ProgramMaker Programs;
  std::string NotCompiled; // the class of a mapper
  vtkTimeStamp ShaderTime;
};
}

#endif
