// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVAirlightRenderView
 * @brief   ParaView's render view, with its scene in a participating medium
 *
 * The view draws with a vtkAirlightPass in place of ParaView's own default pass, so that all else
 * stays as it is: picking, screenshots of any size, transparent backgrounds, FXAA, tone mapping,
 * depth peeling. The lights are ParaView's: those that are added to the scene light the medium, too,
 * and those that are fixed to the camera, as the light kit is, light surfaces only
 * (SetCameraLightsScatter()). All properties of the pass have the same meaning, range and default here.
 *
 * Annotations of the layer above (titles, legends) are neither fogged nor do they cast shadows. The
 * axes at the centre and the axes grid stand in the scene and are fogged, but cast no shadows.
 *
 * In parallel rendering each rank draws its surfaces in the medium, with the shadows of all ranks'
 * opaque polygonal actors, which are gathered whenever they change; IceT then takes the nearest
 * surface of each pixel. Where ParaView composites ranks in order, as it does for translucent
 * surfaces and volumes, the medium before other ranks' surfaces counts several times, and one
 * warning says so.
 *
 * While ray tracing (OSPRay) is on, ParaView draws with a pass of its own, without the medium.
 *
 * @sa vtkAirlightPass vtkPVParticipatingMedium
 */

#ifndef vtkPVAirlightRenderView_h
#define vtkPVAirlightRenderView_h

#include "vtkAirlightParaViewViewsModule.h" // for export macro
#include "vtkNew.h"                         // for the pass
#include "vtkPVRenderView.h"
#include "vtkSmartPointer.h" // for the pass around it

#include <memory> // for what other ranks have

class AirlightFarPass;
class vtkAirlightPass;
class vtkParticipatingMedium;
class vtkPVParticipatingMedium;

namespace airlight
{
class RemoteSilhouettes;
}

class VTKAIRLIGHTPARAVIEWVIEWS_EXPORT vtkPVAirlightRenderView : public vtkPVRenderView
{
public:
  static vtkPVAirlightRenderView* New();
  vtkTypeMacro(vtkPVAirlightRenderView, vtkPVRenderView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether the scene is drawn in the medium. Off, the view is ParaView's own. Default: true.
   */
  vtkSetMacro(Airlight, bool);
  vtkGetMacro(Airlight, bool);
  ///@}

  ///@{
  /**
   * Whether the medium scatters lights that are fixed to the camera, as those of the light kit, and
   * they cast shadows; see vtkAirlightPass::SetLightScatters(). Default: false.
   */
  vtkSetMacro(CameraLightsScatter, bool);
  vtkGetMacro(CameraLightsScatter, bool);
  ///@}

  /**
   * The medium. The view tells a vtkPVParticipatingMedium the size of the visible data. Default: none,
   * which changes nothing but shadows on surfaces.
   */
  void SetMedium(vtkParticipatingMedium* medium);

  ///@{
  /**
   * As in vtkAirlightPass.
   */
  void SetShadowTechnique(int technique);
  void SetShadowMapResolution(int resolution);
  void SetNumberOfSteps(int steps);
  void SetSurfaceShadows(bool on);
  void SetTranslucentShadows(bool on);
  void SetScatteredSurfaceLight(bool on);
  void SetLinearInput(bool on);
  void SetDebugView(int view);
  void SetLightRadius(double radius);
  void SetMemoryLimit(int limit);
  ///@}

  /**
   * The pass that draws the scene.
   */
  vtkAirlightPass* GetAirlightPass();

  /**
   * In parallel rendering, the bytes of all ranks' silhouettes that were gathered when they last
   * changed. 0 before and in serial rendering.
   */
  vtkTypeInt64 GetGatheredBytes();

  void SetGridAxes3DActor(vtkPVGridAxes3DActor* axes) override;

protected:
  vtkPVAirlightRenderView();
  ~vtkPVAirlightRenderView() override;

  void Render(bool interactive, bool skip_rendering) override;
  void AboutToRenderOnLocalProcess(bool interactive) override;

private:
  vtkPVAirlightRenderView(const vtkPVAirlightRenderView&) = delete;
  void operator=(const vtkPVAirlightRenderView&) = delete;

  void SwitchCameraLights();
  void MeasureScene();
  bool IsParallel();
  void StartFrame();

  bool Airlight = true;
  bool CameraLightsScatter = false;
  bool WarnedOrdered = false;
  vtkNew<vtkAirlightPass> Pass;
  vtkSmartPointer<vtkPVParticipatingMedium> OwnMedium; // null if it is of another class
  vtkSmartPointer<AirlightFarPass> FarPass;            // around it
  std::unique_ptr<airlight::RemoteSilhouettes> Remote;
  bool Parallel = false; // the frame that is drawn
  unsigned long StartTag = 0;
};

#endif
