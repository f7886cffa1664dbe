// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightTextureColours.h"

#include "Integration/AirlightMatrix.h"
#include "vtkActor.h"
#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMatrix4x4.h"
#include "vtkPointData.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkTransform.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
// A texel's number in a row of so many; -1 outside of a bordered row.
int WrapTexel(int texel, int count, int wrap)
{
  switch (wrap)
  {
    case vtkTexture::Repeat:
      return (texel % count + count) % count;
    case vtkTexture::MirroredRepeat:
    {
      const int twice = (texel % (2 * count) + 2 * count) % (2 * count);
      return twice < count ? twice : 2 * count - 1 - twice;
    }
    case vtkTexture::ClampToBorder:
      return texel >= 0 && texel < count ? texel : -1;
    default:
      return std::clamp(texel, 0, count - 1);
  }
}

// Width and height of an image one of whose sides is a single sample; 0 of others.
glm::ivec2 GetImageSize(vtkImageData* image)
{
  int n[3];
  image->GetDimensions(n);
  return n[2] == 1 ? glm::ivec2(n[0], n[1])
    : n[1] == 1    ? glm::ivec2(n[0], n[2])
    : n[0] == 1    ? glm::ivec2(n[1], n[2])
                   : glm::ivec2(0);
}

// Whether the samples are colours, and not values for a table of colours.
bool AreColours(vtkTexture* texture, vtkDataArray* scalars)
{
  const int mode = texture->GetColorMode();
  return mode == VTK_COLOR_MODE_DIRECT_SCALARS ||
    (mode == VTK_COLOR_MODE_DEFAULT && scalars->GetDataType() == VTK_UNSIGNED_CHAR);
}

vtkSmartPointer<vtkDataArray> MapColours(vtkTexture* texture, vtkDataArray* scalars)
{
  const vtkIdType count = scalars->GetNumberOfTuples();
  const unsigned char* rgba = texture->MapScalarsToColors(scalars);
  auto colours = vtkSmartPointer<vtkUnsignedCharArray>::New();
  colours->SetNumberOfComponents(4);
  colours->SetNumberOfTuples(count);
  colours->FillValue(255);
  if (rgba)
  {
    std::copy(rgba, rgba + 4 * count, colours->GetPointer(0));
  }
  return colours;
}

// What a component's value of 1 is.
double GetUnit(vtkDataArray* scalars)
{
  const int type = scalars->GetDataType();
  return type == VTK_FLOAT || type == VTK_DOUBLE ? 1.0 : scalars->GetDataTypeMax();
}
}

//------------------------------------------------------------------------------
vtkTexture* GetColourTexture(vtkActor* actor)
{
  vtkTexture* texture = actor->GetTexture();
  return texture ? texture : actor->GetProperty()->GetTexture("albedoTex");
}

//------------------------------------------------------------------------------
TextureColours::TextureColours(vtkTexture* texture)
{
  if (!texture || texture->GetCubeMap() || !texture->GetInputAlgorithm())
  {
    return;
  }
  texture->GetInputAlgorithm()->Update();
  vtkImageData* image = texture->GetInput();
  vtkDataArray* scalars = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!scalars)
  {
    return;
  }
  this->Size = GetImageSize(image);
  if (this->Size.x < 1 || this->Size.y < 1 ||
    scalars->GetNumberOfTuples() < static_cast<vtkIdType>(this->Size.x) * this->Size.y)
  {
    return;
  }
  this->Wrap = texture->GetWrap();
  this->Interpolate = texture->GetInterpolate() != 0;
  const float* border = texture->GetBorderColor();
  this->Border = glm::dvec4(border[0], border[1], border[2], border[3]);
  if (vtkTransform* transform = texture->GetTransform())
  {
    this->Transform = ToGlm(transform->GetMatrix());
  }
  this->Colours = scalars;
  if (!AreColours(texture, scalars))
  {
    this->Colours = MapColours(texture, scalars);
  }
  this->Unit = GetUnit(this->Colours);
}

//------------------------------------------------------------------------------
bool TextureColours::IsEmpty() const { return !this->Colours; }

//------------------------------------------------------------------------------
bool TextureColours::HasAlpha() const
{
  const int components = this->Colours ? this->Colours->GetNumberOfComponents() : 0;
  if (components != 2 && components < 4)
  {
    return false;
  }
  double range[2];
  this->Colours->GetRange(range, components == 2 ? 1 : 3);
  return range[0] < this->Unit;
}

//------------------------------------------------------------------------------
glm::dvec4 TextureColours::GetTexel(const glm::ivec2& texel) const
{
  const int x = WrapTexel(texel.x, this->Size.x, this->Wrap);
  const int y = WrapTexel(texel.y, this->Size.y, this->Wrap);
  if (x < 0 || y < 0)
  {
    return this->Border;
  }
  const vtkIdType number = static_cast<vtkIdType>(y) * this->Size.x + x;
  const int components = std::min(this->Colours->GetNumberOfComponents(), 4);
  glm::dvec4 colour(this->Unit);
  for (int c = 0; c < components; ++c)
  {
    colour[components == 2 && c == 1 ? 3 : c] = this->Colours->GetComponent(number, c);
  }
  colour = components < 3 ? glm::dvec4(glm::dvec3(colour.x), colour.w) : colour;
  return colour / this->Unit;
}

//------------------------------------------------------------------------------
glm::dvec4 TextureColours::Get(const glm::dvec2& coordinates) const
{
  const glm::dvec2 st(this->Transform * glm::dvec4(coordinates, 0.0, 1.0));
  // Beyond that, texels have no numbers; NaN is the origin.
  const glm::dvec2 limited =
    glm::clamp(glm::dvec2(std::isnan(st.x) ? 0.0 : st.x, std::isnan(st.y) ? 0.0 : st.y), -1e4, 1e4);
  const glm::dvec2 at = limited * glm::dvec2(this->Size);
  if (!this->Interpolate)
  {
    return this->GetTexel(glm::ivec2(glm::floor(at)));
  }
  const glm::ivec2 first(glm::floor(at - 0.5));
  const glm::dvec2 share = at - 0.5 - glm::dvec2(first);
  const glm::dvec4 low =
    glm::mix(this->GetTexel(first), this->GetTexel(first + glm::ivec2(1, 0)), share.x);
  const glm::dvec4 high = glm::mix(
    this->GetTexel(first + glm::ivec2(0, 1)), this->GetTexel(first + glm::ivec2(1, 1)), share.x);
  return glm::mix(low, high, share.y);
}
}
