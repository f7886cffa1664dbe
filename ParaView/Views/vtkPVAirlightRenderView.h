// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVAirlightRenderView
 * @brief   ParaView's render view, with its scene in a participating medium
 *
 * The view renders with a vtkAirlightPass instead of ParaView's default pass; everything else works
 * as before. ParaView's lights that are added to the scene illuminate the medium, too. Lights fixed
 * to the camera, such as the light kit, illuminate surfaces only, see SetCameraLightsScatter().
 * SetLamp() adds a light that suits the data. All properties of the pass have the same meaning,
 * range and default here, except that the tone mapping may be automatic.
 *
 * Titles and legends in the layer above are neither fogged nor do they cast shadows. The axes at
 * the centre and the axes grid are in the scene and are fogged, but cast no shadows. With ray
 * tracing (OSPRay), ParaView renders with its own pass, without the medium. Parallel rendering and
 * its limits are described in Documentation/paraview.md.
 *
 * @sa vtkAirlightPass vtkPVParticipatingMedium
 */

#ifndef vtkPVAirlightRenderView_h
#define vtkPVAirlightRenderView_h

#include "vtkAirlightParaViewViewsModule.h" // for export macro
#include "vtkBoundingBox.h"                 // for the data's bounds
#include "vtkNew.h"                         // for the pass
#include "vtkPVRenderView.h"
#include "vtkSmartPointer.h" // for the pass around it

#include <memory> // for the silhouettes of other ranks
#include <vector> // for media

class AirlightFarPass;
class vtkAirlightPass;
class vtkAlgorithmOutput;
class vtkHenyeyGreensteinPhaseFunction;
class vtkParticipatingMedium;
class vtkPVParticipatingMedium;

namespace airlight
{
class MediumSources;
class RemoteDepths;
class RemoteSilhouettes;
class ViewLamp;
}

class VTKAIRLIGHTPARAVIEWVIEWS_EXPORT vtkPVAirlightRenderView : public vtkPVRenderView
{
public:
  static vtkPVAirlightRenderView* New();
  vtkTypeMacro(vtkPVAirlightRenderView, vtkPVRenderView);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Whether the scene is rendered in the medium. Off, the view is ParaView's own. Default: true.
   */
  vtkSetMacro(Airlight, bool);
  vtkGetMacro(Airlight, bool);
  ///@}

  ///@{
  /**
   * Whether lights that are fixed to the camera, such as the light kit, illuminate the medium and
   * cast shadows; see vtkAirlightLight::SetScatters(). Default: false.
   */
  vtkSetMacro(CameraLightsScatter, bool);
  vtkGetMacro(CameraLightsScatter, bool);
  ///@}

  ///@{
  /**
   * Whether there is a lamp above the visible data, to the left and slightly behind as ParaView
   * first shows them, and what it is like: the colour per RGB channel, 0 to 1; the brightness, the
   * radiance of a white surface at the data's centre over 1.1, at least 0; the radius for soft
   * shadows (vtkAirlightLight::SetRadius()), world units, at least 0; whether it is seen as a ball
   * of that radius. It follows the data's bounds. Default: false, (1, 1, 1), 1, 0, false.
   *
   * Its light may be that of a photometric file, aimed at the data's centre, whose brightest
   * direction has the brightness: see vtkAirlightLight::SetPhotometry() and SetPhotometryUp(). An
   * invalid file gives an error and the old one stays. Default: none, (0, 1, 0).
   */
  void SetLamp(bool on);
  void SetLampColor(double r, double g, double b);
  void SetLampBrightness(double brightness);
  void SetLampRadius(double radius);
  void SetLampVisible(bool visible);
  void SetLampPhotometry(const char* file);
  void SetLampPhotometryUp(double x, double y, double z);
  ///@}

  /**
   * The medium. The view passes the size of the visible data to a vtkPVParticipatingMedium. Those
   * of visible vtkPVMediumRepresentations stand beside it, at most eight in all. Default: none,
   * which leaves shadows on surfaces only.
   */
  void SetMedium(vtkParticipatingMedium* medium);

  ///@{
  /**
   * Pipeline sources of a vtkPVParticipatingMedium: the closed surface of its region SURFACE, from
   * polygons or the outer surface of other data, and the image of its density IMAGE. Update()
   * brings them up to date and gives all processes all of them. Where the data are none of that, as
   * an open surface, the medium is ignored with an error when it is drawn. Without a source that it
   * needs, there is no medium. Default: none.
   */
  void SetRegionSurfaceConnection(vtkAlgorithmOutput* connection);
  void SetDensityImageConnection(vtkAlgorithmOutput* connection);
  ///@}

  /**
   * The name of the point array that is the density. The other arguments are those of
   * vtkAlgorithm::SetInputArrayToProcess() and are ignored. Empty: the active scalars, or else the
   * first array. Default: empty.
   */
  void SetDensityArray(int, int, int, int, const char* name);

  ///@{
  /**
   * The names of the image's point arrays of the albedo and of factors of the emission; see
   * vtkParticipatingMedium::SetAlbedoArrayName(). Empty: those of the medium. Default: empty.
   */
  void SetAlbedoArrayName(const char* name);
  void SetEmissionArrayName(const char* name);
  ///@}

  ///@{
  /**
   * Whether data that are shown as volumes are media, as vtkAirlightPass::SetVolumeScatters() has
   * it: their opacity is extinction, their colours are albedo. On several ranks each has its own
   * part only: use vtkPVMediumRepresentation there. Default: false.
   */
  vtkSetMacro(VolumesScatter, bool);
  vtkGetMacro(VolumesScatter, bool);
  ///@}

  /**
   * Whether the media's light from the background stays what it is, though the background changes:
   * set by vtkSMAirlightRenderViewProxy. Default: false.
   */
  vtkSetMacro(KeepsBackground, bool);

  ///@{
  /**
   * Where volumes that are media send light, see vtkHenyeyGreensteinPhaseFunction: above 0 forward,
   * as clouds and smoke do. Range: [-0.99, 0.99]. Default: 0, evenly.
   */
  void SetVolumesAnisotropy(double anisotropy);
  double GetVolumesAnisotropy();
  ///@}

  ///@{
  /**
   * As in vtkAirlightPass.
   */
  void SetShadowTechnique(int technique);
  void SetShadowMapResolution(int resolution);
  void SetMaximumBoundariesPerPixel(double boundaries);
  void SetNumberOfSteps(int steps);
  void SetSurfaceShadows(bool on);
  void SetTranslucentShadows(bool on);
  void SetVolumeShadows(bool on);
  void SetScatteredSurfaceLight(bool on);
  void SetLinearInput(bool on);
  void SetRadianceExposure(double exposure); // SetExposure() is that of ParaView's tone mapping
  void SetAutomaticExposure(bool on);
  void SetOutputColorSpace(int space);
  void SetMultisampling(bool on);
  void SetDithering(bool on);
  void SetSubpixelFrames(int frames);
  void SetDebugView(int view);
  void SetLightRadius(double radius);
  void SetMemoryLimit(int limit);
  ///@}

  /**
   * As in vtkAirlightPass, or -1, automatic: NEUTRAL_PBR in a medium, and CLAMP without one or in
   * clear air, which looks as in ParaView's own view. Default: -1.
   */
  void SetToneMapping(int curve);

  ///@{
  /**
   * vtkAirlightPass::SetProgressiveRefinement() of a view that has an interactor, which asks for
   * the next frame. All frames of screenshots and of views without one, as those of servers, are
   * drawn at once. Default: false.
   */
  vtkSetMacro(ProgressiveRefinement, bool);
  vtkGetMacro(ProgressiveRefinement, bool);
  ///@}

  ///@{
  /**
   * In parallel rendering, depths do not tell which rank's picture is in front where something is
   * translucent or a volume; nor can ranks share SubpixelFrames or an automatic exposure. ParaView
   * sends all data to the first rank then (and to the client), which draws, if those that are
   * visible have no more than so many MiB. If they have more, or ParaView cannot merge them (pieces
   * of rectilinear grids, of images in several parts, of images whose axes are turned), each rank
   * draws its own part, with a warning. Range: 0, never, to 1900, as MPI sends less than 2 GiB at a
   * time. Default: 1024.
   */
  vtkSetClampMacro(GatherLimit, int, 0, 1900);
  vtkGetMacro(GatherLimit, int);
  ///@}

  /**
   * How many frames this process's last picture is the mean of.
   */
  int GetAccumulatedFrames();

  /**
   * The pass that renders the scene. In parallel rendering the view switches its SubpixelFrames and
   * multisampling off for a frame of which each rank draws a part.
   */
  vtkAirlightPass* GetAirlightPass();

  /**
   * In parallel rendering, the size in bytes of all ranks' silhouettes when they were last
   * gathered. 0 before that and in serial rendering.
   */
  vtkTypeInt64 GetGatheredBytes();

  /**
   * The pixels of the last frame that this rank left to others which have something nearer there.
   */
  vtkTypeInt64 GetPixelsLeftOut();

  void SetGridAxes3DActor(vtkPVGridAxes3DActor* axes) override;

  void Update() override;

protected:
  vtkPVAirlightRenderView();
  ~vtkPVAirlightRenderView() override;

  void Render(bool interactive, bool skip_rendering) override;
  void AboutToRenderOnLocalProcess(bool interactive) override;
  void UpdateBackground(vtkRenderer* renderer = nullptr) override;

private:
  vtkPVAirlightRenderView(const vtkPVAirlightRenderView&) = delete;
  void operator=(const vtkPVAirlightRenderView&) = delete;

  void SwitchCameraLights();
  void SwitchVolumes();
  void MeasureData();
  void FollowData();
  void ChooseToneMapping();
  bool IsParallel();
  bool DrawsBackground(bool interactive);
  bool IsInParts();
  bool NeedsAllData();
  void ChooseGathering();
  void WarnOfParts();
  void UpdateMedia();
  std::vector<vtkPVParticipatingMedium*> FindOwnMedia();
  void StartFrame();
  void EndFrame();

  bool Airlight = true;
  bool CameraLightsScatter = false;
  bool ProgressiveRefinement = false;
  bool InFrame = false; // of Render()
  bool KeepsBackground = false;
  bool VolumesScatter = false;
  bool VolumesScattered = false; // in the last frame
  vtkNew<vtkHenyeyGreensteinPhaseFunction> VolumeFunction;
  bool WarnedOfParts = false;
  int GatherLimit = 1024;
  bool FirstDraws = false; // the first rank has all data
  int ToneMapping = -1;
  vtkNew<vtkAirlightPass> Pass;
  vtkSmartPointer<vtkParticipatingMedium> Medium;
  vtkSmartPointer<vtkPVParticipatingMedium> OwnMedium; // null if it is of another class
  vtkSmartPointer<AirlightFarPass> FarPass;            // around it
  std::unique_ptr<airlight::RemoteSilhouettes> Remote;
  std::unique_ptr<airlight::RemoteDepths> Depths;
  std::unique_ptr<airlight::ViewLamp> Lamp;
  std::unique_ptr<airlight::MediumSources> Sources; // of OwnMedium
  vtkBoundingBox DataBounds;                        // visible, of all ranks
  bool Parallel = false;                            // the current frame
  unsigned long StartTag = 0;
};

#endif
