// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Compares the buffers of a drawn scene with brute force on random pixels.
 */

#ifndef AirlightCompareScene_h
#define AirlightCompareScene_h

#include "AirlightTestScene.h"

#include <random>

namespace airlighttest
{
// The largest share of rays that may fail to be decided by brute force itself.
constexpr double MostExcluded = 0.05;

// The largest share of the others that may be wrong by more than 1 %, besides one.
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

  static double Quantile(std::vector<double> values, double q)
  {
    if (values.empty())
    {
      return 0.0;
    }
    std::sort(values.begin(), values.end());
    return values[static_cast<size_t>(q * static_cast<double>(values.size() - 1))];
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

//------------------------------------------------------------------------------
inline bool Differ(double a, double b, double floor)
{
  return a != b && std::abs(a - b) > 0.01 * std::max(std::abs(a), floor);
}

// Whether 0.02 pixels to either side brute force gives another answer by more than 1 %: the ray
// grazes an edge, and no rasteriser need decide as double precision does. `floor` is the airlight
// below which differences do not matter.
inline bool IsUnstable(Scene& scene, double px, double py, const Answer& answer, double floor)
{
  for (int i = 0; i < 4; ++i)
  {
    const Answer other =
      scene.GetAnswer(px + (i % 2 == 0 ? -0.02 : 0.02), py + (i < 2 ? -0.02 : 0.02));
    for (int k = 0; k < 3; ++k)
    {
      if (Differ(answer.Airlight[k], other.Airlight[k], floor) ||
        Differ(answer.Surface[k], other.Surface[k], 1e-3))
      {
        return true;
      }
    }
    if (Differ(answer.Depth, other.Depth, 0.0) || Differ(answer.LitLength, other.LitLength, 1e-2))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// Whether light on the surface changes, by more than half, at most so many pixels away.
inline bool IsAtEdge(Scene& scene, double px, double py, const Answer& answer, double pixels)
{
  for (int i = 0; i < 4 && pixels > 0.0; ++i)
  {
    const Answer other =
      scene.GetAnswer(px + (i % 2 == 0 ? -pixels : pixels), py + (i < 2 ? -pixels : pixels));
    const double low = std::min(answer.Surface.y, other.Surface.y);
    if (low < 0.5 * std::max(answer.Surface.y, other.Surface.y))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// Draws the scene and checks random pixels.
inline void CompareScene(
  const std::string& name, Scene& scene, int rays = 2000, const Limits& limits = {})
{
  scene.Window->Render();
  Check(scene.Pass->GetEffectiveShadowTechnique() == limits.Technique,
    name + ": drawn with the technique asked for");
  if (!Check(scene.GetBuffer("Airlight") != nullptr, name + ": buffers are recorded"))
  {
    return;
  }
  std::mt19937 random(20060130);
  std::uniform_int_distribution<int> columns(0, scene.Width - 1);
  std::uniform_int_distribution<int> rows(0, scene.Height - 1);
  Errors airlight, litLength, depth, surface;
  int excluded = 0;
  int shadowed = 0;
  int dark = 0;
  for (int i = 0; i < rays; ++i)
  {
    const int x = columns(random);
    const int y = rows(random);
    const Answer answer = scene.GetAnswer(x + 0.5, y + 0.5);
    if (IsUnstable(scene, x + 0.5, y + 0.5, answer, 1e-3 * answer.Unshadowed.x))
    {
      ++excluded;
      continue;
    }
    shadowed += answer.Airlight.x < 0.99 * answer.Unshadowed.x;
    airlight.Add(GetColour(scene.GetBuffer("Airlight"), x, y), answer.Airlight);
    depth.Add(glm::dvec3(GetValue(scene.GetBuffer("Depth"), x, y)), glm::dvec3(answer.Depth));
    if (!limits.Spot && answer.LitLength < Infinity &&
      (answer.Depth >= 0.0 || answer.LitLength > 0.0))
    {
      litLength.Add(
        glm::dvec3(GetValue(scene.GetBuffer("LitLength"), x, y)), glm::dvec3(answer.LitLength));
    }
    if (!limits.Spot && answer.Depth >= 0.0 &&
      !IsAtEdge(scene, x + 0.5, y + 0.5, answer, limits.EdgePixels))
    {
      dark += answer.Surface == glm::dvec3(0.0);
      surface.Add(GetColour(scene.GetBuffer("Surface"), x, y), answer.Surface);
    }
  }
  std::cout << name << ": excluded " << 100.0 * excluded / rays << " %, shadowed air on "
            << 100.0 * shadowed / rays << " %, dark surface on " << 100.0 * dark / rays << " % of "
            << rays << " rays\n";
  Check(excluded < MostExcluded * rays, name + ": too many rays are excluded");
  Check(shadowed > rays / 100, name + ": the scene has shadows in the air");
  airlight.Report(name, "Airlight", limits.Median, limits.P99, limits.Wrong);
  litLength.Report(name, "LitLength", limits.Median, limits.P99, limits.Wrong);
  depth.Report(name, "Depth", 2.5e-7 + 2.0 * limits.Rounding, 5e-6 + 4.0 * limits.Rounding);
  surface.Report(name, "Surface", limits.SurfaceMedian + 4.0 * limits.Rounding,
    limits.SurfaceP99 + 40.0 * limits.Rounding);
}
}

#endif
