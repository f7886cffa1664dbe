// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The samples of a density image, copied in the type that they have: 256^3 bytes take 17 MB and not
 * the 134 MB of doubles. What is read of them is the same double.
 */

#ifndef AirlightDensitySamples_h
#define AirlightDensitySamples_h

#include <glm/glm.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

class vtkDataArray;

namespace airlight
{
class DensitySamples
{
public:
  // Of the first component. Types of 8 and 16 bits and float keep theirs, others become double.
  // False, and an error that continues "The density image ...", where a value is no density.
  bool Read(vtkDataArray* scalars, std::string& error);

  double operator[](size_t i) const
  {
    return std::visit(
      [i](const auto& values) { return static_cast<double>(values[i]); }, this->All);
  }

  // Samples first, first + 1, and those a row further on.
  glm::dvec4 GetSquare(size_t first, size_t rowLength) const
  {
    return std::visit(
      [first, rowLength](const auto& values) {
        const auto* row = values.data() + first;
        return glm::dvec4(row[0], row[1], row[rowLength], row[rowLength + 1]);
      },
      this->All);
  }

  bool IsAnyAboveZero(size_t begin, size_t end) const;
  // From one sample to another one, both included, of so many along each axis.
  bool IsAnyAboveZero(const glm::ivec3& low, const glm::ivec3& high, const glm::ivec3& size) const;
  // The first and the last one that is; a first after the last where none is.
  std::pair<size_t, size_t> FindAboveZero(size_t begin, size_t end) const;

  // Keeps a box of `count` samples, the first of which is `low`, of `size` along each axis.
  void Crop(const glm::ivec3& low, const glm::ivec3& count, const glm::ivec3& size);

  // Of the whole numbers that they are, 8 or 16; 32: of others, which single precision is to hold.
  int GetBits() const;

  // Memory, without what the vector itself takes.
  size_t GetNumberOfBytes() const;

private:
  std::variant<std::vector<double>, std::vector<float>, std::vector<std::uint16_t>,
    std::vector<std::uint8_t>>
    All;
};
}

#endif
