// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Random numbers that depend on a seed, a pixel, a sample and a counter, and on nothing else: the
 * same in any number of threads and in any order.
 */

#ifndef AirlightRandomNumbers_h
#define AirlightRandomNumbers_h

#include <algorithm>
#include <cstdint>

namespace airlight
{
class RandomNumbers
{
public:
  RandomNumbers(std::uint64_t seed, std::uint64_t pixel, std::uint64_t sample)
    : Key(Mix(Mix(Mix(seed) + pixel) + sample))
  {
  }

  // The next one, above 0 and below 1.
  double Next()
  {
    this->Key += 0x9E3779B97F4A7C15u; // 2^64 over the golden ratio: a Weyl sequence
    const double number =
      (static_cast<double>(Mix(this->Key) >> 11) + 0.5) * (1.0 / 9007199254740992.0);
    return std::min(number, 1.0 - 1.0 / 9007199254740992.0); // rounding
  }

private:
  // A bijection in which each bit depends on all: Stafford's thirteenth mixer of 64 bits, as in
  // Steele, Lea and Flood's SplitMix (2014).
  static std::uint64_t Mix(std::uint64_t x)
  {
    x = (x ^ (x >> 30)) * 0xBF58476D1CE4E5B9u;
    x = (x ^ (x >> 27)) * 0x94D049BB133111EBu;
    return x ^ (x >> 31);
  }

  std::uint64_t Key;
};
}

#endif
