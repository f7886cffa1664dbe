// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What vtkAirlightPass reports about media, lights, casters, volumes and other passes. Each message
 * names the remedy. A pass gives each once, and an error again if it has changed.
 */

#ifndef AirlightPassMessages_h
#define AirlightPassMessages_h

#include "Frame/AirlightFramePlan.h"
#include "Inscatter/AirlightLightShadows.h"
#include "Scene/AirlightSceneLights.h"
#include "Scene/AirlightUnseenLights.h"

#include <bitset>
#include <set>
#include <string>
#include <vector>

class vtkCamera;
class vtkObject;
class vtkOpenGLRenderWindow;
class vtkVolume;

namespace airlight
{
class CasterCache;
class MediaList;
struct SceneSupport;

class PassMessages
{
public:
  explicit PassMessages(vtkObject* pass)
    : Pass(pass)
  {
  }

  // An error if the media cannot all be drawn.
  void CheckMedia(const MediaList& media);

  // An error of the environment, or none.
  void CheckEnvironment(const std::string& error);

  // Lights that are left out, or lack a requested effect. `scattering`: a medium scatters.
  void CheckLights(
    const std::vector<SceneLight>& sceneLights, bool scattering, bool scatteredSurfaceLight);

  // Lights that are set to be visible and are not; once for each reason.
  void CheckVisibleLights(const std::vector<SceneLight>& sceneLights, vtkCamera* camera,
    const std::vector<vtkParticipatingMedium*>& media);

  // Lights whose light is scattered once, where it should be more often.
  void CheckMultiple(int lightsLeftOut);

  // A shadow technique other than the requested one, scattered light that a density image rules
  // out.
  void CheckPlan(const FramePlan& plan, const PassProperties& properties,
    const CasterCache& casters, vtkOpenGLRenderWindow* window);

  // A window that encodes what is encoded already.
  void CheckColorSpace(const DisplayStage& display, vtkOpenGLRenderWindow* window);

  // Casters that have a shadow map or are in a froxel grid as they have too many boundaries.
  void CheckCostlyCasters(const LightShadows::CostlyCasters& casters, const FramePlan& plan);

  // Keys of props that are no good, props that cannot cast.
  void CheckCasters(const CasterCache& casters, const FramePlan& plan);

  // A volume that its mapper draws without the medium before it; by another shader than VTK's, or
  // without the graphics card.
  void ReportVolumeShader(vtkVolume* volume);
  void ReportVolumeMapper(vtkVolume* volume);

  // A volume that cannot cast a shadow or be a medium; once for each text.
  void ReportVolume(const std::string& text);

  // A pass outside that needs what this one does not give.
  void CheckSupport(const SceneSupport& support);

  // FXAA that VTK's filter cannot do, in a target of this size.
  void ReportAntialiasing(const int size[2], bool floatingPoint);

  // An error that says why a frame is drawn without the medium, once until it succeeds or changes.
  void ReportFrame(const std::string& error);
  void ForgetFrame() { this->FrameError.clear(); }

private:
  enum Message
  {
    AntialiasingLeftOut,
    CameraLights,
    CostlyCasters,
    CostlyGaussians,
    CostlyTranslucency,
    EncodedTwice,
    InvalidLights,
    LevelsOfDetail,
    LightsScatteredOnce,
    ManyLights,
    ManyScatteredLights,
    Media,
    NonPolygonalCasters,
    OcclusionOutside,
    OldOpenGL,
    PhotometryUnused,
    PlanesOverMemory,
    RecordsOverMemory,
    ScatteredLightInImage,
    TranslucentInMaps,
    Volumes,
    NumberOfMessages
  };
  bool IsFirst(Message message);
  void WarnOnce(Message message, const std::string& text);
  void ErrorOnce(Message message, const std::string& text);

  vtkObject* Pass;
  std::bitset<NumberOfMessages> Given;
  std::set<UnseenReason> UnseenGiven;
  std::set<std::string> VolumesGiven;
  std::string FrameError;
  std::string CasterError;
  std::string EnvironmentError;
};
}

#endif
