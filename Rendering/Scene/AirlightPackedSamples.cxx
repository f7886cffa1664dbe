// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightPackedSamples.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>

namespace airlight
{
namespace
{
// A row of n samples has n - 1 cells, three in a texel.
size_t CountRowTexels(int samples) { return (static_cast<size_t>(samples) + 1) / 3; }

template <typename Samples, typename Texel>
void Pack(const Samples& samples, const glm::ivec3& size, Texel* texels)
{
  const size_t rowTexels = CountRowTexels(size.x);
  vtkSMPTools::For(0, static_cast<vtkIdType>(size.y) * size.z, [&](vtkIdType a, vtkIdType b) {
    for (vtkIdType row = a; row < b; ++row)
    {
      const size_t first = static_cast<size_t>(row) * size.x;
      for (size_t i = 0; i < 4 * rowTexels; ++i)
      {
        const size_t column = std::min<size_t>(3 * (i / 4) + i % 4, size.x - 1);
        texels[row * rowTexels + i / 4][static_cast<int>(i % 4)] =
          static_cast<typename Texel::value_type>(std::min(samples[first + column], OpaqueDensity));
      }
    }
  });
}
}

//------------------------------------------------------------------------------
size_t CountTexels(const glm::ivec3& size) { return CountRowTexels(size.x) * size.y * size.z; }

//------------------------------------------------------------------------------
template <typename Texel>
void PackSamples(const DensitySamples& samples, const glm::ivec3& size, Texel* texels)
{
  Pack(samples, size, texels);
}

template void PackSamples(const DensitySamples&, const glm::ivec3&, glm::vec4*);
template void PackSamples(const DensitySamples&, const glm::ivec3&, glm::u16vec4*);
template void PackSamples(const DensitySamples&, const glm::ivec3&, glm::u8vec4*);

//------------------------------------------------------------------------------
void PackSamples(const std::vector<double>& samples, const glm::ivec3& size, glm::vec4* texels)
{
  Pack(samples, size, texels);
}
}
