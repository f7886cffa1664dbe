// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Textures on the CPU against values by hand, for each kind of image, wrapping and interpolation.

#include "AirlightTestCheck.h"
#include "AirlightTestTools.h"
#include "Scene/AirlightTextureColours.h"

#include "vtkActor.h"
#include "vtkImageData.h"
#include "vtkLookupTable.h"
#include "vtkNew.h"
#include "vtkProperty.h"
#include "vtkTexture.h"
#include "vtkTransform.h"

#include <cmath>
#include <cstdlib>
#include <limits>
#include <vector>

using airlight::TextureColours;
using namespace airlight_test;

namespace
{
vtkSmartPointer<vtkTexture> MakeTexture(
  int type, int width, int height, int components, const std::vector<double>& values)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(width, height, 1);
  image->AllocateScalars(type, components);
  for (size_t i = 0; i < values.size(); ++i)
  {
    const int texel = static_cast<int>(i) / components;
    image->SetScalarComponentFromDouble(
      texel % width, texel / width, 0, static_cast<int>(i) % components, values[i]);
  }
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(image);
  return texture;
}

void CheckColour(vtkTexture* texture, const glm::dvec2& at, const glm::dvec4& expected,
  double error, const std::string& name)
{
  const glm::dvec4 colour = TextureColours(texture).Get(at);
  Check(glm::length(colour - expected) <= error,
    Text(name, ": ", colour.x, " ", colour.y, " ", colour.z, " ", colour.w));
}

// ---- What kinds of images mean --------------------------------------------------------------
void TestKinds()
{
  const glm::dvec2 middle(0.5);
  CheckColour(MakeTexture(VTK_UNSIGNED_CHAR, 1, 1, 1, { 51 }), middle, { 0.2, 0.2, 0.2, 1.0 },
    1e-12, "luminance");
  CheckColour(MakeTexture(VTK_UNSIGNED_CHAR, 1, 1, 2, { 51, 102 }), middle, { 0.2, 0.2, 0.2, 0.4 },
    1e-12, "luminance and alpha");
  CheckColour(MakeTexture(VTK_UNSIGNED_CHAR, 1, 1, 3, { 51, 102, 255 }), middle,
    { 0.2, 0.4, 1.0, 1.0 }, 1e-12, "RGB");
  CheckColour(MakeTexture(VTK_UNSIGNED_CHAR, 1, 1, 4, { 51, 102, 255, 153 }), middle,
    { 0.2, 0.4, 1.0, 0.6 }, 1e-12, "RGBA");
  const vtkSmartPointer<vtkTexture> direct = MakeTexture(VTK_FLOAT, 1, 1, 4, { 2, 0, 0.5, 0.25 });
  direct->SetColorModeToDirectScalars();
  CheckColour(direct, middle, { 2.0, 0.0, 0.5, 0.25 }, 1e-12, "direct");
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(2);
  table->SetTableValue(0, 1.0, 0.0, 0.0, 0.2);
  table->SetTableValue(1, 0.0, 1.0, 0.0, 0.8);
  table->SetRange(0.0, 1.0);
  const vtkSmartPointer<vtkTexture> mapped = MakeTexture(VTK_FLOAT, 2, 1, 1, { 0.1, 0.9 });
  mapped->SetLookupTable(table);
  CheckColour(mapped, { 0.25, 0.5 }, { 1.0, 0.0, 0.0, 0.2 }, 1e-12, "mapped, first");
  CheckColour(mapped, { 0.75, 0.5 }, { 0.0, 1.0, 0.0, 0.8 }, 1e-12, "mapped, second");
}

// ---- Between and beside texels --------------------------------------------------------------
void TestReading()
{
  const vtkSmartPointer<vtkTexture> texture =
    MakeTexture(VTK_UNSIGNED_CHAR, 2, 2, 1, { 0, 255, 51, 102 });
  const auto check = [&](const glm::dvec2& at, double expected, const std::string& name) {
    const double value = TextureColours(texture).Get(at).x;
    Check(std::abs(value - expected) < 1e-12, Text(name, ": ", value, " and not ", expected));
  };
  texture->InterpolateOff();
  check({ 0.1, 0.1 }, 0.0, "lower left");
  check({ 0.9, 0.1 }, 1.0, "lower right");
  check({ 0.1, 0.9 }, 0.2, "upper left");
  texture->InterpolateOn();
  check({ 0.5, 0.25 }, 0.5, "between two");
  check({ 0.5, 0.5 }, 0.4, "between four");
  check({ 0.375, 0.25 }, 0.25, "a quarter of the way");
  texture->SetWrap(vtkTexture::ClampToEdge);
  check({ -3.0, 0.25 }, 0.0, "clamped");
  texture->SetWrap(vtkTexture::Repeat);
  check({ 0.0, 0.25 }, 0.5, "repeated, at the seam");
  check({ -7.25, 0.25 }, 1.0, "repeated");
  texture->SetWrap(vtkTexture::MirroredRepeat);
  check({ 0.0, 0.25 }, 0.0, "mirrored, at the seam");
  check({ 1.25, 0.25 }, 1.0, "mirrored");
  check({ -0.25, 0.25 }, 0.0, "mirrored below 0");
  texture->SetWrap(vtkTexture::ClampToBorder);
  texture->SetBorderColor(0.6f, 0.0f, 0.0f, 0.0f);
  const double border = TextureColours(texture).Get({ 5.0, 0.5 }).x;
  Check(std::abs(border - 0.6) < 1e-6, Text("border: ", border));
  texture->SetWrap(vtkTexture::ClampToEdge);
  vtkNew<vtkTransform> transform;
  transform->Translate(0.5, 0.0, 0.0);
  texture->SetTransform(transform);
  check({ 0.25, 0.25 }, 1.0, "moved");
  texture->SetTransform(nullptr);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  check({ nan, 0.25 }, 0.0, "not a number is 0");
  check({ -std::numeric_limits<double>::infinity(), 0.25 }, 0.0, "minus infinity");
}

// ---- Alpha, and what is no picture ----------------------------------------------------------
void TestPresence()
{
  Check(!TextureColours(MakeTexture(VTK_UNSIGNED_CHAR, 1, 1, 3, { 1, 2, 3 })).HasAlpha(), "RGB");
  Check(!TextureColours(MakeTexture(VTK_UNSIGNED_CHAR, 1, 1, 4, { 1, 2, 3, 255 })).HasAlpha(),
    "opaque RGBA");
  Check(TextureColours(MakeTexture(VTK_UNSIGNED_CHAR, 1, 1, 4, { 1, 2, 3, 254 })).HasAlpha(),
    "translucent RGBA");
  Check(TextureColours(nullptr).IsEmpty() && !TextureColours(nullptr).HasAlpha(), "no texture");
  Check(TextureColours(vtkNew<vtkTexture>()).IsEmpty(), "no image");
  const vtkSmartPointer<vtkTexture> cube = MakeTexture(VTK_UNSIGNED_CHAR, 1, 1, 3, { 1, 2, 3 });
  cube->CubeMapOn();
  Check(TextureColours(cube).IsEmpty(), "cube map");
  vtkNew<vtkImageData> block;
  block->SetDimensions(2, 2, 2);
  block->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  vtkNew<vtkTexture> volume;
  volume->SetInputData(block);
  Check(TextureColours(volume).IsEmpty(), "three dimensions");

  vtkNew<vtkActor> actor;
  Check(airlight::GetColourTexture(actor) == nullptr, "an actor without");
  volume->UseSRGBColorSpaceOn();
  actor->GetProperty()->SetTexture("albedoTex", volume);
  Check(airlight::GetColourTexture(actor) == volume, "a material's base colour");
  actor->SetTexture(cube);
  Check(airlight::GetColourTexture(actor) == cube, "the actor's own");
}
}

//------------------------------------------------------------------------------
int TestTextureColours(int, char*[])
{
  TestKinds();
  TestReading();
  TestPresence();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
