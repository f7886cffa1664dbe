// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One frame of vtkAirlightPass, step by step, and what is kept from frame to frame:
 *
 *   1. distances of the opaque surfaces, and what casts shadows;
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
 */

#ifndef AirlightFrame_h
#define AirlightFrame_h

#include "Casters/AirlightCasters.h"
#include "Composite/AirlightCompositePass.h"
#include "Frame/AirlightFramePlan.h"
#include "Frame/AirlightFrameRecorder.h"
#include "Frame/AirlightTargets.h"
#include "MapperShaders/AirlightSurfaceUniforms.h"
#include "OpenGL/AirlightQuad.h"
#include "Scene/AirlightCameraUniforms.h"
#include "Scene/AirlightSceneData.h"
#include "Scene/AirlightSceneLights.h"
#include "ShadowMaps/AirlightShadowMap.h"
#include "ShadowVolumes/AirlightPlanarOccluders.h"
#include "ShadowVolumes/AirlightShadowLists.h"
#include "ShadowVolumes/AirlightShadowVolumes.h"
#include "ShadowVolumes/AirlightSilhouetteExchange.h"
#include "Translucency/AirlightShadowTransmittance.h"
#include "Translucency/AirlightTranslucentFragments.h"

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

class vtkImageData;
class vtkOpenGLRenderWindow;
class vtkParticipatingMedium;
class vtkProp;
class vtkRenderer;
class vtkShaderProgram;
class vtkTextureObject;
class vtkWindow;

namespace airlight
{
class SceneDrawer;

// Asks the shaders for what is recorded.
constexpr const char* RecordDefinition = "#define AIRLIGHT_RECORD\n";

// What the pass states of the airlight's relative error, beside the phase function's (see
// Documentation/accuracy.md).
constexpr float ClosedFormError = 1e-4f;
constexpr float QuadratureError = 1e-3f;
// In an image that its medium's region cuts: where the way to the light begins to leave the region
// instead of the image there is a kink, at which cells are not cut. 6e-3 measured.
constexpr float CutImageError = 1e-2f;

// Whether the media neither scatter nor absorb.
bool IsClear(const f64::AirlightMedia& media);

class Frame
{
public:
  // UploadData() for the shaders, before Begin().
  bool Upload(vtkOpenGLRenderWindow* window, const std::vector<vtkParticipatingMedium*>& media,
    f64::AirlightMedia& converted, std::vector<SceneLight>& sceneLights);

  // Finds what casts shadows, before Begin(), with what lets light through or without; and what of
  // it has no polygons to draw planes from.
  void FindCasters(vtkRenderer* renderer, bool translucent)
  {
    this->Casters.Collect(renderer, translucent);
  }
  // Whether there was something that lets light through.
  bool MetTranslucent() const { return this->Casters.MetTranslucent(); }
  const std::vector<NonPolygonalCaster>& GetNonPolygonalCasters() const
  {
    return this->Casters.GetNonPolygonal();
  }

  // What the casters of other processes do, for all frames until it is forgotten.
  void AddRemoteSilhouettes(const ProcessSilhouettes& remote)
  {
    this->RemoteSilhouettes.push_back(remote);
  }
  void RemoveAllRemoteSilhouettes() { this->RemoteSilhouettes.clear(); }
  bool HasRemoteSilhouettes() const { return !this->RemoteSilhouettes.empty(); }

  // How the frame is drawn; before Begin().
  void SetPlan(const FramePlan& plan) { this->Plan = plan; }
  const FramePlan& GetPlan() const { return this->Plan; }

  // A renderer's scene in a frame.
  struct Input
  {
    vtkRenderer* Renderer;
    f64::AirlightMedia Media;
    std::vector<SceneLight> SceneLights;
    CameraUniforms Rays;
    // Props of which each fragment hides what is behind it, drawn as their mappers' inputs are.
    std::vector<vtkProp*> Solids;
    DrawActors DrawInMap; // casters without polygons
  };

  // Sets up a frame. False with a reason in GetError() where the graphics card cannot.
  bool Begin(const Input& input);

  // Steps 1 to 4, for which `scene` draws its parts.
  bool Draw(SceneDrawer& scene);

  // Whether casters let light through; the mappers' shaders then have to know.
  bool HasShadowTransmittance() const { return this->TransmitsShadows; }
  const CasterCache& GetCasters() const { return this->Casters; }

  // Before the opaque surfaces are drawn and after them.
  void BeginSurfaces();
  void EndSurfaces();

  // The buffers of vtkAirlightPass::GetBuffer(), after that.
  bool Record();
  vtkImageData* GetBuffer(const std::string& name) const { return this->Buffers.Get(name); }
  void ForgetBuffers() { this->Buffers.Clear(); }

  // Step 5: into the framebuffer that is bound, with the viewport at x, y.
  bool Composite(int x, int y, bool blend);

  // Over it, the edges of all shadow planes.
  bool DrawPlanes();

  // For the meantime of what is drawn with a light's camera into a shadow map: its rays, and the
  // face's lower left corner.
  void SetMapRays(const CameraUniforms* rays, int x, int y);

  bool IsClear() const { return airlight::IsClear(this->Media); }
  // After a failure: whether it was for too many shadow boundaries.
  bool IsOverBudget() const { return this->OverBudget; }

  SurfaceUniforms GetSurfaceUniforms(SurfaceStage stage);

  // Brings them to the target that a delegate has bound, which may be of another size, and binds
  // the textures again whose units it may have used.
  void FitToTarget(SurfaceUniforms& values);
  vtkOpenGLRenderWindow* GetWindow() const { return this->Window; }
  vtkOpenGLFramebufferObject* GetFramebuffer() { return this->Textures.GetFramebuffer(); }
  const std::string& GetError() const { return this->Error; }

  // Frees all OpenGL objects, of which some may be what OpenGL refused; the next frame makes
  // others. Release() frees what is known of casters, too.
  void ReleaseObjects(vtkWindow* window);
  void Release(vtkWindow* window);

private:
  bool Fail(const std::string& reason);
  bool DrawDistances(SceneDrawer& scene);
  bool DrawColours(SceneDrawer& scene);
  bool CollectFragments(SceneDrawer& scene);
  bool PrepareCasters();
  bool ScatterLights();
  bool BindDistances();
  bool ResolveDistances();
  bool BindScene();
  bool BindSceneAndDistances();
  bool BindDepth();
  bool CompositeTranslucent();
  bool UpdateShadows();
  bool UpdateShadows(int index, const std::vector<Caster>& casters);
  ShadowVolumes::RemoteSilhouettes GetRemoteSilhouettes(int index) const;
  bool ScatterLight(int index);
  ShadowLists::Source GetPlanesSource(int index);
  bool ScatterWithLists(int index);
  bool ResolveLong(int index, int row, int rows);
  bool RecordSingle(int index);

  // Which pixels a draw of the resolve does.
  enum class Lists
  {
    None,     // all, without shadows
    Short,    // those with lists that it sorts itself
    Long,     // the others, sorted beforehand
    LongRest, // what the draw before left of them
    Map       // all, shadows from a map
  };
  bool Resolve(int index, Lists lists, int row, int rows);
  bool DrawResolve(int index, Lists lists, bool fragmentsOnly, int row, int rows);
  bool ResolvesEquiangular(int index, Lists lists);
  std::string GetResolveSource(int index, Lists lists, bool fragmentsOnly);
  std::string GetEquiangularResolveSource(int index, Lists lists) const;
  std::string GetResolveHead(int index, bool storage) const;
  void SetResolveUniforms(vtkShaderProgram* program, int index, Lists lists, bool fragmentsOnly);
  void SetStartUniforms(vtkShaderProgram* program, int index, bool planes);
  double GetIntegralError(int index) const;
  void SetMapUniforms(vtkShaderProgram* program, int index);
  ShadowMap* GetMap(int index) const;

  FrameScene GetScene();
  CompositePass::Options GetCompositeOptions() const;
  CompositePass::Inputs GetCompositeInputs();
  std::vector<vtkTextureObject*> GetScatterTargets();
  bool HasMoreLit() const { return this->SceneLights.size() > BitsPerChannel; }
  void ClearTarget(float value);
  void ClearDepth();
  void BlendColours();
  void ReleaseMaps(vtkWindow* window);

  Targets Textures;
  SceneData Data;
  LightGrids Grids;
  ShadowLists Boundaries;
  TranslucentFragments FragmentLists;
  CasterCache Casters;
  std::vector<ProcessSilhouettes> RemoteSilhouettes; // by process
  ShadowTransmittance SurfaceTransmittance;
  std::vector<ShadowVolumes> Volumes;           // by light number
  std::vector<std::unique_ptr<ShadowMap>> Maps; // likewise
  std::array<Quad, 5> ResolveQuads;             // none, short, long, map, records only
  Quad DistancesQuad;
  CompositePass Composition;
  Quad MapQuad; // of all maps, as are the programs
  ProgramMaker MapPrograms;
  FrameRecorder Buffers;
  std::string Error;

  // This frame's.
  vtkRenderer* Renderer = nullptr;
  vtkOpenGLRenderWindow* Window = nullptr;
  f64::AirlightMedia Media{};
  std::vector<SceneLight> SceneLights;
  std::optional<CameraUniforms> Rays;
  const CameraUniforms* MapRays = nullptr;
  const std::vector<Caster>* FoundCasters = nullptr; // null: without shadows
  std::vector<PlanarOccluder> Faces;                 // behind which no shadow planes are drawn
  std::vector<Caster> OpaqueCasters;                 // those for maps
  bool TransmitsShadows = false;
  int MapX = 0;
  int MapY = 0;
  FramePlan Plan;
  std::vector<vtkProp*> Solids;
  DrawActors DrawInMap;
  bool OverBudget = false;
  int Width = 0;
  int Height = 0;
};
}

#endif
