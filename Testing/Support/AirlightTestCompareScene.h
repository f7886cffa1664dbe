// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Compares the buffers of a drawn scene with brute force on random pixels.
 */

#ifndef AirlightTestCompareScene_h
#define AirlightTestCompareScene_h

#include "AirlightTestScene.h"

class vtkAirlightReference;

namespace airlight_test
{
// The largest share of rays that may fail to be decided by brute force itself.
constexpr double MostExcluded = 0.05;

// The largest share of the others that may be wrong by more than 1 %, in addition to one.
constexpr double MostWrong = 1e-3;

// What a technique promises: the 99th percentile and the median of relative errors. Those of shadow
// planes are at most five times what Mesa's software renderer leaves: single precision.
struct Limits
{
  int Technique = vtkAirlightPass::SHADOW_PLANES;
  double Median = 2e-6; // of what comes from lit intervals
  double P99 = 1.5e-5;
  double SurfaceMedian = 1.2e-5; // of what surfaces send
  double SurfaceP99 = 4e-4;
  double Wrong = MostWrong; // share of rays that may be wrong by more than 1 %
  double EdgePixels = 0.0;  // edges of shadows on surfaces may be so far off
  double Rounding = 0.0;    // of VTK's mappers, relative to the distances of surfaces
  bool Spot = false;        // brute force knows of cones only for Airlight
};

//------------------------------------------------------------------------------
// Relative errors of one buffer over a scene's rays. The error is relative to the value; values
// below 1/1000 of the scene's 99th percentile are measured against that.
class Errors
{
public:
  void Add(const glm::dvec3& value, const glm::dvec3& expected)
  {
    this->Pairs.emplace_back(value, expected);
  }

  // Prints the quantiles and checks them.
  void Report(const std::string& scene, const char* name, double median, double p99,
    double wrong = MostWrong) const
  {
    std::vector<double> sizes;
    for (const auto& pair : this->Pairs)
    {
      sizes.push_back(Largest(pair.second));
    }
    const double floor = 1e-3 * Quantile(sizes, 0.99) + 1e-30;
    std::vector<double> errors;
    for (const auto& pair : this->Pairs)
    {
      const glm::dvec3 difference = glm::abs(pair.first - pair.second);
      const double error = Largest(difference / glm::max(glm::abs(pair.second), glm::dvec3(floor)));
      errors.push_back(std::isfinite(error) ? error : Infinity);
    }
    const double measured[3] = { Quantile(errors, 0.5), Quantile(errors, 0.99),
      Quantile(errors, 1.0) };
    std::cout << "  " << name << ": median " << measured[0] << ", p99 " << measured[1]
              << ", largest " << measured[2] << " (" << errors.size() << " rays)\n";
    const auto gross =
      std::count_if(errors.begin(), errors.end(), [](double error) { return error > 0.01; });
    Check(static_cast<double>(gross) <= wrong * static_cast<double>(errors.size()) + 1.0,
      scene + ": " + std::to_string(gross) + " rays are wrong by more than 1 %: " + name);
    Check(measured[0] <= median, scene + ": median error of " + name);
    Check(measured[1] <= p99, scene + ": 99th percentile of the error of " + name);
  }

private:
  static double Largest(const glm::dvec3& v)
  {
    return std::isnan(v.x + v.y + v.z) ? Infinity : std::max({ v.x, v.y, v.z });
  }

  std::vector<std::pair<glm::dvec3, glm::dvec3>> Pairs;
};

bool Differ(double a, double b, double floor);

// Whether 0.02 pixels to either side brute force gives another answer by more than 1 %: the ray
// grazes an edge, and no rasteriser need decide as double precision does. `floor` is the airlight
// below which differences do not matter.
bool IsUnstable(Scene& scene, double px, double py, const Answer& answer, double floor);

//------------------------------------------------------------------------------
// Draws the scene and checks random pixels.
void CompareScene(
  const std::string& name, Scene& scene, int rays = 2000, const Limits& limits = {});

// The error that 98 % of the reference's values are below, over the largest value of the picture:
// edges, which rasterisation rounds, are left out.
double CompareWithReference(Scene& scene, vtkAirlightReference* reference, const char* name);
}

#endif
