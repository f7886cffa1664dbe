// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightScrambledNet.h"

#include <array>

namespace airlight
{
namespace
{
constexpr int Digits = 32;
constexpr std::uint32_t PixelSeed = 0; // lights have those above

// A primitive polynomial over two elements, without its first and last coefficient, and the first
// direction numbers.
struct Dimension
{
  int Degree;
  std::uint32_t Coefficients;
  std::array<std::uint32_t, 3> First;
};
constexpr std::array<Dimension, 5> Dimensions = { {
  { 0, 0, { 1, 1, 1 } }, // all are 1
  { 1, 0, { 1, 0, 0 } },
  { 2, 1, { 1, 3, 0 } },
  { 3, 1, { 1, 3, 1 } },
  { 3, 2, { 1, 1, 1 } },
} };

using Directions = std::array<std::uint32_t, Digits>;

Directions MakeDirections(const Dimension& dimension)
{
  const int degree = dimension.Degree;
  Directions directions{};
  for (int i = 0; i < Digits; ++i)
  {
    if (degree == 0 || i < degree)
    {
      directions[i] = (degree == 0 ? 1u : dimension.First[i]) << (Digits - 1 - i);
      continue;
    }
    directions[i] = directions[i - degree] ^ (directions[i - degree] >> degree);
    for (int k = 1; k < degree; ++k)
    {
      const bool has = (dimension.Coefficients >> (degree - 1 - k)) & 1u;
      directions[i] ^= has ? directions[i - k] : 0u;
    }
  }
  return directions;
}

// A digit that looks random, by the digits above it.
std::uint32_t GetFlip(std::uint32_t above, int place, int dimension, std::uint32_t seed)
{
  constexpr std::uint64_t GoldenRatio = 0x9E3779B97F4A7C15u; // 2^64 over it
  std::uint64_t mixed = (static_cast<std::uint64_t>(seed) << 16) + 64u * dimension + place + 1u;
  for (int round = 0; round < 3; ++round)
  {
    mixed = (mixed + above) * GoldenRatio;
    mixed ^= mixed >> 29;
  }
  return (mixed >> 40) & 1u;
}

// Turns the tree of intervals at each of its branches or not: nets stay nets.
std::uint32_t Scramble(std::uint32_t digits, int dimension, std::uint32_t seed)
{
  std::uint32_t result = 0;
  std::uint32_t above = 0;
  for (int place = Digits - 1; place >= 0; --place)
  {
    const std::uint32_t digit = (digits >> place) & 1u;
    result = 2u * result + (digit ^ GetFlip(above, place, dimension, seed));
    above = 2u * above + digit;
  }
  return result;
}

double ToUnit(std::uint32_t digits) { return digits / 4294967296.0; }
}

//------------------------------------------------------------------------------
std::uint32_t GetNetDigits(std::uint32_t number, int dimension, std::uint32_t seed)
{
  static const std::array<Directions, 5> directions = { MakeDirections(Dimensions[0]),
    MakeDirections(Dimensions[1]), MakeDirections(Dimensions[2]), MakeDirections(Dimensions[3]),
    MakeDirections(Dimensions[4]) };
  std::uint32_t digits = 0;
  for (int i = 0; number >> i > 0 && i < Digits; ++i)
  {
    digits ^= (number >> i) & 1u ? directions[dimension][i] : 0u;
  }
  return Scramble(digits, dimension, seed);
}

//------------------------------------------------------------------------------
// Digits that are turned alike everywhere take the first to the middle.
glm::dvec2 GetPixelOffset(int number)
{
  glm::dvec2 offset;
  for (int i = 0; i < 2; ++i)
  {
    const std::uint32_t middle = 0x80000000u ^ GetNetDigits(0, i, PixelSeed);
    offset[i] = ToUnit(GetNetDigits(static_cast<std::uint32_t>(number), i, PixelSeed) ^ middle);
  }
  return offset - 0.5;
}

//------------------------------------------------------------------------------
glm::dvec3 GetLampNumbers(int number, int light)
{
  glm::dvec3 numbers;
  for (int i = 0; i < 3; ++i)
  {
    numbers[i] = ToUnit(GetNetDigits(static_cast<std::uint32_t>(number), 2 + i,
      PixelSeed + 1 + static_cast<std::uint32_t>(light)));
  }
  return numbers + 0.5 / 4294967296.0;
}
}
