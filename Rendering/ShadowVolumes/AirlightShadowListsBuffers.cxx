// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The buffers that a light's shadow planes are drawn from.

#include "ShadowVolumes/AirlightShadowLists.h"

#include "OpenGL/AirlightOpenGL.h"

#include <algorithm>

namespace airlight
{
//------------------------------------------------------------------------------
bool ShadowLists::Upload(Buffer& buffer, const void* data, size_t count, size_t size)
{
  if (buffer.Handle == 0)
  {
    glGenBuffers(1, &buffer.Handle);
  }
  buffer.Count = static_cast<int>(count);
  const auto bytes = static_cast<GLsizeiptr>(std::max<size_t>(count, 1) * size);
  if (!AllocateStorage(buffer.Handle, bytes, count > 0 ? data : nullptr, GL_STATIC_DRAW))
  {
    buffer.Count = 0;
    this->Error = "no memory on the graphics card for " + std::to_string(count) +
      " silhouette edges: use coarser meshes, or call SetShadowTechniqueToShadowMap()";
    return false;
  }
  return true;
}

//------------------------------------------------------------------------------
// The corners of the two triangles of each plane, (A, A far, B) and (B, A far, B far), among four
// vertices a plane. Of as many planes as a draw takes, for all lights.
bool ShadowLists::MakeCorners()
{
  if (this->Corners.Count > 0)
  {
    return true;
  }
  std::vector<GLushort> corners;
  corners.reserve(6 * PlanesPerDraw);
  for (int plane = 0; plane < PlanesPerDraw; ++plane)
  {
    for (const int corner : { 0, 1, 2, 2, 1, 3 })
    {
      corners.push_back(static_cast<GLushort>(4 * plane + corner));
    }
  }
  return this->Upload(this->Corners, corners.data(), PlanesPerDraw, 6 * sizeof(GLushort));
}

//------------------------------------------------------------------------------
// They change with the view, and are few.
bool ShadowLists::UploadTruncationPlanes(const Source& source)
{
  return this->Upload(this->TruncationPlanes, source.TruncationPlanes.data(),
    source.TruncationPlanes.size(), sizeof(source.TruncationPlanes[0]));
}

//------------------------------------------------------------------------------
bool ShadowLists::UploadLayers(Buffer& buffer, const std::vector<CasterOpticalThickness>& layers)
{
  std::vector<glm::ivec4> values;
  for (const CasterOpticalThickness& layer : layers)
  {
    const int channels = layer.Blocks.r + 2 * layer.Blocks.g + 4 * layer.Blocks.b;
    values.emplace_back(layer.Thickness, channels);
  }
  return this->Upload(buffer, values.data(), values.size(), sizeof(glm::ivec4));
}

//------------------------------------------------------------------------------
bool ShadowLists::SetVolumes(int light, const ShadowVolumes& volumes)
{
  if (static_cast<size_t>(light) >= this->Edges.size())
  {
    this->Edges.resize(light + 1);
    this->NearEdges.resize(light + 1);
    this->Caps.resize(light + 1);
    this->Layers.resize(light + 1);
  }
  const auto upload = [this](Buffer& buffer, const auto& records) {
    return this->Upload(buffer, records.data(), records.size(), sizeof(records[0]));
  };
  return this->MakeCorners() && upload(this->Edges[light], volumes.GetEdges()) &&
    upload(this->NearEdges[light], volumes.GetNearEdges()) &&
    upload(this->Caps[light], volumes.GetCaps()) &&
    this->UploadLayers(this->Layers[light], volumes.GetLayers());
}

//------------------------------------------------------------------------------
void ShadowLists::Release()
{
  DeleteVertexArray(this->VertexArray);
  this->Store.Release();
  const auto release = [](Buffer& buffer) {
    DeleteBuffer(buffer.Handle);
    buffer.Count = 0;
  };
  release(this->Corners);
  release(this->TruncationPlanes);
  for (auto* buffers : { &this->Edges, &this->NearEdges, &this->Caps, &this->Layers })
  {
    std::for_each(buffers->begin(), buffers->end(), release);
    buffers->clear();
  }
  this->SortQuad.Release();
  this->OverflowQuad.Release();
}
}
