// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What is drawn over the medium, translucent surfaces, as the shaders keep it: a list of records
 * for each pixel (glsl/AirlightTranslucentLists.glsl). A surface's fragments make them, they are
 * sorted by distance, each light's resolve adds what it scatters before each of them, with its
 * shadows, and the fragments look theirs up when they are drawn.
 *
 * Memory: 40 bytes a translucent fragment, where casters let light through 44 and 8 for each light
 * that they dim, and 8 a pixel. Pixels are in tiles, since few of a picture have any.
 */

#ifndef AirlightTranslucentFragments_h
#define AirlightTranslucentFragments_h

#include "OpenGL/AirlightPixelArea.h"
#include "OpenGL/AirlightQuad.h"

#include <cstdint>
#include <string>

class vtkOpenGLRenderWindow;
class vtkShaderProgram;

namespace airlight
{
// Words of a record.
namespace translucent_record
{
using uint = std::uint32_t;
#include "Translucency/glsl/AirlightTranslucentRecord.glsl"
constexpr uint SortedWords = 2; // of a record in the order of distances
constexpr uint LightBits = 32 * (AIRLIGHT_TRANSLUCENT_PLAIN_WORDS - AIRLIGHT_TRANSLUCENT_LIT);
}

class TranslucentFragments
{
public:
  // Bytes, where no caster lets light through, its place in the order included.
  static constexpr std::uint32_t RecordSize = sizeof(std::uint32_t) *
    (translucent_record::AIRLIGHT_TRANSLUCENT_PLAIN_WORDS + translucent_record::SortedWords);

  // What shaders that have records begin with, after DefineStorageBindings().
  static std::string GetSource();

  // Empty lists for this viewport. `transmitsShadows`: whether casters let light through; and the
  // number of lights that they dim. False with a reason in GetError() if OpenGL refuses a buffer.
  bool Prepare(int width, int height, bool transmitsShadows, int dimmedLights);
  const std::string& GetError() const { return this->Error; }

  // For a program with that source: binds the lists and sets its uniforms.
  void Use(vtkShaderProgram* program) const;

  // After a draw that made records: whether there was room for all of them. If not, there is now,
  // and the draw has to be done again.
  enum class Outcome
  {
    Done,
    Again,
    TooMany, // for a buffer of the graphics card; then and
    Failed   // with a reason in GetError()
  };
  Outcome Check();

  // After that: where there are records.
  const PixelAreas& GetAreas() const { return this->Areas; }

  // Then, before the resolves: puts each pixel's records in order, over a framebuffer of the
  // viewport's size. False with a reason in GetError() where the shader does not compile.
  bool Sort(vtkOpenGLRenderWindow* window);

  void Release();

private:
  std::uint32_t GetRecordBytes() const;
  bool Reserve(std::uint32_t records);
  void Clear();
  size_t GetTileCount() const;
  void ReadTiles();

  Quad SortQuad;
  PixelAreas Areas;
  bool TransmitsShadows = false;
  unsigned int Records = 0;
  unsigned int Heads = 0;
  int Width = 0;
  int Height = 0;
  int Words = translucent_record::AIRLIGHT_TRANSLUCENT_PLAIN_WORDS;
  std::uint32_t Capacity = 0; // the unused one at index 0 included
  std::string Error;
};
}

#endif
