// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "ShadowVolumes/AirlightShadowPlaneBuffers.h"

#include "OpenGL/AirlightOpenGL.h"
#include "OpenGL/AirlightStorageBinding.h"

#include <algorithm>

namespace airlight
{
//------------------------------------------------------------------------------
const ShadowPlaneBuffers::Buffer& ShadowPlaneBuffers::Get(PlaneKind kind, int light) const
{
  const LightBuffers& buffers = this->Lights[light];
  return kind == PlaneKind::Plane ? buffers.Edges
    : kind == PlaneKind::Cap      ? buffers.Caps
                                  : buffers.NearEdges;
}

//------------------------------------------------------------------------------
bool ShadowPlaneBuffers::Upload(Buffer& buffer, const void* data, size_t count, size_t size)
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
bool ShadowPlaneBuffers::MakeCorners()
{
  if (this->Corners.Count > 0)
  {
    return true;
  }
  if (this->VertexArray == 0)
  {
    glGenVertexArrays(1, &this->VertexArray);
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
bool ShadowPlaneBuffers::UploadLayers(
  Buffer& buffer, const std::vector<CasterOpticalThickness>& layers)
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
bool ShadowPlaneBuffers::SetTruncationPlanes(const std::vector<glm::vec4>& planes)
{
  return this->Upload(this->TruncationPlanes, planes.data(), planes.size(), sizeof(planes[0]));
}

//------------------------------------------------------------------------------
bool ShadowPlaneBuffers::SetVolumes(int light, const ShadowVolumes& volumes)
{
  if (static_cast<size_t>(light) >= this->Lights.size())
  {
    this->Lights.resize(light + 1);
  }
  const auto upload = [this](Buffer& buffer, const auto& records) {
    return this->Upload(buffer, records.data(), records.size(), sizeof(records[0]));
  };
  LightBuffers& buffers = this->Lights[light];
  return this->MakeCorners() && upload(buffers.Edges, volumes.GetEdges()) &&
    upload(buffers.NearEdges, volumes.GetNearEdges()) && upload(buffers.Caps, volumes.GetCaps()) &&
    this->UploadLayers(buffers.Layers, volumes.GetLayers());
}

//------------------------------------------------------------------------------
// By indices, a plane takes four vertices instead of six, and software renderers take few planes at
// a time: after every fifty vertices that they have clipped they go through all that they took.
void ShadowPlaneBuffers::Draw(PlaneKind kind, int light) const
{
  BindStorage(StorageBinding::CasterThickness, this->Lights[light].Layers.Handle);
  BindStorage(StorageBinding::TruncationPlanes, this->TruncationPlanes.Handle);
  const Buffer& buffer = this->Get(kind, light);
  const bool planes = kind == PlaneKind::Plane;
  const size_t size = kind == PlaneKind::Near ? sizeof(NearEdge)
    : planes                                  ? sizeof(ShadowEdge)
                                              : sizeof(ShadowCap);
  const int most = planes ? PlanesPerDraw : RecordsPerDraw;
  glBindVertexArray(this->VertexArray);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, this->Corners.Handle);
  for (int first = 0; first < buffer.Count; first += most)
  {
    const int count = std::min(buffer.Count - first, most);
    BindStorage(StorageBinding::SilhouetteEdges, buffer.Handle, static_cast<GLintptr>(first * size),
      static_cast<GLsizeiptr>(count * size));
    if (planes)
    {
      glDrawElements(GL_TRIANGLES, 6 * count, GL_UNSIGNED_SHORT, nullptr);
    }
    else
    {
      glDrawArrays(GL_TRIANGLES, 0, 3 * count);
    }
  }
  glBindVertexArray(0);
}

//------------------------------------------------------------------------------
void ShadowPlaneBuffers::Release()
{
  DeleteVertexArray(this->VertexArray);
  const auto release = [](Buffer& buffer) {
    DeleteBuffer(buffer.Handle);
    buffer.Count = 0;
  };
  release(this->Corners);
  release(this->TruncationPlanes);
  for (LightBuffers& light : this->Lights)
  {
    for (auto* buffer : { &light.Edges, &light.NearEdges, &light.Caps, &light.Layers })
    {
      release(*buffer);
    }
  }
  this->Lights.clear();
}
}
