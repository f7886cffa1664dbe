// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The shadows of all lights, and what is kept of them from frame to frame.
 */

#ifndef AirlightLightShadows_h
#define AirlightLightShadows_h

#include "Inscatter/AirlightLightShadow.h"
#include "Inscatter/AirlightMapShadow.h"
#include "Inscatter/AirlightShadowMethod.h"
#include "ShadowVolumes/AirlightShadowLists.h"
#include "ShadowVolumes/AirlightSilhouetteExchange.h"
#include "Translucency/AirlightShadowTransmittance.h"

#include <cstdint>
#include <limits>
#include <memory>
#include <string>
#include <vector>

class vtkLight;
class vtkProp;
class vtkWindow;

namespace airlight
{
class MixedShadow;
class PlanesShadow;

class LightShadows
{
public:
  LightShadows();
  ~LightShadows();

  struct Options
  {
    ShadowMethod Method = ShadowMethod::None;
    bool SurfaceShadows = false;
    bool TranslucentShadows = false; // casters dim light by their opacity
    bool OpaqueOnly = false;         // translucent casters have no planes here
    bool LimitPlanes = false;        // too many boundaries are an error
    // Of planes, a pixel: casters that have more get a map.
    double MaximumBoundaries = std::numeric_limits<double>::infinity();
    bool MapNonPolygonal = false; // those without planes get a map, too
    int MapResolution = 1024;
    int Steps = 64;                // of a ray march
    std::uint64_t MemoryLimit = 0; // bytes
  };

  // Chooses the casters of a frame. `solids`: props of which each fragment hides what is behind it.
  // Here and below false with a reason in GetError() where OpenGL refuses.
  bool Prepare(const FrameScene& scene, const Options& options, const CasterCache& casters,
    const std::vector<vtkProp*>& solids);

  // Before Prepare(): how many boundaries of translucent casters a pixel would have in the light
  // with the most. Below 0 if one of them blocks some channels of light and not others.
  double EstimateTranslucent(
    const FrameScene& scene, const CasterCache& casters, const std::vector<vtkProp*>& solids);

  // Whether casters let light through, and what they leave of it on opaque surfaces.
  bool TransmitsLight() const { return this->Transmits; }
  const ShadowTransmittance& GetSurfaceTransmittance() const { return this->SurfaceTransmittance; }

  // Brings all shadows up to date, after Prepare().
  bool Update(const FrameScene& scene, const InscatterTargets& targets,
    const std::vector<NonPolygonalCaster>& nonPolygonal, const DrawActors& drawNonPolygonal);

  // A light's shadow; one without a shadow where it casts none.
  LightShadow& Get(const FrameScene& scene, int light);

  // A light's shadow map; null if it has none.
  MapShadow* GetMap(int light);

  // Whether nothing shadows a light, in the air and on surfaces.
  bool IsUnshadowed(const FrameScene& scene, int light)
  {
    return !this->Transmits && &this->Get(scene, light) == &this->None;
  }

  // How a light's shadows were drawn: by a map if some of its casters have one. NONE where it has
  // none, and without Update().
  ShadowMethod GetMethod(const vtkLight* light) const;

  // Whether a light's were drawn by a map.
  bool HasMap() const;

  // How many have one since they have too many boundaries, and how many a pixel would have with
  // them, in the light with the most.
  struct CostlyCasters
  {
    size_t Count = 0;
    double Boundaries = 0.0;
  };
  CostlyCasters GetCostlyCasters() const;

  // Whether drawing failed as there are too many boundaries for the memory limit.
  bool IsOverBudget() const;

  // The casters of other processes, for all frames until they are removed.
  void AddRemoteSilhouettes(const ProcessSilhouettes& remote) { this->Remote.push_back(remote); }
  void RemoveAllRemoteSilhouettes() { this->Remote.clear(); }
  bool HasRemoteSilhouettes() const { return !this->Remote.empty(); }

  // Sets what the inscatter shader reads of the start of the rays and of surfaces.
  void SetStartUniforms(vtkShaderProgram* program, const LightShadow& shadow, int light) const;

  // Draws the outlines of all shadow planes into the framebuffer that is bound.
  bool DrawWireframe(const FrameScene& scene, vtkTextureObject* distances);

  // Frees the shadow maps, which are large.
  void ReleaseMaps(vtkWindow* window);

  // Frees all OpenGL objects, or also what is known of casters.
  void ReleaseObjects(vtkWindow* window);
  void Release(vtkWindow* window);

  const std::string& GetError() const { return this->Error; }

private:
  struct OneLight;

  bool Fail(const std::string& reason);
  bool PrepareTransmittance(const FrameScene& scene);
  void ResizeLights(const FrameScene& scene);
  void MakeShadows(const FrameScene& scene);
  void MakeShadow(OneLight& light, bool casts);
  bool HasMaps() const;
  LightShadow* Find(const OneLight& light);
  bool UpdateLight(const FrameScene& scene, int light, const ShadowCasters& casters,
    const InscatterTargets& targets);
  bool UpdateMixed(const FrameScene& scene, int light, const ShadowCasters& casters,
    const InscatterTargets& targets);

  Options Current;
  ShadowLists Boundaries;
  MapPrograms Programs;
  ShadowTransmittance SurfaceTransmittance;
  std::vector<ProcessSilhouettes> Remote; // by process
  std::vector<OneLight> Lights;
  LightShadow None;
  MapShadow NoMap; // a ray march without a caster
  std::vector<PlanarOccluder> Faces;
  std::vector<Caster> OpaqueCasters;            // maps have light and dark only
  const std::vector<Caster>* Casters = nullptr; // null: there are no shadows
  bool Transmits = false;
  std::string Error;
};
}

#endif
