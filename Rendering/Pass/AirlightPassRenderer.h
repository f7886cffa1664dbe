// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * vtkAirlightPass behind its face: what it keeps from frame to frame, and how it draws one.
 */

#ifndef AirlightPassRenderer_h
#define AirlightPassRenderer_h

#include "Frame/AirlightExposureMeter.h"
#include "Frame/AirlightFrame.h"
#include "Frame/AirlightFramePlan.h"
#include "Medium/AirlightEnvironment.h"
#include "Medium/AirlightMediaList.h"
#include "Pass/AirlightContext.h"
#include "Pass/AirlightEdgeSamples.h"
#include "Pass/AirlightIdleRender.h"
#include "Pass/AirlightMapperHooks.h"
#include "Pass/AirlightPassMessages.h"
#include "Pass/AirlightRefinement.h"
#include "Pass/AirlightSceneStages.h"
#include "Pass/AirlightSubpixelFrames.h"
#include "Scene/AirlightLampShapes.h"
#include "Scene/AirlightSunDiscs.h"
#include "Scene/AirlightVolumeExtinction.h"
#include "Scene/AirlightVolumeMedia.h"

#include "vtkNew.h"
#include "vtkParticipatingMedium.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderPass;
class vtkRenderState;
class vtkRenderer;

namespace airlight
{
class StateSaver;

class PassRenderer
{
public:
  // What the pass is set to.
  struct Settings
  {
    PassProperties Properties;
    double LightRadius = 0.0;
    bool Environment = false;   // the media scatter the renderer's environment
    int SubpixelFrames = 1;     // the picture is the mean of so many
    bool Progressive = false;   // each picture adds one of them
    bool Requested = false;     // by the pass, for the next of them
    bool Multisampling = false; // one frame has more samples at its edges
    airlight::SubpixelFrames::Progress Progress;
    vtkRenderPass* Delegate = nullptr;
    PixelChoice::Chooser ChoosePixels; // null: all pixels are drawn
  };
  // Where a frame goes: the viewport in the framebuffer that is bound.
  struct Viewport
  {
    int X = 0;
    int Y = 0;
    int Width = 0;
    int Height = 0;
  };

  PassRenderer(vtkObject* pass, const SceneStages::RenderHooks& hooks);
  ~PassRenderer();
  PassRenderer(const PassRenderer&) = delete;
  void operator=(const PassRenderer&) = delete;

  MediaList Media; // as vtkAirlightPass is given them

  // Draws the scene in the media, or without them where that fails, with an error.
  void Render(const vtkRenderState* s, const Settings& settings, const Viewport& viewport);

  // For vtkAirlightPass::GetSilhouettes(). False with a reason in `error`.
  bool CollectSilhouettes(vtkRenderer* renderer, double lightRadius,
    std::vector<unsigned char>& bytes, std::string& error);

  // Frees all OpenGL objects, in whichever window they are.
  void Release() { this->Context->SetContext(nullptr); }

  // How many frames the last picture is the mean of.
  int GetAccumulatedFrames() const { return this->AccumulatedFrames; }

  // Whether the next picture adds frames to the last one.
  bool IsUnfinished() const { return this->Unfinished; }

  // The factor of the last picture's radiance.
  double GetEffectiveExposure() const { return this->EffectiveExposure; }

  IdleRender& GetIdle() { return this->Idle; }
  Frame& GetFrame() { return this->CurrentFrame; }
  MapperHooks& GetMappers() { return this->Mappers; }
  SceneStages& GetStages() { return this->Stages; }

private:
  struct Scene;

  static std::array<size_t, 3> RecordsKey(const Scene& scene);
  void RenderScene(const vtkRenderState* s, const Settings& settings, const Viewport& viewport);
  bool RenderSeveral(const vtkRenderState* s, const Settings& settings,
    const std::function<bool(StateSaver& saver)>& draw);
  bool RenderMean(const vtkRenderState* s, const Settings& settings, const Viewport& viewport);
  bool RenderMultisampled(
    const vtkRenderState* s, const Settings& settings, const Viewport& viewport);
  bool RenderSamples(const vtkRenderState* s, const Settings& settings, const Viewport& viewport);
  bool AddFrames(const vtkRenderState* s, const Settings& settings, const Viewport& viewport);
  bool FindDisplay(vtkRenderer* renderer, const Settings& settings, vtkTextureObject* radiances,
    const glm::ivec4& picture, DisplayStage& display);
  bool MeasureExposure(vtkRenderer* renderer, vtkTextureObject* radiances,
    const glm::ivec4& picture, DisplayStage& display);
  bool RenderFrame(const vtkRenderState* s, const Settings& settings, const Viewport& viewport);
  bool RenderPlan(const vtkRenderState* s, const Settings& settings, const Viewport& viewport,
    const FrameLimits& limits, Scene& scene);
  const SkyHarmonics* FindEnvironment(vtkRenderer* renderer, const Settings& settings);
  bool CollectScene(const vtkRenderState* s, const Settings& settings, Scene& scene);
  std::vector<vtkProp*> FindProps(const vtkRenderState* s);
  void DrawWithoutMedia(const vtkRenderState* s);
  void CollectVolumes(Scene& scene);
  void CollectProps(const vtkRenderState* s, const Settings& settings, Scene& scene);
  SceneFacts GetFacts(const Scene& scene) const;
  bool Draw(const vtkRenderState* s, const FramePlan& plan, Scene& scene, const Viewport& viewport);
  bool Fail(const std::string& reason);
  void Recover();

  vtkObject* Pass;
  CasterCache Casters;
  VolumeExtinctions Extinctions;
  VolumeMedia ScatteringVolumes;
  std::vector<vtkSmartPointer<vtkParticipatingMedium>> MediaOfVolumes; // of the picture
  std::vector<vtkProp*> VolumesAsMedia;                                // these volumes
  Frame CurrentFrame;
  SubpixelFrames Mean;
  EdgeSamples Edges;
  vtkTextureObject* EdgeMask = nullptr; // of a frame at edges alone
  bool FoundPlain = false;              // a frame that VTK draws itself
  Refinement Refined;
  IdleRender Idle; // for the next frame of it
  int AccumulatedFrames = 0;
  bool Unfinished = false;
  ExposureMeter Exposure;
  Environment Sky;
  LampShapes Lamps;
  std::vector<SunDisc> Suns; // of the picture, which the frames of a mean move
  double EffectiveExposure = 1.0;
  PassMessages Messages;
  MapperHooks Mappers;
  SceneStages Stages;
  std::vector<ShadowVolumes> OwnShadows; // to send to other processes, by light number
  vtkNew<AirlightContext> Context;
  vtkNew<vtkParticipatingMedium> Vacuum;
  std::string Error;
  std::array<size_t, 3> TooManyRecords{}; // the RecordsKey() of a scene that had
};
}

#endif
