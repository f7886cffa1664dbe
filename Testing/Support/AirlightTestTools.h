// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the tests of numbers share: random numbers that are the same everywhere, and the worst
 * case of each kind of comparison with its inputs.
 */

#ifndef AirlightTestTools_h
#define AirlightTestTools_h

#include <glm/glm.hpp>

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <iostream>
#include <random>
#include <sstream>
#include <string>

namespace airlight_test
{
// Uniform numbers by an own mapping: std::uniform_real_distribution differs between libraries.
class Random
{
public:
  explicit Random(std::uint64_t seed)
    : Engine(seed)
  {
  }

  double Uniform(double low, double high)
  {
    return low + (high - low) * static_cast<double>(this->Engine() >> 11) * 0x1p-53;
  }

  double LogUniform(double low, double high)
  {
    return std::exp(this->Uniform(std::log(low), std::log(high)));
  }

  int Index(int count) { return static_cast<int>(this->Uniform(0.0, count)); }

private:
  std::mt19937_64 Engine;
};

inline glm::dvec3 RandomPoint(Random& random, double reach)
{
  return { random.Uniform(-reach, reach), random.Uniform(-reach, reach),
    random.Uniform(-reach, reach) };
}

// Directions, all alike.
inline glm::dvec3 RandomUnit(Random& random)
{
  glm::dvec3 v;
  do
  {
    v = RandomPoint(random, 1.0);
  } while (glm::length(v) < 0.1 || glm::length(v) > 1.0);
  return glm::normalize(v);
}

// Three unit vectors at right angles.
inline glm::dmat3 RandomAxes(Random& random)
{
  const glm::dvec3 x = RandomUnit(random);
  const glm::dvec3 y = glm::normalize(glm::cross(x, RandomUnit(random)));
  return glm::dmat3(x, y, glm::cross(x, y));
}

// What single precision makes of it. Volatile: GCC 12 at -O2 turns two neighbouring conversions
// from double to float and back into none.
inline double Rounded(double v)
{
  const volatile float rounded = static_cast<float>(v);
  return rounded;
}

inline glm::dvec3 Rounded(const glm::dvec3& v)
{
  return { Rounded(v.x), Rounded(v.y), Rounded(v.z) };
}

// One kind of comparison: counts the failures, remembers the worst case, prints both.
class Comparison
{
public:
  explicit Comparison(const std::string& name)
    : Name(name)
  {
  }

  // `describe` returns the inputs as text; it is called for new worst cases only.
  template <typename Describe>
  void Add(double error, double limit, const Describe& describe)
  {
    ++this->Count;
    const bool ok = error <= limit; // false for NaN
    this->Failures += ok ? 0 : 1;
    const double ratio = error / limit;
    if (std::isnan(this->Ratio))
    {
      return;
    }
    if (std::isnan(error) || ratio > this->Ratio)
    {
      this->Ratio = std::isnan(error) ? error : ratio;
      this->Error = error;
      this->Limit = limit;
      this->Case = describe();
    }
  }

  // True where nothing failed and there was something to compare.
  bool Report() const
  {
    const bool ok = this->Failures == 0 && this->Count > 0;
    std::cout << (ok ? "ok      " : "FAILED  ") << this->Name << ": " << this->Count
              << " comparisons, " << this->Failures << " failures; worst error " << this->Error
              << ", limit " << this->Limit << "\n";
    if (this->Count > 0)
    {
      std::cout << "          at " << this->Case << "\n";
    }
    return ok;
  }

private:
  std::string Name;
  long Count = 0;
  long Failures = 0;
  double Ratio = -1.0;
  double Error = 0.0;
  double Limit = 0.0;
  std::string Case;
};

// Reports all of them.
inline bool AllOk(std::initializer_list<const Comparison*> comparisons)
{
  bool ok = true;
  for (const Comparison* comparison : comparisons)
  {
    ok = comparison->Report() && ok;
  }
  return ok;
}

// "name value, name value, ..." in all digits.
template <typename... Rest>
std::string Text(const Rest&... parts)
{
  std::ostringstream out;
  out.precision(17);
  (out << ... << parts);
  return out.str();
}

inline std::string Text3(const double v[3]) { return Text("(", v[0], ", ", v[1], ", ", v[2], ")"); }
}

#endif
