// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Colours at the points of a density image: an array of albedos, or of factors of the emission.
 * Trilinear between the points, as the density is (Density/AirlightDensityGrid.h).
 */

#ifndef AirlightImageColours_h
#define AirlightImageColours_h

#include "vtkAirlightModule.h" // for export macro

#include <glm/glm.hpp>

#include <memory>
#include <string>
#include <vector>

class vtkImageData;

namespace airlight
{
class DensityGrid;

// Immutable, so that many threads may use it at once.
class VTKAIRLIGHT_EXPORT ImageColours
{
public:
  // Copies a point array of this name, with one component for all channels or three, at the points
  // of which the density's samples are kept. Null and an error that continues "The density image
  // ..." where it has a value that is not from 0 to `most`.
  static std::shared_ptr<const ImageColours> Build(vtkImageData* image, const DensityGrid& grid,
    const std::string& name, double most, std::string& error);

  // At a place in samples of the density, moved into the image.
  glm::dvec3 GetAt(const glm::dvec3& samples) const;

  // x fastest; the fourth number is not used.
  const std::vector<glm::vec4>& GetTexels() const { return this->Texels; }

private:
  ImageColours() = default;

  glm::ivec3 Size{ 0 };
  std::vector<glm::vec4> Texels;
};
}

#endif
