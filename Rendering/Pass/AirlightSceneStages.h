// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Draws the parts of a renderer's scene for a frame, with VTK's own passes or a user's delegate,
 * and sets the uniforms of the mappers' shaders for each stage.
 */

#ifndef AirlightSceneStages_h
#define AirlightSceneStages_h

#include "Frame/AirlightSceneDrawer.h"
#include "MapperShaders/AirlightDepthPrePassVariants.h"
#include "MapperShaders/AirlightSurfaceUniforms.h"
#include "Pass/AirlightDelegate.h"
#include "Pass/AirlightScenePass.h"

#include "vtkCameraPass.h"
#include "vtkHiddenLineRemovalPass.h"
#include "vtkNew.h"
#include "vtkOpaquePass.h"
#include "vtkSmartPointer.h"

#include <functional>
#include <set>
#include <vector>

class vtkAbstractMapper;
class vtkCamera;
class vtkProp;
class vtkRenderPass;
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

  // The user's pass that draws the scene; null for VTK's own.
  void SetDelegate(vtkRenderPass* delegate) { this->Delegate = delegate; }
  vtkRenderPass* GetDelegate() const { return this->Delegate; }

  // Before a frame and after it: takes hold of the props' shaders, and leaves them.
  void Begin(const vtkRenderState* s, const SceneSupport& support);
  void End();

  // The scene as if the pass were not there.
  void DrawPlain(const vtkRenderState* s);

  // Into the framebuffer that is bound, over a finished frame.
  void DrawOverFrame(const vtkRenderState* s, bool annotations);

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

  AirlightScenePass* GetScenePass() { return this->ScenePass; }
  int GetNumberOfRenderedProps() const { return this->NumberOfRenderedProps; }
  void Release(vtkWindow* window);

private:
  vtkRenderPass* GetScenePass(bool opaqueOnly);
  void DrawStage(SurfaceStage stage, const std::function<void()>& draw);
  void DrawTranslucentProps();
  bool IsDrawnLater(vtkProp* prop);
  void SetVolumeUniforms(
    vtkShaderProgram* program, vtkVolume* volume, const SurfaceUniforms& values);
  void CheckVolumes();
  bool MayAntialias(const vtkRenderState* s);

  Frame& CurrentFrame;
  MapperHooks& Mappers;
  PassMessages& Messages;
  RenderHooks Hooks;
  vtkRenderPass* Delegate = nullptr;
  vtkNew<AirlightScenePass> ScenePass;
  vtkNew<vtkCameraPass> CameraPass;
  vtkNew<vtkOpaquePass> OpaquePass;
  vtkNew<vtkHiddenLineRemovalPass> HiddenLinePass;
  DepthPrePassVariants DepthPrePass;
  int NumberOfRenderedProps = 0;

  // This frame's.
  const vtkRenderState* State = nullptr; // into the frame's targets
  const SceneSupport* Support = nullptr; // of the props that the frame began with
  std::vector<vtkProp*> Props;           // these
  SurfaceStage Stage = SurfaceStage::Colour;
  DelegateProps ProxyProps;  // what a delegate is shown of them
  std::set<vtkProp*> Hidden; // those kept from the stage of colours
  std::set<vtkProp*> VolumesSeen;
  bool DrawsMap = false;
  std::set<vtkShaderProgram*> MapPrograms; // those used for the map that is drawn
};
}

#endif
