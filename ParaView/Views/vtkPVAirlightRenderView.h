// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVAirlightRenderView
 * @brief   ParaView's render view, with its scene in a participating medium
 *
 * The view draws with a vtkAirlightPass in place of ParaView's own default pass, so that all else stays
 * as it is: picking, screenshots of any size, transparent backgrounds, FXAA, tone mapping, depth
 * peeling. The lights are ParaView's, those of the light kit and those added; all properties of the pass
 * have the same meaning, range and default here.
 *
 * Annotations of the layer above (titles, legends) are neither fogged nor do they cast shadows. The
 * axes at the centre and the axes grid stand in the scene and are fogged, but cast no shadows.
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

class vtkAirlightPass;
class vtkParticipatingMedium;

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

  /**
   * The medium. Default: none, which changes nothing but shadows on surfaces.
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

  void SetGridAxes3DActor(vtkPVGridAxes3DActor* axes) override;

protected:
  vtkPVAirlightRenderView();
  ~vtkPVAirlightRenderView() override;

  void Render(bool interactive, bool skip_rendering) override;

private:
  vtkPVAirlightRenderView(const vtkPVAirlightRenderView&) = delete;
  void operator=(const vtkPVAirlightRenderView&) = delete;

  bool Airlight = true;
  vtkNew<vtkAirlightPass> Pass;
};

#endif
