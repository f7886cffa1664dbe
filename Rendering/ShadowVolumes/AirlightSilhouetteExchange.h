// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What casts shadows in other processes, each of which draws a part of the scene: the silhouettes
 * of all their casters, light by light, not their triangles. They are sent as bytes.
 */

#ifndef AirlightSilhouetteExchange_h
#define AirlightSilhouetteExchange_h

#include "ShadowVolumes/AirlightShadowVolumes.h"

#include <glm/glm.hpp>

#include <memory>
#include <string>
#include <vector>

namespace airlight
{
// What the opaque casters of a process do in one light.
struct LightSilhouettes
{
  glm::dvec4 Light{ 0.0 };  // homogeneous world position
  glm::dvec3 Anchor{ 0.0 }; // of edges and caps, as ShadowVolumes::GetAnchor()
  int StartCount = 0;       // as ShadowVolumes::GetStartCount()
  std::vector<ShadowEdge> Edges;
  std::vector<ShadowCap> Caps;
};

// By light number.
using ProcessSilhouettes = std::vector<std::shared_ptr<const LightSilhouettes>>;

// What the shadow volumes of a process's casters say of it.
LightSilhouettes DescribeSilhouettes(const ShadowVolumes& volumes, const glm::dvec4& light);

// For processes on machines of one kind: the bytes of another kind are refused, as what is cut
// short.
std::vector<unsigned char> WriteSilhouettes(const std::vector<LightSilhouettes>& shadows);
// False with a reason in `error`.
bool ReadSilhouettes(
  const unsigned char* bytes, size_t size, ProcessSilhouettes& shadows, std::string& error);
}

#endif
