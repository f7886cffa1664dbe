// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Seeds of random scenes and frames, and files of them.
 */

#ifndef RandomSeeds_h
#define RandomSeeds_h

#include <cstdint>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace airlight_test
{
// A seed of two numbers.
inline std::uint64_t Mix(std::uint64_t a, std::uint64_t b)
{
  std::uint64_t x = a * 0x9e3779b97f4a7c15u + b * 0xbf58476d1ce4e5b9u + 0x94d049bb133111ebu;
  x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
  return x ^ (x >> 31);
}

// Numbers; what follows # on a line is not read.
inline bool ReadSeeds(const std::string& file, std::vector<std::uint64_t>& seeds)
{
  std::ifstream stream(file);
  std::string line;
  while (std::getline(stream, line))
  {
    std::istringstream words(line.substr(0, line.find('#')));
    std::uint64_t seed = 0;
    while (words >> seed)
    {
      seeds.push_back(seed);
    }
  }
  return stream.eof();
}

// Seeds that are known to fail, each with the number of its problems behind it.
inline bool ReadOpen(const std::string& file, std::map<std::uint64_t, size_t>& open)
{
  std::vector<std::uint64_t> numbers;
  const bool ok = ReadSeeds(file, numbers) && numbers.size() % 2 == 0;
  for (size_t i = 0; i + 1 < numbers.size(); i += 2)
  {
    open[numbers[i]] = static_cast<size_t>(numbers[i + 1]);
  }
  return ok;
}
}

#endif
