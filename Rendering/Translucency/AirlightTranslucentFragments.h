// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What is drawn over the medium, translucent surfaces, as the shaders keep it: a list of records
 * for each pixel (glsl/AirlightTranslucentLists.glsl). A surface's fragments make them, each
 * light's resolve adds what it scatters before each of them, with its shadows, and the fragments
 * look theirs up when they are drawn.
 *
 * Memory: 32 bytes a translucent fragment, where casters let light through 36 and 8 for each light
 * that they dim, and 4 a pixel.
 */

#ifndef AirlightTranslucentFragments_h
#define AirlightTranslucentFragments_h

#include <cstdint>
#include <string>

class vtkShaderProgram;

namespace airlight
{
class TranslucentFragments
{
public:
  static constexpr std::uint32_t RecordSize = 32; // bytes, where no caster lets light through

  // Empty lists for this viewport, with records of so many words (see
  // glsl/AirlightTranslucentLists.glsl). False with a reason in GetError() where a buffer cannot be
  // had.
  bool Prepare(int width, int height, int words);
  const std::string& GetError() const { return this->Error; }

  // For a program with the source AirlightTranslucentLists: binds the lists and sets its uniforms.
  void Use(vtkShaderProgram* program) const;

  // After a draw that made records: whether there was room for all of them. If not, there is now,
  // and the draw has to be done again.
  enum class Outcome
  {
    Done,
    Again,
    Failed // with a reason in GetError()
  };
  Outcome Check();

  void Release();

private:
  bool Reserve(std::uint32_t records);
  void Clear();

  unsigned int Records = 0;
  unsigned int Heads = 0;
  int Width = 0;
  int Height = 0;
  int Words = 8;
  std::uint32_t Capacity = 0; // the unused one at index 0 included
  std::string Error;
};
}

#endif
