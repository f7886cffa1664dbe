// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Photometric files for the tests: tables, their text, and their intensities by hand. Symmetry is
 * followed by folding the angle back into the table, where the library expands the table.
 */

#ifndef AirlightTestPhotometry_h
#define AirlightTestPhotometry_h

#include "AirlightTestTools.h"

#include "Integration/AirlightMath.h"
#include "Photometry/AirlightPhotometry.h"

#include <memory>
#include <string>
#include <vector>

namespace airlight_test
{
constexpr double Degree = 3.14159265358979323846 / 180.0;

// A file of Testing/Data/Photometry, without a name the folder with a slash; and a file to write
// to.
std::string GetPhotometricFile(int argc, char* argv[], const std::string& name = "");
std::string GetTemporaryFile(int argc, char* argv[], const std::string& name);

struct LampTable
{
  int Type; // 1 C, 2 B, 3 A
  std::vector<double> Vertical;
  std::vector<double> Horizontal;
  std::vector<double> Candela;
};

std::string Join(const std::vector<double>& numbers, const std::string& separator);

// The numbers of a file of multiplier 2 and ballast factor 0.75: candela are 1.5 times the values.
std::string TableNumbers(
  const LampTable& table, const std::string& separator = " ", const char* lampFactor = "1");

std::string TableText(const LampTable& table);

// Writes the reason where the answer is null.
std::shared_ptr<const airlight::Photometry> ReadOrTell(const std::string& file);

std::shared_ptr<const airlight::Photometry> ParseOrTell(const LampTable& table);

std::shared_ptr<const airlight::Photometry> WriteAndRead(
  const std::string& file, const std::string& text);

// The place of x among ascending angles: the interval and the share of it; false outside.
bool FindPlace(const std::vector<double>& angles, double x, size_t& index, double& share);

// A horizontal angle of type C as the one of the table's range that shines alike.
double FoldHorizontal(const LampTable& table, double h);

// The value of the table at angles in degrees, by the rules of LM-63.
double TableValue(LampTable table, double v, double h);

//------------------------------------------------------------------------------
// The look-up of the library in both precisions.
class TestLamp
{
public:
  TestLamp(const airlight::Photometry& photometry, const glm::dvec3& axis, const glm::dvec3& up)
    : Texels(photometry.Pack())
    , Texels32(this->Texels.begin(), this->Texels.end())
  {
    // Other texels before the lamp's own, as where lamps share a buffer.
    this->Texels.insert(this->Texels.begin(), 3, glm::dvec4(7.0));
    this->In64 = { this->Texels.data(), 3, axis, up };
    this->In32 = { this->Texels32.data(), 0, glm::vec3(axis), glm::vec3(up) };
  }
  TestLamp(const TestLamp&) = delete;
  void operator=(const TestLamp&) = delete;

  // The direction of a pair of angles in degrees, as the coordinates are defined.
  glm::dvec3 Direction(int type, double v, double h) const
  {
    const glm::dvec3 right = glm::cross(this->In64.axis, this->In64.up);
    const glm::dvec3 components = Components(type, v * Degree, h * Degree);
    return components.x * this->In64.axis + components.y * this->In64.up + components.z * right;
  }

  double Look(const glm::dvec3& direction) const
  {
    return airlight::f64::airlightPhotometry(this->In64, direction);
  }

  std::vector<glm::dvec4> Texels;
  std::vector<glm::vec4> Texels32;
  airlight::f64::AirlightPhotometry In64;
  airlight::f32::AirlightPhotometry In32;

private:
  // Along axis, up and right.
  static glm::dvec3 Components(int type, double v, double h)
  {
    if (type == 1)
    {
      return { std::cos(v), std::sin(v) * std::cos(h), -std::sin(v) * std::sin(h) };
    }
    if (type == 2)
    {
      return { std::cos(h) * std::cos(v), std::cos(h) * std::sin(v), std::sin(h) };
    }
    return { std::cos(v) * std::cos(h), std::sin(v), std::cos(v) * std::sin(h) };
  }
};

// Angles that ascend from first to last in random steps of at least 0.3 of the mean one.
std::vector<double> RandomAngles(Random& random, double first, double last);

// One of the kinds of symmetry and range that LM-63 has, with random values up to 1000.
constexpr int TableKinds = 12;

LampTable RandomTable(Random& random, int kind);

// A random right-handed frame.
void RandomFrame(Random& random, glm::dvec3& axis, glm::dvec3& up);
}

#endif
