// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What vtkAirlightPass draws where it is given no delegate: the scene as a renderer without a pass
 * draws it, in parts, since the medium comes between them.
 */

#ifndef AirlightScenePass_h
#define AirlightScenePass_h

#include "vtkNew.h"
#include "vtkRenderPass.h"

#include <functional>
#include <vector>

class vtkDualDepthPeelingPass;
class vtkFrameBufferObjectBase;
class vtkOpenGLFXAAFilter;
class vtkOrderIndependentTranslucentPass;
class vtkProp;
class vtkTranslucentPass;
class vtkWindow;

class AirlightScenePass : public vtkRenderPass
{
public:
  static AirlightScenePass* New();
  vtkTypeMacro(AirlightScenePass, vtkRenderPass);

  // All of the scene, or its opaque geometry alone; for a vtkCameraPass.
  void Render(const vtkRenderState* s) override;
  void SetOpaqueOnly(bool only) { this->OpaqueOnly = only; }

  // Called before and after the opaque geometry, where it is drawn alone.
  void SetAroundOpaque(const std::function<void()>& before, const std::function<void()>& after)
  {
    this->BeforeOpaque = before;
    this->AfterOpaque = after;
  }

  // Brings the lights of the renderer into place (headlights and camera lights follow the camera)
  // and into its mappers.
  void PrepareLights(vtkRenderer* renderer);

  // Whether an actor is drawn as point Gaussians: blended with what is behind, at any opacity,
  // though VTK draws opaque ones with the opaque surfaces.
  static bool IsPointGaussians(vtkProp* prop);
  static bool IsEmissive(vtkProp* prop);

  // Point Gaussians, translucent surfaces, and of these props the volumes, plainly.
  static void RenderFragments(const vtkRenderState* s, const std::vector<vtkProp*>& rayCast);

  // Opaque point Gaussians, translucent surfaces with this pass or, without one, as the renderer's
  // settings say, then volumes.
  void RenderTransparent(const vtkRenderState* s, vtkRenderPass* translucentPass);

  // The same of the renderer's props that are in the state only, but for volumes, with the passes
  // that the renderer's settings say.
  void RenderTransparentOf(const vtkRenderState* s);

  // Into the framebuffer that is bound: VTK's FXAA of it; annotations.
  void Antialias(vtkRenderer* renderer);
  static void RenderOverlay(const vtkRenderState* s);

  void ReleaseGraphicsResources(vtkWindow* window) override;

protected:
  AirlightScenePass();
  ~AirlightScenePass() override;

private:
  AirlightScenePass(const AirlightScenePass&) = delete;
  void operator=(const AirlightScenePass&) = delete;

  bool OpaqueOnly = false;
  std::function<void()> BeforeOpaque;
  std::function<void()> AfterOpaque;
  vtkNew<vtkOpenGLFXAAFilter> Antialiasing;
  vtkNew<vtkTranslucentPass> Blending;
  vtkNew<vtkOrderIndependentTranslucentPass> Unordered;
  vtkNew<vtkDualDepthPeelingPass> Peeling;
};

#endif
