// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The airlight in a coarse grid of the view's frustum, for frames in which each translucent
 * fragment, or each shadow boundary of a translucent caster, would cost too much (grids of froxels:
 * S. Hillaire, "Physically Based and Unified Volumetric Rendering in Frostbite", SIGGRAPH 2015).
 * The rays of a coarse picture have nodes at equal depths. Shadow planes of all casters are drawn
 * into it, and their boundaries are added up between nodes: what arrives at a node is exact, and
 * where it changes in between is not known. Whatever the number of boundaries, a ray takes the same
 * time and memory. At each node the grid has
 *
 *   - the airlight before it, for translucent fragments;
 *   - what translucent casters take of this, to be taken from that of the pixels, which they are
 *     left out of;
 *   - for each light what arrives, for surfaces.
 */

#ifndef AirlightFroxels_h
#define AirlightFroxels_h

#include "Frame/AirlightTargets.h"
#include "Inscatter/AirlightMapShadow.h"
#include "Inscatter/AirlightPlanesShadow.h"
#include "Scene/AirlightFrameScene.h"
#include "Translucency/AirlightFroxelNodes.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

class vtkRenderer;
class vtkWindow;

namespace airlight
{
class Froxels
{
public:
  struct Options
  {
    double Boundaries = 0.0;        // that a pixel would have
    double MaximumBoundaries = 1.0; // that it may have
    bool Transmits = false;         // casters let light through
    bool Record = false;
    std::uint64_t MemoryLimit = 0; // bytes
  };

  // For a frame: lays out the grid. Here and below false with a reason in GetError() where OpenGL
  // refuses.
  bool Begin(vtkRenderer* renderer, const FrameScene& scene, const Options& options);

  // Light by light: its shadows, also from a map that it may have, its airlight before each node,
  // and from the targets what translucent casters take of it.
  bool ScatterLight(const FrameScene& scene, int light, const std::vector<Caster>& casters,
    MapShadow* map, const InscatterTargets& targets);

  // Makes the texture, after the last light.
  bool Finish(const FrameScene& scene);
  const FroxelNodes& GetNodes() const { return this->Nodes; }

  const std::string& GetError() const { return this->Error; }
  void Release(vtkWindow* window);

private:
  bool Fail(const std::string& reason);
  FrameScene GetCoarse(const FrameScene& scene) const;
  InscatterTargets GetTargets();
  bool UpdateShadow(const FrameScene& coarse, int light, const std::vector<Caster>& casters);
  bool DrawRays(const FrameScene& coarse, int light, MapShadow* map);
  bool DrawLoss(const FrameScene& scene, const InscatterTargets& targets);
  bool DrawTexture(const FrameScene& scene, int firstKind, int kinds);

  Options Current;
  std::optional<CameraUniforms> Rays;
  Targets Textures;
  FroxelNodes Nodes;
  ShadowLists Boundaries;
  std::vector<std::unique_ptr<PlanesShadow>> Shadows; // by light
  Quad RayQuad;
  Quad LossQuad;
  std::string Error;
};
}

#endif
