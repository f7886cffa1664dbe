// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/AirlightStorageBinding.h"

namespace airlight
{
namespace
{
constexpr auto BindingCount = static_cast<GLuint>(StorageBinding::Count);

// In the order of StorageBinding.
constexpr const char* BindingNames[] = { "SILHOUETTE_EDGES", "BOUNDARIES", "LIST_HEADS",
  "TRANSLUCENT_FRAGMENTS", "TRANSLUCENT_HEADS", "SHADOW_TRANSMITTANCE", "CASTER_THICKNESS",
  "K_BUFFER", "TRUNCATION_PLANES", "FROXELS" };
static_assert(sizeof(BindingNames) / sizeof(*BindingNames) == BindingCount, "a name for each");

std::string MakeDefines()
{
  std::string text;
  for (GLuint k = 0; k < BindingCount; ++k)
  {
    text +=
      std::string("#define AIRLIGHT_BINDING_") + BindingNames[k] + " " + std::to_string(k) + "\n";
  }
  return text;
}
}

//------------------------------------------------------------------------------
const std::string& DefineStorageBindings()
{
  static const std::string text = MakeDefines();
  return text;
}

//------------------------------------------------------------------------------
bool HasStorageBindings()
{
  GLint count = 0;
  glGetIntegerv(GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, &count);
  return count >= static_cast<GLint>(BindingCount);
}

//------------------------------------------------------------------------------
void BindStorage(StorageBinding binding, GLuint buffer)
{
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(binding), buffer);
}

//------------------------------------------------------------------------------
void BindStorage(StorageBinding binding, GLuint buffer, GLintptr offset, GLsizeiptr bytes)
{
  glBindBufferRange(GL_SHADER_STORAGE_BUFFER, static_cast<GLuint>(binding), buffer, offset, bytes);
}

//------------------------------------------------------------------------------
ScopedStorageBindings::~ScopedStorageBindings()
{
  for (GLuint k = 0; this->Supported && k < BindingCount; ++k)
  {
    BindStorage(static_cast<StorageBinding>(k), 0);
  }
}
}
