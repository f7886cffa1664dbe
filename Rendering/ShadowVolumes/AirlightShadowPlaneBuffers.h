// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The buffers that all lights' shadow planes are drawn from, see AirlightShadowRecords.h.
 */

#ifndef AirlightShadowPlaneBuffers_h
#define AirlightShadowPlaneBuffers_h

#include "ShadowVolumes/AirlightShadowVolumes.h"

#include <glm/glm.hpp>

#include <string>
#include <vector>

namespace airlight
{
// As in glsl/AirlightPlanesVS.glsl.
enum class PlaneKind
{
  Plane,
  Cap,
  Near
};

class ShadowPlaneBuffers
{
public:
  // What indices of 16 bits reach, four vertices a plane. Multiples of 16 records are aligned as
  // parts of a storage buffer have to be.
  static constexpr int PlanesPerDraw = 16368;
  // Caps and near planes, up to 64 bytes each: what the smallest storage blocks hold.
  static constexpr int RecordsPerDraw = 1 << 18;

  // Uploads a light's edges and caps. False with a reason in GetError() where there is no memory
  // for them.
  bool SetVolumes(int light, const ShadowVolumes& volumes);

  // The planes behind which a caster hides all, by caster (FindTruncationPlanes()). They change
  // with the view, and are few.
  bool SetTruncationPlanes(const std::vector<glm::vec4>& planes);

  bool IsEmpty(PlaneKind kind, int light) const { return this->Get(kind, light).Count == 0; }

  // Draws a light's planes with the current program, by parts that a storage block of any driver
  // holds. Front faces are seen from outside the volume.
  void Draw(PlaneKind kind, int light) const;

  const std::string& GetError() const { return this->Error; }

  void Release();

private:
  struct Buffer
  {
    unsigned int Handle = 0;
    int Count = 0;
  };
  struct LightBuffers
  {
    Buffer Edges;
    Buffer NearEdges;
    Buffer Caps;
    Buffer Layers;
  };

  const Buffer& Get(PlaneKind kind, int light) const;
  bool Upload(Buffer& buffer, const void* data, size_t count, size_t size);
  bool UploadLayers(Buffer& buffer, const std::vector<CasterOpticalThickness>& layers);
  bool MakeCorners();

  unsigned int VertexArray = 0;
  Buffer Corners; // of how many planes
  Buffer TruncationPlanes;
  std::vector<LightBuffers> Lights;
  std::string Error;
};
}

#endif
