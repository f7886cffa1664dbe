// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Density from the samples of an image: trilinear between them, 0 outside the image.
 *
 * Only the box of samples in whose cells there is something is kept: a plume is a small part of the
 * room that was simulated. All but the bounds is of that box.
 *
 * The mathematics is the shaders' (Medium/AirlightGrid.glsl), here in double precision: the optical
 * depth of a way, summed cell by cell, is exact but for rounding.
 */

#ifndef AirlightDensityGrid_h
#define AirlightDensityGrid_h

#include "Density/AirlightDensitySamples.h"
#include "Density/AirlightFilledBlocks.h"
#include "vtkAirlightModule.h" // for export macro

#include <glm/glm.hpp>

#include <memory>
#include <string>
#include <vector>

class vtkImageData;

namespace airlight
{
// Immutable, so that many threads may use it at once.
class VTKAIRLIGHT_EXPORT DensityGrid
{
public:
  // Copies point scalars of the image, in their own type. Null and an error that continues "The
  // density image ..." where they are no densities.
  static std::shared_ptr<const DensityGrid> Build(vtkImageData* image, std::string& error);

  double GetDensity(const glm::dvec3& point) const;
  // The same at a place in samples, moved into their box.
  double GetDensityAt(const glm::dvec3& samples) const;

  // The part of [from, to] of a ray that is inside the box of samples; x >= y: none.
  glm::dvec2 GetRange(
    const glm::dvec3& origin, const glm::dvec3& direction, double from, double to) const;

  // Integral of the density on the part [from, to] of a ray of unit direction.
  double Integrate(
    const glm::dvec3& origin, const glm::dvec3& direction, double from, double to) const;

  // Adds where between from and to the ray passes from one cell to the next, or enters or leaves
  // the box of samples, in ascending order: there the density has kinks and jumps.
  void AddCuts(const glm::dvec3& origin, const glm::dvec3& direction, double from, double to,
    std::vector<double>& cuts) const;

  // Corners of the box along the world's axes that holds the whole image.
  const glm::dvec3& GetLeast() const { return this->Least; }
  const glm::dvec3& GetGreatest() const { return this->Greatest; }

  // Coordinates in units of samples, counted from the first one.
  glm::dvec3 ToSamples(const glm::dvec3& point) const { return this->Axes * (point - this->First); }
  glm::dvec3 ToWorld(const glm::dvec3& samples) const
  {
    return this->First + glm::inverse(this->Axes) * samples;
  }
  const glm::dmat3& GetAxes() const { return this->Axes; }
  // Of the last sample.
  glm::dvec3 GetLast() const { return glm::dvec3(this->Size - 1); }
  // The first sample's place among the image's points, and numbers of samples.
  const glm::ivec3& GetFirstPoint() const { return this->FirstPoint; }
  const glm::ivec3& GetSize() const { return this->Size; }
  const FilledBlocks& GetBlocks() const { return this->Blocks; }
  // x fastest.
  const DensitySamples& GetSamples() const { return this->Samples; }

private:
  DensityGrid() = default;
  bool ReadGeometry(vtkImageData* image, std::string& error);
  bool ReadSamples(vtkImageData* image, std::string& error);
  void Crop();

  glm::ivec3 FirstPoint{ 0 };
  glm::ivec3 Size{ 0 };
  DensitySamples Samples;
  FilledBlocks Blocks;
  glm::dvec3 First{ 0.0 }; // the first sample's place in the world
  glm::dmat3 Axes{ 1.0 };  // from the world to samples
  glm::dvec3 Least{ 0.0 };
  glm::dvec3 Greatest{ 0.0 };
};
}

#endif
