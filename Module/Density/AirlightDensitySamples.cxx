// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Density/AirlightDensitySamples.h"

#include "vtkArrayDispatch.h"
#include "vtkDataArray.h"
#include "vtkDataArrayRange.h"

#include <algorithm>
#include <iterator>
#include <sstream>

namespace airlight
{
namespace
{
// NaN is none.
bool IsDensity(double value) { return value >= 0.0 && value <= 1e100; }

// The type in which samples of a type are kept: no sample that is a density changes its value.
template <typename T>
using Kept = std::conditional_t<std::is_same_v<T, float>, float,
  std::conditional_t<std::is_integral_v<T> && sizeof(T) == 1, std::uint8_t,
    std::conditional_t<std::is_integral_v<T> && sizeof(T) == 2, std::uint16_t, double>>>;

// Copies up to the first value that is no density; its number, or the number of values.
struct Copy
{
  template <typename Array, typename Variant>
  void operator()(Array* scalars, Variant& all, vtkIdType& copied) const
  {
    const auto values = vtk::DataArrayTupleRange(scalars);
    using T = Kept<vtk::GetAPIType<Array>>;
    auto& kept = all.template emplace<std::vector<T>>(values.size());
    for (copied = 0; copied < values.size(); ++copied)
    {
      const auto value = values[copied][0];
      if (!IsDensity(static_cast<double>(value)))
      {
        return;
      }
      kept[copied] = static_cast<T>(value);
    }
  }
};
}

//------------------------------------------------------------------------------
bool DensitySamples::Read(vtkDataArray* scalars, std::string& error)
{
  vtkIdType copied = 0;
  if (!vtkArrayDispatch::Dispatch::Execute(scalars, Copy(), this->All, copied))
  {
    Copy()(scalars, this->All, copied);
  }
  if (copied == scalars->GetNumberOfTuples())
  {
    return true;
  }
  std::ostringstream text;
  text << "has the value " << scalars->GetComponent(copied, 0) << " at point " << copied
       << " of its scalars '" << (scalars->GetName() ? scalars->GetName() : "without name")
       << "': densities must be finite, at least 0 and at most 1e100";
  error = text.str();
  return false;
}

//------------------------------------------------------------------------------
bool DensitySamples::IsAnyAboveZero(size_t begin, size_t end) const
{
  return std::visit(
    [begin, end](const auto& values) {
      return std::any_of(
        values.begin() + begin, values.begin() + end, [](auto value) { return value > 0; });
    },
    this->All);
}

//------------------------------------------------------------------------------
bool DensitySamples::IsAnyAboveZero(
  const glm::ivec3& low, const glm::ivec3& high, const glm::ivec3& size) const
{
  for (int k = low.z; k <= high.z; ++k)
  {
    for (int j = low.y; j <= high.y; ++j)
    {
      const size_t row = (static_cast<size_t>(k) * size.y + j) * size.x;
      if (this->IsAnyAboveZero(row + low.x, row + high.x + 1))
      {
        return true;
      }
    }
  }
  return false;
}

//------------------------------------------------------------------------------
std::pair<size_t, size_t> DensitySamples::FindAboveZero(size_t begin, size_t end) const
{
  return std::visit(
    [begin, end](const auto& values) {
      const auto isAbove = [](auto value) { return value > 0; };
      const auto from = values.begin() + begin;
      const auto to = values.begin() + end;
      const auto first = std::find_if(from, to, isAbove);
      const auto last =
        std::find_if(std::make_reverse_iterator(to), std::make_reverse_iterator(first), isAbove);
      return first == to
        ? std::pair<size_t, size_t>(end, begin)
        : std::pair<size_t, size_t>(first - values.begin(), last.base() - 1 - values.begin());
    },
    this->All);
}

//------------------------------------------------------------------------------
// Row by row, each towards the beginning.
void DensitySamples::Crop(const glm::ivec3& low, const glm::ivec3& count, const glm::ivec3& size)
{
  std::visit(
    [&](auto& values) {
      auto to = values.begin();
      for (int k = low.z; k < low.z + count.z; ++k)
      {
        for (int j = low.y; j < low.y + count.y; ++j)
        {
          const size_t first = (static_cast<size_t>(k) * size.y + j) * size.x + low.x;
          to = std::copy_n(values.begin() + first, count.x, to);
        }
      }
      values.erase(to, values.end());
      values.shrink_to_fit();
    },
    this->All);
}

//------------------------------------------------------------------------------
int DensitySamples::GetBits() const
{
  return std::visit(
    [](const auto& values) {
      using T = typename std::decay_t<decltype(values)>::value_type;
      constexpr bool isWhole = std::is_integral_v<T>;
      return isWhole ? static_cast<int>(8 * sizeof(T)) : 32;
    },
    this->All);
}

//------------------------------------------------------------------------------
size_t DensitySamples::GetNumberOfBytes() const
{
  return std::visit(
    [](const auto& values) { return values.size() * sizeof(values[0]); }, this->All);
}
}
