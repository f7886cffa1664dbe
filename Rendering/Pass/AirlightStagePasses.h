// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The render passes that draw the parts of a scene: VTK's own, or the user's delegate.
 */

#ifndef AirlightStagePasses_h
#define AirlightStagePasses_h

#include "Pass/AirlightDelegateProps.h"
#include "Pass/AirlightScenePass.h"

#include "vtkCameraPass.h"
#include "vtkHiddenLineRemovalPass.h"
#include "vtkNew.h"
#include "vtkOpaquePass.h"

#include <functional>

class vtkProp;
class vtkRenderPass;
class vtkRenderState;
class vtkRenderer;
class vtkWindow;

namespace airlight
{
class PassMessages;

class StagePasses
{
public:
  // The user's pass that draws the scene; null for VTK's own.
  void SetDelegate(vtkRenderPass* delegate) { this->Delegate = delegate; }
  vtkRenderPass* GetDelegate() const { return this->Delegate; }

  // Called before and after the opaque geometry, where VTK's own passes draw it alone.
  void SetAroundOpaque(const std::function<void()>& before, const std::function<void()>& after)
  {
    this->ScenePass->SetAroundOpaque(before, after);
  }

  void PrepareLights(vtkRenderer* renderer) { this->ScenePass->PrepareLights(renderer); }

  // The scene as if the pass were not there.
  void DrawAll(const vtkRenderState* s);

  // The opaque geometry for its distances. Hidden lines are neither drawn nor fogged if requested.
  void DrawDistances(const vtkRenderState* s, bool hidesLines);

  // And for its colours.
  void DrawOpaque(const vtkRenderState* s);

  // A prop that should blend over the medium drew nothing when a delegate drew it with the others.
  void Hide(vtkProp* prop) { this->ProxyProps.Hide(prop); }

  // Opaque point Gaussians, translucent surfaces, volumes. A delegate that draws the renderer's own
  // list of props has drawn all but those of Hide() already.
  void DrawTranslucent(const vtkRenderState* s);

  // Into the framebuffer that is bound, over a finished frame: VTK's FXAA and annotations.
  void DrawOverFrame(const vtkRenderState* s, bool annotations, PassMessages& messages);

  void EndFrame() { this->ProxyProps.Clear(); }

  // vtkRenderPass::GetNumberOfRenderedProps() of the last scene.
  int GetNumberOfRenderedProps() const { return this->NumberOfRenderedProps; }

  void Release(vtkWindow* window) { this->ScenePass->ReleaseGraphicsResources(window); }

private:
  vtkRenderPass* GetScenePass(bool opaqueOnly);
  bool MayAntialias(const vtkRenderState* s, PassMessages& messages) const;

  vtkRenderPass* Delegate = nullptr;
  DelegateProps ProxyProps; // what it is shown in this frame
  vtkNew<AirlightScenePass> ScenePass;
  vtkNew<vtkCameraPass> CameraPass;
  vtkNew<vtkOpaquePass> OpaquePass;
  vtkNew<vtkHiddenLineRemovalPass> HiddenLinePass;
  int NumberOfRenderedProps = 0;
};
}

#endif
