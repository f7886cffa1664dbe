// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Density/AirlightFilledBlocks.h"

#include "Density/AirlightDensitySamples.h"

#include "vtkSMPTools.h"
#include "vtkType.h"

#include <cstddef>

namespace airlight
{
//------------------------------------------------------------------------------
// Blocks share the samples on their faces.
FilledBlocks::FilledBlocks(const DensitySamples& samples, const glm::ivec3& size)
{
  const glm::ivec3 blocks = (size - 2) / Cells + 1;
  this->Filled.resize(static_cast<size_t>(blocks.x) * blocks.y * blocks.z);
  const auto isFilled = [&](const glm::ivec3& low) {
    return samples.IsAnyAboveZero(low, glm::min(low + Cells, size - 1), size);
  };
  vtkSMPTools::For(0, blocks.z, [&](vtkIdType first, vtkIdType last) {
    size_t number = static_cast<size_t>(first) * blocks.x * blocks.y;
    for (int k = static_cast<int>(first); k < last; ++k)
    {
      for (int j = 0; j < blocks.y; ++j)
      {
        for (int i = 0; i < blocks.x; ++i)
        {
          this->Filled[number++] = isFilled(Cells * glm::ivec3(i, j, k)) ? 1 : 0;
        }
      }
    }
  });
}
}
