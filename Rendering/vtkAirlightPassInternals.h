// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What vtkAirlightPass keeps from frame to frame, and how it draws one.
 */

#ifndef vtkAirlightPassInternals_h
#define vtkAirlightPassInternals_h

#include "AirlightContext.h"
#include "AirlightFrame.h"
#include "AirlightMediaList.h"
#include "AirlightScenePass.h"
#include "vtkAirlightPass.h"

#include "vtkCameraPass.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkOpaquePass.h"
#include "vtkParticipatingMedium.h"
#include "vtkSmartPointer.h"
#include "vtkTimeStamp.h"
#include "vtkWeakPointer.h"

#include <functional>
#include <set>
#include <string>
#include <vector>

class vtkActor;
class vtkCamera;
class vtkOpenGLRenderWindow;
class vtkRenderPass;
class vtkRenderState;
class vtkRenderer;
class vtkShaderProgram;

class vtkAirlightPass::Internals
{
public:
  explicit Internals(vtkAirlightPass* self);
  ~Internals();

  // Tells the camera whether it is one of a stereo pair.
  void UpdateStereo(vtkRenderer* renderer);

  // Draws the scene as if the pass were not there.
  void RenderPlain(const vtkRenderState* s);

  // The whole frame. False with a reason in Error where it could not be done.
  bool RenderFrame(const vtkRenderState* s, int x, int y, int width, int height);

  // What is said of a light, made where there is nothing yet; those of lights that are gone are
  // forgotten.
  airlight::LightOptions& GetOptions(vtkLight* light);
  const airlight::LightOptions* FindOptions(vtkLight* light) const;

  // Whether a prop of the opaque stages is left for the one that blends over the medium. Parts of
  // assemblies are not.
  bool IsDrawnLater(vtkProp* prop);

  void WarnOnce(bool& warned, const std::string& text);
  void CheckMedia();
  void CheckLamps(const std::vector<airlight::Lamp>& lamps);
  void CheckCasters();
  int ChooseTechnique(vtkOpenGLRenderWindow* window);

  vtkAirlightPass* Self;
  airlight::MediaList Media;
  std::vector<airlight::LightOptions> Lights; // those of which the pass says something
  airlight::Frame CurrentFrame;
  airlight::SurfaceStage Stage = airlight::SurfaceStage::Colour;
  int EffectiveTechnique = NONE;
  airlight::SurfaceText MapperText; // of the mappers' shaders
  bool DrawsMap = false;
  std::set<vtkShaderProgram*> MapPrograms; // those used for the map that is drawn
  vtkTimeStamp ShaderTime;
  std::string Error;

  vtkNew<AirlightContext> Context;
  vtkNew<AirlightScenePass> ScenePass;
  vtkNew<vtkCameraPass> CameraPass;
  vtkNew<vtkOpaquePass> OpaquePass;
  vtkNew<vtkParticipatingMedium> Vacuum;

  std::vector<vtkProp*> FrameProps; // those that the frame began with

  bool WarnedOpenGL = false;
  bool WarnedMedia = false;
  bool WarnedLights = false;
  bool WarnedLightCount = false;
  bool WarnedPhotometry = false;
  bool WarnedGlowCount = false;
  bool WarnedTranslucent = false;
  std::string ReportedError;
  std::string ReportedCasterError;

private:
  bool RenderSteps(const vtkRenderState* s);
  bool CollectCasters();
  bool CollectLayers(const vtkRenderState& inner);
  void RenderStage(airlight::SurfaceStage stage, const std::function<void()>& render);
  void UpdateSurfaceShader(const airlight::f64::AirlightMedia& media,
    const std::vector<airlight::Lamp>& lamps, bool translucent);
  vtkRenderPass* GetDelegate(bool opaqueOnly);
  void DrawInMap(const vtkRenderState* s, const std::vector<vtkActor*>& actors, vtkCamera* camera,
    int x, int y, int side);
};

#endif
