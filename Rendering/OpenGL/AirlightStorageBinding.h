// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The binding points of the shaders' storage buffers: the only place that numbers them. Each point
 * has one meaning in the whole module. Shaders use the names of DefineStorageBindings().
 */

#ifndef AirlightStorageBinding_h
#define AirlightStorageBinding_h

#include "OpenGL/AirlightOpenGL.h"

#include <string>

namespace airlight
{
enum class StorageBinding : GLuint
{
  SilhouetteEdges,
  Boundaries,
  ListHeads,
  TranslucentFragments,
  TranslucentHeads,
  ShadowTransmittance,
  CasterThickness,
  KBuffer,
  TruncationPlanes,
  FroxelNodes,
  Count
};

// A line `#define AIRLIGHT_BINDING_...` for each binding point, to follow a shader's version.
const std::string& DefineStorageBindings();

// Whether the context has as many binding points. OpenGL 4.3 guarantees eight, drivers have more.
bool HasStorageBindings();

// Binds a buffer, or some bytes of it.
void BindStorage(StorageBinding binding, GLuint buffer);
void BindStorage(StorageBinding binding, GLuint buffer, GLintptr offset, GLsizeiptr bytes);

// Frees all binding points when it goes out of scope: VTK does not track them.
class ScopedStorageBindings
{
public:
  // `supported`: the context has storage buffers.
  explicit ScopedStorageBindings(bool supported)
    : Supported(supported)
  {
  }
  ScopedStorageBindings(const ScopedStorageBindings&) = delete;
  void operator=(const ScopedStorageBindings&) = delete;
  ~ScopedStorageBindings();

private:
  bool Supported;
};
}

#endif
