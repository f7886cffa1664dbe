// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Translucency/AirlightShadowTransmittance.h"

#include "OpenGL/AirlightStorageBinding.h"

#include "vtkShaderProgram.h"

#include <algorithm>

namespace airlight
{
namespace
{
constexpr long long PixelSize = 8;
}

//------------------------------------------------------------------------------
bool ShadowTransmittance::Prepare(int width, int height, const std::vector<int>& slots)
{
  this->Width = width;
  this->Height = height;
  this->Slots = slots;
  this->SlotCount =
    slots.empty() ? 0 : std::max(0, *std::max_element(slots.begin(), slots.end()) + 1);
  const long long bytes = PixelSize * width * height * this->SlotCount;
  if (bytes <= this->Bytes)
  {
    return true;
  }
  if (this->Handle == 0)
  {
    glGenBuffers(1, &this->Handle);
  }
  const bool ok =
    AllocateStorageBlock(this->Handle, static_cast<GLsizeiptr>(bytes), nullptr, GL_DYNAMIC_COPY);
  this->Bytes = ok ? bytes : 0;
  this->Error = ok ? ""
                   : "no memory on the graphics card for the translucent shadows of " +
      std::to_string(this->SlotCount) +
      " lights on surfaces: call SetTranslucentShadows(false) or SetSurfaceShadows(false)";
  return ok;
}

//------------------------------------------------------------------------------
void ShadowTransmittance::Use(vtkShaderProgram* program) const
{
  const int size[2] = { this->Width, this->Height };
  program->SetUniform2i("airlightTransmittanceSize", size);
  BindStorage(StorageBinding::ShadowTransmittance, this->Handle);
}

//------------------------------------------------------------------------------
void ShadowTransmittance::UseInMapper(vtkShaderProgram* program) const
{
  if (program->IsUniformUsed("airlightTransmittanceSlots"))
  {
    this->Use(program);
    program->SetUniform1iv(
      "airlightTransmittanceSlots", static_cast<int>(this->Slots.size()), this->Slots.data());
  }
}

//------------------------------------------------------------------------------
void ShadowTransmittance::Release()
{
  DeleteBuffer(this->Handle);
  this->Bytes = 0;
}
}
