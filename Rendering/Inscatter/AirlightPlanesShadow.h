// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A light's shadow from shadow volumes: their planes make lists of boundaries, a list a pixel
 * (ShadowVolumes/AirlightShadowLists.h).
 */

#ifndef AirlightPlanesShadow_h
#define AirlightPlanesShadow_h

#include "Inscatter/AirlightLightShadow.h"
#include "ShadowVolumes/AirlightShadowLists.h"

#include <cstddef>
#include <limits>
#include <vector>

namespace airlight
{
class PlanesShadow : public LightShadow
{
public:
  // The lists are those of all lights, which are drawn one after the other.
  explicit PlanesShadow(ShadowLists& lists);

  // Leaves out casters by FindCostlyCasters() if there are more boundaries a pixel.
  void SetMaximumBoundaries(double most) { this->MaximumBoundaries = most; }
  // Leaves out translucent casters; they are not among GetLeftOut().
  void SetOpaqueOnly(bool only) { this->OpaqueOnly = only; }
  // How many boundaries of translucent casters a pixel would have. Update() for the same casters
  // comes next.
  double EstimateTranslucent(const FrameScene& scene, int light, const ShadowCasters& casters);

  // Those of the last Update(), and how many boundaries a pixel would have with them.
  const std::vector<Caster>& GetLeftOut() const { return this->LeftOut; }
  double GetEstimate() const { return this->Estimate; }

  bool Update(const FrameScene& scene, int light, const ShadowCasters& casters,
    const InscatterTargets& targets) override;
  bool HasShadow() const override { return this->Volumes.HasShadows(); }
  bool ForEachDraw(const FrameScene& scene, int light, const InscatterTargets& targets,
    bool counted, const Draw& draw) override;
  bool UsesStorage() const override { return true; }
  bool CountsBoundaries() const override { return this->Lists.HasKBuffer(); }
  std::string GetBoundarySource(const InscatterDraw& draw, bool counted) const override;
  void Bind(vtkShaderProgram* program, const FrameScene& scene, const InscatterDraw& draw) override;
  int GetStartCount() const override { return this->Volumes.GetStartCount(); }
  CasterOpticalThickness GetStartThickness() const override
  {
    return this->Volumes.GetStartLayers();
  }
  double GetThicknessError() const override;
  size_t GetEdgeCount() const override { return this->Volumes.GetEdges().size(); }

  // Adds the boundaries to the nodes of a froxel grid, into whose framebuffer `targets` binds.
  bool FillNodes(
    const FrameScene& scene, int light, const InscatterTargets& targets, const FroxelNodes& nodes);

  // Draws the outlines of the planes into the framebuffer that is bound.
  bool DrawWireframe(const FrameScene& scene, int light, vtkTextureObject* distances);

private:
  void UpdateSilhouettes(const FrameScene& scene, int light, const ShadowCasters& casters);
  std::vector<double> EstimateEdges(
    const FrameScene& scene, const std::vector<Caster>& casters) const;
  std::vector<bool> FindLeftOut(const FrameScene& scene, const std::vector<Caster>& casters);
  ShadowLists::Source GetSource(const FrameScene& scene, int light, vtkTextureObject* distances);
  bool DrawLong(bool counted, int row, int rows, const Draw& draw);

  ShadowLists& Lists;
  ShadowVolumes Volumes;
  double MaximumBoundaries = std::numeric_limits<double>::infinity();
  bool OpaqueOnly = false;
  std::vector<Caster> LeftOut;             // of the last Update()
  double Estimate = 0.0;                   // likewise
  std::vector<glm::vec4> TruncationPlanes; // likewise
};
}

#endif
