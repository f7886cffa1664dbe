// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The shadow volumes of all casters in one light: the edges to draw planes from, and how many
 * volumes hold the start of the view rays. Kept between frames; a caster that neither moved nor
 * changed keeps its silhouette while the light stands still.
 */

#ifndef AirlightShadowVolumes_h
#define AirlightShadowVolumes_h

#include "Casters/AirlightCasters.h"
#include "ShadowVolumes/AirlightShadowRecords.h"

#include <glm/glm.hpp>

#include <cstddef>
#include <memory>
#include <vector>

namespace airlight
{
class ClippedRegions;
class CameraUniforms;
class RayStart;
struct LightSilhouettes;

class ShadowVolumes
{
public:
  // `light` is the homogeneous world position; `anyPicture`: for views of any width and height.
  // Returns true where edges, near edges or caps changed.
  bool Update(const std::vector<Caster>& casters, const glm::dvec4& light,
    const CameraUniforms& view, bool anyPicture = false);

  // Update() in two steps: the silhouettes of all casters, and then the edges and caps of those
  // that are not left out in between.
  void UpdateSilhouettes(const std::vector<Caster>& casters, const glm::dvec4& light,
    const CameraUniforms& view, bool anyPicture = false);
  void LeaveOut(const std::vector<bool>& casters); // by number; none if empty
  bool Collect(const CameraUniforms& view);

  // The edges of a caster's silhouette, and its triangles that rays go through.
  const std::vector<ShadowEdge>& GetEdges(size_t caster) const { return this->Parts[caster].Edges; }
  const std::vector<ShadowCap>& GetCaps(size_t caster) const { return this->Parts[caster].Caps; }

  // What the casters of other processes do in this light, for Update() to add.
  using RemoteSilhouettes = std::vector<std::shared_ptr<const LightSilhouettes>>;
  void SetRemoteSilhouettes(const RemoteSilhouettes& remotes);

  const std::vector<ShadowEdge>& GetEdges() const { return this->Edges; }
  const std::vector<ShadowCap>& GetCaps() const { return this->Caps; }
  // Planes, or casters that enclose the light and leave none: then the start of the rays, and all
  // else outside, is in their shadow.
  bool HasShadows() const
  {
    return !this->Edges.empty() || !this->NearEdges.empty() || !this->Caps.empty() ||
      this->StartCount != 0;
  }
  // Shadow volumes that hold the start of the rays, and what their layers do together.
  int GetStartCount() const { return this->StartCount; }
  const CasterOpticalThickness& GetStartLayers() const { return this->StartLayers; }

  // What the layers of the casters do, each kind once.
  const std::vector<CasterOpticalThickness>& GetLayers() const { return this->Layers; }

  // The edges on whose planes rays start or nearly so, which the eye sees edge-on. They are not
  // among GetEdges().
  const std::vector<NearEdge>& GetNearEdges() const { return this->NearEdges; }

  // The world position that edges and caps are relative to: the light, or where it is at infinity
  // a place among the casters.
  const glm::dvec3& GetAnchor() const { return this->Anchor; }

  // The light that edges and caps are of: Update()'s, but for one that shines against a parallel
  // view. All its planes are behind the view, and it is turned aside by too little to see.
  const glm::dvec4& GetLight() const { return this->Light; }
  bool IsAgainstView() const { return this->AgainstView; }

private:
  struct Part
  {
    Caster Source;
    bool Capped = false;
    std::vector<ShadowEdge> Edges;
    std::vector<ShadowCap> Caps;
  };

  void SetAnchor(const std::vector<Caster>& casters);
  glm::dvec3 GetRelativePoint(const Caster& caster, int point) const;
  void MakeEdges(Part& part) const;
  void MakeCaps(Part& part) const;
  void CollectEdges();
  void CollectRemoteSilhouettes();
  float GetLayerIndex(const CasterOpticalThickness& layer);
  bool IsLeftOut(size_t caster) const { return !this->LeftOut.empty() && this->LeftOut[caster]; }
  bool UpdateParts(const std::vector<Caster>& casters, const ClippedRegions& view, bool moved);
  bool SplitNearEdges(const RayStart& start);
  void CountAtStart(const RayStart& start);

  glm::dvec4 Light{ 0.0 };
  bool AgainstView = false;
  glm::dvec4 Start{ 0.0 };
  glm::dvec3 Anchor{ 0.0 };
  std::vector<Part> Parts;   // in the order of the casters
  std::vector<bool> LeftOut; // likewise
  bool Changed = false;
  RemoteSilhouettes Remote;
  bool RemoteChanged = false;
  std::vector<ShadowEdge> Edges;
  std::vector<NearEdge> NearEdges;
  std::vector<ShadowCap> Caps;
  std::vector<CasterOpticalThickness> Layers;
  CasterOpticalThickness StartLayers;
  int StartCount = 0;
};
}

#endif
