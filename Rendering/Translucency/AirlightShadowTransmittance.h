// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What translucent casters leave of each light on the opaque surface of each pixel, as the shaders
 * keep it (glsl/AirlightTransmittanceBuffer.glsl): each light's resolve writes it, the mappers'
 * fragments read it.
 *
 * Memory: 8 bytes a pixel and light.
 */

#ifndef AirlightShadowTransmittance_h
#define AirlightShadowTransmittance_h

#include <string>
#include <vector>

class vtkShaderProgram;

namespace airlight
{
class ShadowTransmittance
{
public:
  // Room for this viewport and these lights: the place of light k, -1 for one that is not dimmed.
  // False with a reason in GetError() if OpenGL refuses the buffer.
  bool Prepare(int width, int height, const std::vector<int>& slots);
  const std::string& GetError() const { return this->Error; }

  int GetSlot(int light) const { return this->Slots[light]; }
  int GetSlotCount() const { return this->SlotCount; }

  // For a program with the source AirlightTransmittanceBuffer: binds the buffer and sets its size.
  void Use(vtkShaderProgram* program) const;
  // The same for a mapper's program, with the lights' places; for one without that source nothing.
  void UseInMapper(vtkShaderProgram* program) const;

  void Release();

private:
  unsigned int Handle = 0;
  int Width = 0;
  int Height = 0;
  int SlotCount = 0;
  long long Bytes = 0;
  std::vector<int> Slots;
  std::string Error;
};
}

#endif
