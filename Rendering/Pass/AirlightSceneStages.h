// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws the parts of a renderer's scene for a frame, with VTK's own passes or a user's delegate,
 * and sets the uniforms of the mappers' shaders for each stage.
 */

#ifndef AirlightSceneStages_h
#define AirlightSceneStages_h

#include "Frame/AirlightSceneDrawer.h"
#include "MapperShaders/AirlightStageVariants.h"
#include "MapperShaders/AirlightSurfaceUniforms.h"
#include "Pass/AirlightStagePasses.h"
#include "Scene/AirlightCameraUniforms.h"

#include <functional>
#include <set>
#include <vector>

class vtkAbstractMapper;
class vtkCamera;
class vtkProp;
class vtkRenderState;
class vtkShaderProgram;
class vtkVolume;
class vtkWindow;

namespace airlight
{
class Frame;
class MapperHooks;
class PassMessages;
struct NonPolygonalCaster;
struct SceneSupport;

class SceneStages : public SceneDrawer
{
public:
  // What vtkOpenGLRenderPass does before and after its props are drawn.
  struct RenderHooks
  {
    std::function<void(const vtkRenderState*)> PreRender;
    std::function<void(const vtkRenderState*)> PostRender;
  };

  SceneStages(Frame& frame, MapperHooks& mappers, PassMessages& messages, const RenderHooks& hooks);

  // What draws them.
  StagePasses& GetPasses() { return this->Passes; }
  const StagePasses& GetPasses() const { return this->Passes; }

  // Before a frame and after it: takes hold of the props' shaders, and leaves them.
  void Begin(const vtkRenderState* s, const SceneSupport& support);
  void End();

  void DrawDistances() override;
  void DrawColours() override;
  void UpdateCasters() override;
  void CollectFragments() override;
  void DrawTranslucent() override;

  // Casters without polygons, into the face of a shadow map: with its light as camera, the face's
  // lower left corner and side.
  void DrawInMap(
    const std::vector<NonPolygonalCaster>& casters, vtkCamera* camera, int x, int y, int side);

  // vtkOpenGLRenderPass::SetShaderParameters().
  void SetUniforms(vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop);

  void Release(vtkWindow* window);

private:
  // A face of a shadow map: the rays of its light as camera, and its lower left corner.
  struct MapFace
  {
    CameraUniforms Rays;
    int X;
    int Y;
    std::set<vtkShaderProgram*> Programs; // those used
  };

  void CallHook(const std::function<void(const vtkRenderState*)>& hook);
  void DrawStage(SurfaceStage stage, const std::function<void()>& draw);
  void DrawOpaqueProps(const std::function<void(const vtkRenderState*)>& draw);
  bool IsDrawn(vtkProp* prop) const;
  bool IsDrawnLater(vtkProp* prop);
  void SetVolumeUniforms(
    vtkShaderProgram* program, vtkVolume* volume, const SurfaceUniforms& values);
  void CheckVolumes();

  Frame& CurrentFrame;
  MapperHooks& Mappers;
  PassMessages& Messages;
  RenderHooks Hooks;
  StagePasses Passes;
  StageVariants Variants;

  // This frame's.
  const vtkRenderState* State = nullptr; // into the frame's targets
  const SceneSupport* Support = nullptr; // of the props that the frame began with
  SurfaceStage Stage = SurfaceStage::Colour;
  MapFace* Face = nullptr;               // that is drawn; null: the picture
  // Their property keys, which parts that draw for a prop share with it.
  std::set<vtkInformation*> VolumesSeen;
};
}

#endif
