// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Medium/AirlightEnvironment.h"

#include "Integration/AirlightMath.h"

#include "vtkAlgorithm.h"
#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkTexture.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace airlight
{
namespace
{
constexpr double Pi = vtkMath::Pi();

// What components of texels are multiplied by: integers are parts of their largest value, as in
// OpenGL.
double GetScale(vtkDataArray* texels)
{
  const int type = texels->GetDataType();
  return type == VTK_FLOAT || type == VTK_DOUBLE ? 1.0 : 1.0 / texels->GetDataTypeMax();
}

double DecodeSRGB(double value)
{
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

class Texels
{
public:
  Texels(vtkDataArray* values, bool decode)
    : Values(values)
    , Scale(GetScale(values))
    , Grey(values->GetNumberOfComponents() < 3)
  {
    for (int i = 0; decode && i < 256; ++i)
    {
      this->Decoded.push_back(DecodeSRGB(i / 255.0));
    }
  }

  glm::dvec3 Get(vtkIdType i) const
  {
    glm::dvec3 rgb;
    for (int c = 0; c < 3; ++c)
    {
      const double value = this->Values->GetComponent(i, this->Grey ? 0 : c);
      const double radiance =
        this->Decoded.empty() ? this->Scale * value : this->Decoded[static_cast<int>(value)];
      // Neither numbers that are not finite nor what filters made negative shines.
      rgb[c] = std::isfinite(radiance) ? std::max(radiance, 0.0) : 0.0;
    }
    return rgb;
  }

private:
  vtkDataArray* Values;
  double Scale;
  bool Grey;
  std::vector<double> Decoded; // bytes; empty: linear
};

// The integrals of a row of texels times 1, cos, sin, cos 2 and sin 2 of the azimuth.
std::array<glm::dvec3, 5> IntegrateRow(const Texels& texels, vtkIdType first, int width,
  const std::vector<std::array<double, 5>>& columns)
{
  std::array<glm::dvec3, 5> sums{};
  for (int j = 0; j < width; ++j)
  {
    const glm::dvec3 radiance = texels.Get(first + j);
    for (int k = 0; k < 5; ++k)
    {
      sums[k] += columns[j][k] * radiance;
    }
  }
  return sums;
}

// The same of texels of radiance 1.
std::vector<std::array<double, 5>> GetColumns(int width)
{
  std::vector<std::array<double, 5>> columns;
  const double step = 2.0 * Pi / width;
  const double once = 2.0 * std::sin(0.5 * step);
  const double twice = std::sin(step);
  for (int j = 0; j < width; ++j)
  {
    const double azimuth = (j + 0.5) * step - Pi;
    columns.push_back({ step, once * std::cos(azimuth), once * std::sin(azimuth),
      twice * std::cos(2.0 * azimuth), twice * std::sin(2.0 * azimuth) });
  }
  return columns;
}

// Adds a row of latitudes from `bottom` to `top`.
void AddRow(
  const std::array<glm::dvec3, 5>& row, double bottom, double top, SkyHarmonics& harmonics)
{
  for (int k = 0; k < 16; ++k)
  {
    const glm::dvec2 node = f64::airlightGaussNode(k / 2);
    const double half = 0.5 * (top - bottom);
    const double latitude = bottom + half * (k % 2 == 0 ? 1.0 + node.x : 1.0 - node.x);
    const double y = std::sin(latitude);
    const double c = std::cos(latitude);
    const double weight = half * node.y * c;
    // x = c cos, z = c sin of the azimuth; 2 z^2 = c^2 (1 - cos 2), 2 x z = c^2 sin 2.
    const glm::dvec3 zz = 0.5 * c * c * (row[0] - row[3]);
    const glm::dvec3 xx = 0.5 * c * c * (row[0] + row[3]);
    const glm::dvec3 polynomials[9] = { row[0], y * row[0], c * row[2], c * row[1], c * y * row[1],
      c * y * row[2], 3.0 * zz - row[0], 0.5 * c * c * row[4], xx - y * y * row[0] };
    for (int i = 0; i < 9; ++i)
    {
      harmonics[i] += weight * HarmonicNorms[i] * polynomials[i];
    }
  }
}

// Harmonics of a picture in the axes right, up and right x up, in the world's. Evaluated and
// projected again by a rule that is exact for products of two of them.
SkyHarmonics Rotate(const SkyHarmonics& own, const glm::dmat3& axes)
{
  SkyHarmonics result{};
  const double node = std::sqrt(0.6);
  constexpr int azimuths = 6;
  for (const glm::dvec2& height :
    { glm::dvec2(-node, 5.0 / 9.0), glm::dvec2(0.0, 8.0 / 9.0), glm::dvec2(node, 5.0 / 9.0) })
  {
    for (int j = 0; j < azimuths; ++j)
    {
      const double azimuth = 2.0 * Pi * j / azimuths;
      const double c = std::sqrt(1.0 - height.x * height.x);
      const glm::dvec3 w(c * std::cos(azimuth), height.x, c * std::sin(azimuth));
      const std::array<double, 9> there = GetHarmonics(w);
      const std::array<double, 9> here = GetHarmonics(axes * w);
      glm::dvec3 radiance(0.0);
      for (int i = 0; i < 9; ++i)
      {
        radiance += there[i] * own[i];
      }
      for (int i = 0; i < 9; ++i)
      {
        result[i] += 2.0 * Pi / azimuths * height.y * here[i] * radiance;
      }
    }
  }
  return result;
}

// Unit axes; false where the vectors give none.
bool MakeAxes(const glm::dvec3& up, const glm::dvec3& right, glm::dmat3& axes)
{
  const glm::dvec3 y = up / glm::length(up);
  const glm::dvec3 across = right - glm::dot(right, y) * y;
  const glm::dvec3 x = across / glm::length(across);
  axes = glm::dmat3(x, y, glm::cross(x, y));
  const double least = 1e-9 * glm::length(right);
  return glm::length(across) > least && std::isfinite(glm::dot(x + y, x + y));
}

std::string DescribeAxis(const char* name, const glm::dvec3& axis)
{
  return std::string(name) + " (" + std::to_string(axis.x) + ", " + std::to_string(axis.y) + ", " +
    std::to_string(axis.z) + ")";
}
}

//------------------------------------------------------------------------------
bool Environment::Read(vtkTexture* texture, std::string& error)
{
  vtkAlgorithm* source = texture ? texture->GetInputAlgorithm() : nullptr;
  if (!source)
  {
    error = "there is no environment texture with an image: call "
            "vtkRenderer::SetEnvironmentTexture()";
    return false;
  }
  if (texture->GetCubeMap())
  {
    error = "the environment texture is a cube map, of which no harmonics are computed: give an "
            "equirectangular image, and call CubeMapOff() of the texture";
    return false;
  }
  source->Update();
  vtkImageData* image = texture->GetInput();
  vtkDataArray* values = image ? image->GetPointData()->GetScalars() : nullptr;
  if (!values || values->GetNumberOfTuples() == 0 || image->GetDimensions()[2] != 1)
  {
    error = "the environment texture's image has no texels, or more than two dimensions";
    return false;
  }
  const bool decode = texture->GetUseSRGBColorSpace() && values->GetDataType() == VTK_UNSIGNED_CHAR;
  if (this->Image == image && this->ImageTime == image->GetMTime() && this->Decoded == decode)
  {
    return true;
  }
  this->Image = image;
  this->ImageTime = image->GetMTime();
  this->Decoded = decode;
  this->Own = {};
  const Texels texels(values, decode);
  const int width = image->GetDimensions()[0];
  const int height = image->GetDimensions()[1];
  const std::vector<std::array<double, 5>> columns = GetColumns(width);
  for (int i = 0; i < height; ++i)
  {
    AddRow(IntegrateRow(texels, static_cast<vtkIdType>(i) * width, width, columns),
      Pi * (i / static_cast<double>(height) - 0.5), Pi * ((i + 1.0) / height - 0.5), this->Own);
  }
  return true;
}

//------------------------------------------------------------------------------
bool Environment::Update(
  vtkTexture* texture, const glm::dvec3& up, const glm::dvec3& right, std::string& error)
{
  this->Harmonics = {};
  if (!this->Read(texture, error))
  {
    return false;
  }
  glm::dmat3 axes;
  if (!MakeAxes(up, right, axes))
  {
    error = "the environment's axes " + DescribeAxis("up", up) + " and " +
      DescribeAxis("right", right) + " must be finite, not 0 and not parallel";
    return false;
  }
  this->Harmonics = Rotate(this->Own, axes);
  return true;
}
}
