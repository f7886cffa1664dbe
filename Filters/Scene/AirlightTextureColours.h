// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The colours of a vtkTexture on the CPU, as the graphics card reads them at full resolution.
 *
 * Not installed; exported for the module's own tests.
 */

#ifndef AirlightTextureColours_h
#define AirlightTextureColours_h

#include "vtkAirlightModule.h" // for export macro

#include "vtkSmartPointer.h"

#include <glm/glm.hpp>

class vtkActor;
class vtkDataArray;
class vtkTexture;

namespace airlight
{
// The texture that colours an actor: its own, or the base colour of a physically based material;
// null if there is none.
VTKAIRLIGHT_EXPORT vtkTexture* GetColourTexture(vtkActor* actor);

class VTKAIRLIGHT_EXPORT TextureColours
{
public:
  // Empty without a texture, for cube maps, and for images that are not two-dimensional or have
  // no scalars.
  explicit TextureColours(vtkTexture* texture);

  bool IsEmpty() const;

  // Whether any texel is less than opaque.
  bool HasAlpha() const;

  // Of the image in texels.
  glm::ivec2 GetSize() const { return this->Size; }

  // RGBA at texture coordinates, before the texture's own transform. Interpolated and wrapped as
  // the texture says.
  glm::dvec4 Get(const glm::dvec2& coordinates) const;

private:
  glm::dvec4 GetTexel(const glm::ivec2& texel) const;

  vtkSmartPointer<vtkDataArray> Colours; // luminance, with alpha, RGB, or with alpha
  double Unit = 1.0;                     // what a component of 1 is in it
  glm::ivec2 Size{ 0 };
  glm::dmat4 Transform{ 1.0 };
  glm::dvec4 Border{ 0.0 };
  int Wrap = 0;
  bool Interpolate = false;
};
}

#endif
