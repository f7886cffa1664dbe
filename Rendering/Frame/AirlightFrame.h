// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One frame of vtkAirlightPass, step by step, and what is kept from frame to frame:
 *
 *   1. distances of the opaque surfaces, pixels that are left out, and what casts shadows;
 *   2. for each light: shadow planes into lists, or casters into a shadow map, and from these
 *      airlight and the bit that says whether the light reaches the surface;
 *   3. colours of the scene, each light dimmed and shadowed;
 *   4. airlight + transmittance * colours, and what is drawn over it, translucent surfaces and
 *      volumes;
 *   5. into the caller's framebuffer.
 *
 * Most scenes are drawn once: steps 1 and 3 are one, in place of the first
 * (AirlightSceneStages.cxx). Where no light's airlight has shadows, step 2 is done with step 4
 * (AirlightUnshadowedLights.cxx).
 *
 * Where translucent things would cost too much, a coarse grid of the airlight takes their part in
 * steps 2 to 4 (Froxels).
 *
 * Each step is a class: GeometryPass (1, 3), LightShadows and InscatterPass (2), CompositePass (4,
 * 5), FrameRecorder. The frame knows their order and no more.
 */

#ifndef AirlightFrame_h
#define AirlightFrame_h

#include "Composite/AirlightCompositePass.h"
#include "Frame/AirlightFramePlan.h"
#include "Frame/AirlightFrameRecorder.h"
#include "Frame/AirlightFroxels.h"
#include "Frame/AirlightGeometryPass.h"
#include "Frame/AirlightLightWaysPass.h"
#include "Frame/AirlightPixelChoice.h"
#include "Frame/AirlightTargets.h"
#include "Inscatter/AirlightInscatterPass.h"
#include "Inscatter/AirlightLightShadows.h"
#include "MapperShaders/AirlightSurfaceUniforms.h"
#include "OpenGL/AirlightSamplerSlots.h"
#include "Scene/AirlightCameraUniforms.h"
#include "Scene/AirlightFrameScene.h"
#include "Scene/AirlightSceneArrays.h"
#include "Scene/AirlightSunDiscs.h"
#include "Translucency/AirlightTranslucentFragments.h"

#include <optional>
#include <string>
#include <vector>

class vtkImageData;
class vtkLight;
class vtkOpenGLRenderWindow;
class vtkRenderer;
class vtkVolume;
class vtkWindow;

namespace airlight
{
class SceneDrawer;

// Whether the media neither scatter nor absorb, and volumes cast no shadows.
bool IsClear(const f64::AirlightMedia& media);

class Frame
{
public:
  Frame();

  // SceneArrays::Upload() for the shaders, before Begin().
  bool Upload(vtkOpenGLRenderWindow* window, const SceneSources& sources,
    f64::AirlightMedia& converted, std::vector<SceneLight>& sceneLights);

  // What the casters of other processes do, for all frames until it is forgotten.
  void AddRemoteSilhouettes(const ProcessSilhouettes& remote)
  {
    this->Shadows.AddRemoteSilhouettes(remote);
  }
  void RemoveAllRemoteSilhouettes() { this->Shadows.RemoveAllRemoteSilhouettes(); }
  bool HasRemoteSilhouettes() const { return this->Shadows.HasRemoteSilhouettes(); }

  // LightShadows::EstimateTranslucent(), for the plan.
  double EstimateTranslucent(vtkOpenGLRenderWindow* window, const CameraUniforms& rays,
    const f64::AirlightMedia& media, const std::vector<SceneLight>& lights,
    const CasterCache& casters, const std::vector<vtkProp*>& solids);

  // How the frame is drawn; before Begin().
  void SetPlan(const FramePlan& plan) { this->Plan = plan; }
  const FramePlan& GetPlan() const { return this->Plan; }

  // The technique of the last frame: maps if any caster has one, else froxels if any is in their
  // grid; or that of a light in it.
  ShadowTechnique GetTechnique() const;
  ShadowTechnique GetTechnique(const vtkLight* light) const;
  // Those that have a map since they have too many boundaries.
  LightShadows::CostlyCasters GetCostlyCasters() const { return this->Shadows.GetCostlyCasters(); }

  // A renderer's scene in a frame.
  struct Input
  {
    vtkRenderer* Renderer;
    f64::AirlightMedia Media;
    std::vector<SceneLight> SceneLights;
    CameraUniforms Rays;
    const CasterCache* Casters;
    // Props of which each fragment hides what is behind it, drawn as their mappers' inputs are.
    std::vector<vtkProp*> Solids;
    DrawActors DrawInMap; // casters without polygons
    std::vector<SunDisc> Suns;
    std::vector<vtkVolume*> CastingVolumes; // those after the media
  };

  // Draws frames at the pixels of a mask alone (EdgeMean), until it is null again. The results of
  // the others are of no use. `hides`: nothing that draws the scene reads the pixels beside its
  // own, so that the others may be hidden.
  void SetMask(vtkTextureObject* mask, bool hides);

  // Who chooses the pixels of a frame that are drawn; null: all are. Ignored where a frame is more
  // than its opaque surfaces, is recorded, or is one of a mean.
  void SetPixelChooser(const PixelChoice::Chooser& choose) { this->ChoosePixels = choose; }

  // Sets up a frame. False with a reason in GetError() where the graphics card cannot.
  bool Begin(const Input& input);

  // Steps 1 to 4, for which `scene` draws its parts.
  bool Draw(SceneDrawer& scene);

  // Whether casters let light through; the mappers' shaders then have to know.
  bool HasShadowTransmittance() const { return this->Shadows.TransmitsLight(); }

  // Before the opaque surfaces are drawn and after them.
  void BeginSurfaces() { this->Geometry.BeginSurfaces(this->GetScene(), this->Plan); }
  void EndSurfaces() { this->Geometry.EndSurfaces(this->GetScene(), this->Plan); }

  // The buffers of vtkAirlightPass::GetBuffer(), after that.
  bool Record();
  vtkImageData* GetBuffer(const std::string& name) const { return this->Buffers.Get(name); }
  FrameRecorder& GetBuffers() { return this->Buffers; }
  void ForgetBuffers() { this->Buffers.Clear(); }

  // Step 5: into the framebuffer that is bound, with the viewport at x, y.
  bool Composite(int x, int y, const DisplayStage& display, bool blend);

  // The radiance, if the plan measures its exposure.
  vtkTextureObject* GetRadiance() { return this->Textures.Radiance; }

  // Over it, the edges of all shadow planes.
  bool DrawPlanes();

  bool IsClear() const { return airlight::IsClear(this->Current->Media); }
  // After a failure: of what there was too much, which a plan can do without.
  enum class Excess
  {
    None,
    Boundaries,
    Records // of translucent fragments
  };
  Excess GetExcess() const { return this->TooMuch; }

  SurfaceUniforms GetSurfaceUniforms(SurfaceStage stage);
  vtkOpenGLRenderWindow* GetWindow() const;
  vtkOpenGLFramebufferObject* GetFramebuffer() { return this->Textures.GetFramebuffer(); }
  const std::string& GetError() const { return this->Error; }

  // Frees all OpenGL objects, of which some may be what OpenGL refused; the next frame makes
  // others. Release() also forgets the casters.
  void ReleaseObjects(vtkWindow* window);
  void Release(vtkWindow* window);

private:
  bool Fail(const std::string& reason);
  bool DrawDistances(SceneDrawer& scene);
  bool DrawColours(SceneDrawer& scene);
  bool PrepareCasters();
  bool CollectFragments(SceneDrawer& scene);
  bool SortFragments();
  bool ScatterLights();
  bool WalkLightWays();
  LightShadows::Options GetShadowOptions() const;
  bool BeginFroxels();
  bool ScatterLight(const InscatterTargets& targets, int light);
  bool ClearScattered(const InscatterTargets& targets, float litBits);
  std::vector<int> FindEffectiveLights(float& litBits);
  bool LeavesNothing(int light);
  bool MayJoinOthers(int light);
  bool ScatterUnshadowed(const InscatterTargets& targets, const std::vector<int>& lights);
  bool CompositeTranslucent();
  bool LeavesPixelsOut();
  bool HasRadiance() const { return this->Plan.Translucent || this->Plan.MeasuresExposure; }

  FrameScene GetScene();
  InscatterTargets GetInscatterTargets();
  CompositePass::Options GetCompositeOptions() const;
  CompositePass::Inputs GetCompositeInputs();
  bool HasMoreLit() const { return this->Current->SceneLights.size() > BitsPerChannel; }
  bool RecordsSeveral() const
  {
    return this->Plan.Record && this->Current->Media.multiple.count > 0;
  }

  Targets Textures;
  SceneArrays Arrays;
  SamplerSlots Slots;
  TranslucentFragments FragmentLists;
  Froxels CoarseAir;
  GeometryPass Geometry;
  LightShadows Shadows;
  InscatterPass Inscatter;
  LightWaysPass LightWays;
  CompositePass Composition;
  FrameRecorder Buffers;
  std::string Error;

  vtkTextureObject* Mask = nullptr;
  PixelChoice::Chooser ChoosePixels;
  PixelChoice Choice;

  // This frame's.
  std::optional<Input> Current;
  FramePlan Plan;
  Excess TooMuch = Excess::None;
};
}

#endif
