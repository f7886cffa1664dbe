// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What vtkAirlightPass keeps from frame to frame, and how it draws one.
 */

#ifndef vtkAirlightPassInternals_h
#define vtkAirlightPassInternals_h

#include "Frame/AirlightFrame.h"
#include "MapperShaders/AirlightDepthPrePassVariants.h"
#include "MapperShaders/AirlightMaterialSpecializations.h"
#include "Medium/AirlightMediaList.h"
#include "OpenGL/AirlightProgram.h"
#include "Pass/AirlightContext.h"
#include "Pass/AirlightDelegate.h"
#include "Pass/AirlightScenePass.h"
#include "vtkAirlightPass.h"

#include "vtkCameraPass.h"
#include "vtkHiddenLineRemovalPass.h"
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

class vtkAbstractMapper;
class vtkActor;
class vtkCamera;
class vtkOpenGLRenderWindow;
class vtkRenderPass;
class vtkRenderState;
class vtkRenderer;
class vtkShaderProgram;
class vtkVolume;

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

  // Whether what a prop draws in the opaque stages, or in a delegate's own, is left for the one that
  // blends over the medium. Parts of assemblies are not.
  bool IsDrawnLater(vtkProp* prop);

  // Of volumes: that one is drawn with a shader of the graphics card, whether its samples go through
  // the medium; and after the frame, that those of which nothing was noted do not.
  void NoteVolume(vtkVolume* volume, bool through);
  void CheckVolumes(const vtkRenderState* s);

  void WarnOnce(bool& warned, const std::string& text);
  void CheckMedia();
  void CheckLamps(const std::vector<airlight::Lamp>& lamps, bool scattered);
  // By SetShadowTechnique()'s rule. Sets what the frame's casters are.
  int ChooseTechnique(vtkRenderer* renderer, const std::vector<airlight::Lamp>& lamps, bool clear);

  // For vtkAirlightPass::GetSilhouettes(). False with a reason in Error.
  bool CollectSilhouettes(vtkRenderer* renderer, std::vector<unsigned char>& bytes);

  // Speaks of passes outside that need what this one does not give.
  void CheckOutside(const vtkRenderState* s);

  // Whether the picture is VTK's own: in clear air without shadows on surfaces. VTK then draws it, with
  // the roundings of its own and with multisampling.
  bool ChangesNothing(const std::vector<airlight::Lamp>& lamps, bool clear);

  // Whether the renderer asks for FXAA and the bound target, the state's, is one for it.
  bool MayAntialias(const vtkRenderState* s);
  void CheckCasters();

  // Whether the window's OpenGL is new enough. False with a reason in Error.
  bool CheckOpenGL(vtkOpenGLRenderWindow* window);

  // Adds to a mapper's shaders, or leaves them as they are where that does not compile: NotCompiled
  // then names the mapper, and the frame is lost.
  using ShaderChange = std::function<void(std::string&)>;
  void AddToShader(const std::string& vertex, const std::string& geometry, std::string& fragment,
    vtkAbstractMapper* mapper, vtkProp* prop, const ShaderChange& change);
  bool CheckShaders();

  // InjectSurfaceShader() with the mappers' text. Of many actors' shaders most are the same.
  void ChangeSurfaceShader(std::string& shader, bool pointGaussians);

  // After a frame that could not be done: frees what may be broken.
  void Recover();

  // Whether each fragment of the opaque surfaces hides all that is behind it, as far as is known;
  // whether steps 1 and 3 of the frame may be one, of which Apart is the light whose shadows fall on
  // surfaces, if there is one.
  bool MayBeSolid(const vtkRenderState* s) const;
  // Whether all that is drawn as opaque is drawn by shaders that the pass adds to.
  bool KnowsAll(const vtkRenderState* s) const;
  bool IsSolid(const vtkRenderState* s) const;
  // Actors that are drawn as their mappers' inputs are, opaque everywhere; in order.
  std::vector<vtkProp*> FindSolids(const vtkRenderState* s) const;
  bool MayDrawOnce(bool solid, const std::vector<airlight::Lamp>& lamps, int& apart) const;

  vtkAirlightPass* Self;
  airlight::MediaList Media;
  airlight::LightSwitches Switches;
  std::vector<airlight::LightOptions> Lights; // those with photometric files
  airlight::Frame CurrentFrame;
  std::vector<airlight::ShadowVolumes> OwnShadows; // to send to them, by light number
  airlight::SurfaceStage Stage = airlight::SurfaceStage::Colour;
  int EffectiveTechnique = NONE;
  bool TooManyPlanes = false;                   // of this frame
  airlight::SurfaceShaderOptions ShaderOptions; // of the mappers' shaders
  bool DrawsMap = false;
  std::set<vtkShaderProgram*> MapPrograms; // those used for the map that is drawn
  vtkTimeStamp ShaderTime;
  std::string Error;
  airlight::ProgramMaker MapperPrograms;
  std::string NotCompiled;
  struct
  {
    std::string Before;
    std::string After;
    bool PointGaussians = false;
    bool Records = false;
    vtkMTimeType Time = 0;
  } LastChange; // of a surface's shader

  vtkNew<AirlightContext> Context;
  vtkNew<AirlightScenePass> ScenePass;
  vtkNew<vtkCameraPass> CameraPass;
  vtkNew<vtkOpaquePass> OpaquePass;
  vtkNew<vtkHiddenLineRemovalPass> HiddenLinePass;
  vtkNew<vtkParticipatingMedium> Vacuum;

  std::vector<vtkProp*> FrameProps; // those that the frame began with
  airlight::DelegateProps Shown;    // what a delegate is shown of them
  std::set<vtkProp*> Hidden;        // those kept from the stage of colours

  airlight::DepthPrePassVariants DepthPrePass;
  airlight::MaterialSpecializations Materials;

  std::set<vtkProp*> NotedVolumes;

  bool WarnedOpenGL = false;
  bool WarnedCasters = false;
  bool WarnedLevels = false;
  bool WarnedBudget = false;
  bool WarnedVolumes = false;
  bool WarnedMedia = false;
  bool WarnedLights = false;
  bool WarnedLightCount = false;
  bool WarnedCameraLights = false;
  bool WarnedPhotometry = false;
  bool WarnedGlowCount = false;
  bool WarnedGlowInImage = false;
  bool WarnedOcclusion = false;
  bool WarnedAntialiasing = false;
  bool WarnedTranslucent = false;
  std::string ReportedError;
  std::string ReportedCasterError;

private:
  bool RenderOnce(const vtkRenderState* s, int x, int y, int width, int height);
  bool RenderSteps(const vtkRenderState* s);
  bool CollectCasters();
  // Whether surfaces are lit by what the medium scatters.
  bool IsGlowing(const airlight::f64::AirlightMedia& media) const;
  bool CollectTranslucent(const vtkRenderState& inner);
  void RenderDistances(const vtkRenderState& inner);
  void RenderColours(const vtkRenderState& inner);
  void RenderTranslucent(const vtkRenderState& inner);
  void RenderStage(airlight::SurfaceStage stage, const std::function<void()>& render);
  void UpdateSurfaceShader(const airlight::f64::AirlightMedia& media,
    const std::vector<airlight::Lamp>& lamps, const airlight::FrameSettings& settings,
    bool parallel);
  bool DrawDistances(const vtkRenderState& inner);
  bool DrawColours(const vtkRenderState& inner);
  vtkRenderPass* GetDelegate(bool opaqueOnly);
  void DrawInMap(const vtkRenderState* s, const std::vector<airlight::NonPolygonalCaster>& casters,
    vtkCamera* camera, int x, int y, int side);
};

#endif
