// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which blocks of a density image's cells have something: rays leave the others in one step. A
 * block has eight cells along each axis, as AIRLIGHT_BLOCK_SHIFT in AirlightGrid.glsl says.
 */

#ifndef AirlightFilledBlocks_h
#define AirlightFilledBlocks_h

#include <glm/glm.hpp>

#include <cstdint>
#include <vector>

namespace airlight
{
class DensitySamples;

class FilledBlocks
{
public:
  static constexpr int Cells = 8; // along each axis of a block

  FilledBlocks() = default;
  // `size`: numbers of samples.
  FilledBlocks(const DensitySamples& samples, const glm::ivec3& size);

  // 1 for blocks that have something, else 0; x fastest.
  const std::vector<std::uint8_t>& GetFilled() const { return this->Filled; }

private:
  std::vector<std::uint8_t> Filled;
};
}

#endif
