// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightLightGrid.h"

#include "Density/AirlightTrilinear.h"
#include "Scene/AirlightLightWays.h"
#include "Scene/AirlightPackedSamples.h"
#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <chrono>
#include <cmath>

namespace airlight
{
namespace
{
// Grids are refined until optical depths between their points are no more wrong than this, up to
// the largest grid: points along the image's longest side. The shadows of images that have more
// samples than it has points have more detail: they get the finest one up to another limit that
// takes about half a second on two cores. Ways in closed surfaces take longer.
constexpr double Tolerance = 1e-3;
constexpr double Smallest = 5.0;
constexpr double Largest = 65.0;
constexpr double Finer = 129.0;
constexpr double MostOfFiner = 1e8;  // points, times the cells that each of them takes
constexpr double CellsOnRays = 16.0; // of a point in a row of them on a ray from the light

constexpr int TestPoints = 500;
// Where less light than this is left, errors do not matter.
constexpr double OpaqueDepth = 5.0; // optical depth

// Samples that are looked at before a way is followed: it has hundreds itself.
constexpr double MostSearched = 5000.0;

LightGridMap BuildMap(const LightWays& ways, double longest)
{
  return ways.AreParallel() ? LightGridMap::BuildAlong(ways.GetGrid(), ways.GetLight(), longest)
                            : LightGridMap::BuildEven(ways.GetGrid(), longest);
}

// Points along the image's longest side of the finest grid.
double GetLargest(const LightWays& ways)
{
  const glm::dvec3 last = ways.GetGrid().GetLast();
  const double samples = std::max({ last.x, last.y, last.z }) + 1.0;
  if (samples <= Largest || ways.IsInSurface())
  {
    return Largest;
  }
  const double cells = ways.AreParallel() ? CellsOnRays : samples;
  const double affordable = MostOfFiner / (BuildMap(ways, Finer).CountPoints() * cells);
  return std::floor(std::clamp(Finer * std::cbrt(affordable), Largest, Finer));
}

// Whether the medium is in a cell that a point of the light's grid belongs to. `scale` is from
// points to samples.
bool IsNeeded(const DensityGrid& grid, const glm::dvec3& node, const glm::dvec3& scale)
{
  const glm::ivec3& size = grid.GetSize();
  const glm::ivec3 low = glm::max(glm::ivec3(glm::floor((node - 1.0) * scale)), 0);
  const glm::ivec3 high = glm::min(glm::ivec3(glm::ceil((node + 1.0) * scale)), size - 1);
  const glm::ivec3 count = high - low + 1;
  return static_cast<double>(count.x) * count.y * count.z > MostSearched ||
    grid.GetSamples().IsAnyAboveZero(low, high, size);
}

// The mean of those points around a point that are known, those that were measured; 0 without any.
double GetMeanAround(
  const std::vector<double>& means, const glm::ivec3& size, const glm::ivec3& point)
{
  const glm::ivec3 low = glm::max(point - 1, 0);
  const glm::ivec3 high = glm::min(point + 1, size - 1);
  double sum = 0.0;
  int count = 0;
  for (int k = low.z; k <= high.z; ++k)
  {
    for (int j = low.y; j <= high.y; ++j)
    {
      for (int i = low.x; i <= high.x; ++i)
      {
        const double mean = means[(static_cast<size_t>(k) * size.y + j) * size.x + i];
        sum += std::isnan(mean) ? 0.0 : mean;
        count += std::isnan(mean) ? 0 : 1;
      }
    }
  }
  return count > 0 ? sum / count : 0.0;
}

// Beside a closed surface: cells that it cuts shall not mix in densities of the outside.
std::vector<double> FillUnknown(const std::vector<double>& means, const glm::ivec3& size)
{
  std::vector<double> filled = means;
  for (size_t i = 0; i < means.size(); ++i)
  {
    if (std::isnan(means[i]))
    {
      const int at = static_cast<int>(i);
      filled[i] =
        GetMeanAround(means, size, { at % size.x, at / size.x % size.y, at / (size.x * size.y) });
    }
  }
  return filled;
}

// Row by row along the light's rays.
std::vector<double> MeasureRays(const LightWays& ways, const LightGridMap& map)
{
  const glm::ivec3 size = map.GetSize();
  const vtkIdType rows = static_cast<vtkIdType>(size.x) * size.y;
  const glm::dvec3 samples = ways.GetGrid().GetLast();
  std::vector<double> means(static_cast<size_t>(rows) * size.z);
  vtkSMPTools::For(0, rows, 64, [&](vtkIdType a, vtkIdType b) {
    for (vtkIdType row = a; row < b; ++row)
    {
      const glm::dvec3 first(
        static_cast<double>(row % size.x), static_cast<double>(row / size.x), 0.0);
      const glm::dvec3 last = first + glm::dvec3(0.0, 0.0, size.z - 1.0);
      ways.MeasureRay(samples * map.ToPlace(first), samples * map.ToPlace(last), size.z,
        [&means, rows, row](int k, double mean) { means[k * rows + row] = mean; });
    }
  });
  return means;
}

// 0 where nothing is scattered, unless `everywhere`.
std::vector<double> MeasurePoints(const LightWays& ways, const glm::ivec3& size, bool everywhere)
{
  const size_t count = static_cast<size_t>(size.x) * size.y * size.z;
  std::vector<double> means(count, ways.IsInSurface() ? LightWays::Unknown : 0.0);
  const glm::dvec3 step = ways.GetGrid().GetLast() / glm::dvec3(size - 1); // samples
  vtkSMPTools::For(0, static_cast<vtkIdType>(size.y) * size.z, 1, [&](vtkIdType a, vtkIdType b) {
    for (vtkIdType row = a; row < b; ++row)
    {
      const vtkIdType y = row % size.y;
      const vtkIdType z = row / size.y;
      const glm::dvec3 first(0.0, static_cast<double>(y), static_cast<double>(z));
      for (int i = 0; i < size.x; ++i)
      {
        const glm::dvec3 node = first + glm::dvec3(i, 0.0, 0.0);
        if (everywhere || IsNeeded(ways.GetGrid(), node, step))
        {
          means[row * size.x + i] = ways.Measure(step * node).x;
        }
      }
    }
  });
  return means;
}

std::vector<double> MeasureAll(const LightWays& ways, const LightGridMap& map, bool everywhere)
{
  const std::vector<double> means =
    ways.AreParallel() ? MeasureRays(ways, map) : MeasurePoints(ways, map.GetSize(), everywhere);
  return ways.IsInSurface() ? FillUnknown(means, map.GetSize()) : means;
}

// Van der Corput's sequence in this base: evenly spread and the same every time.
double Spread(int i, int base)
{
  double value = 0.0;
  for (double position = 1.0 / base; i > 0; i /= base, position /= base)
  {
    value += position * (i % base);
  }
  return value;
}

struct TestPoint
{
  glm::dvec3 Share; // of the image's sides
  double Mean;
  double Length;
};

std::vector<TestPoint> MakeTests(const LightWays& ways, double sigmaT, bool everywhere)
{
  std::vector<TestPoint> points;
  // A surface may be a small part of an image.
  const int most = ways.IsInSurface() ? 10 * TestPoints : TestPoints;
  for (int i = 1; i <= most && points.size() < TestPoints; ++i)
  {
    const glm::dvec3 share(Spread(i, 2), Spread(i, 3), Spread(i, 5));
    const glm::dvec3 position = share * ways.GetGrid().GetLast();
    if (everywhere || ways.Scatters(position))
    {
      const glm::dvec2 way = ways.Measure(position);
      if (sigmaT * way.x * way.y < OpaqueDepth)
      {
        points.push_back({ share, way.x, way.y });
      }
    }
  }
  return points;
}

std::shared_ptr<const std::vector<glm::vec4>> Pack(
  const std::vector<double>& means, const glm::ivec3& size)
{
  auto texels = std::make_shared<std::vector<glm::vec4>>(CountTexels(size));
  PackSamples(means, size, texels->data());
  return texels;
}
}

//------------------------------------------------------------------------------
LightGrid LightGrid::Build(const f64::AirlightMedium& medium, const f64::AirlightLight& light,
  bool everywhere, double seconds)
{
  const LightWays ways(medium, light);
  const double sigmaT = std::max({ medium.sigmaT.x, medium.sigmaT.y, medium.sigmaT.z });
  const std::vector<TestPoint> tests = MakeTests(ways, sigmaT, everywhere);
  const double largest = GetLargest(ways);
  LightGrid result{};
  for (double longest = Smallest; result.Means == nullptr;
       longest = std::min(2.0 * longest - 1.0, largest))
  {
    const auto start = std::chrono::steady_clock::now();
    const LightGridMap map = BuildMap(ways, longest);
    const glm::ivec3& size = map.GetSize();
    const std::vector<double> means = MeasureAll(ways, map, everywhere);
    result.Error = 0.0;
    for (const TestPoint& test : tests)
    {
      const double mean = InterpolateTrilinearly(means, size, map.ToPoints(test.Share));
      result.Error = std::max(result.Error, sigmaT * std::abs(mean - test.Mean) * test.Length);
    }
    result.IsFinest = result.Error <= Tolerance || longest == largest;
    // The next one has eight times as many points.
    const std::chrono::duration<double> next = 8.0 * (std::chrono::steady_clock::now() - start);
    if (result.IsFinest || next.count() > seconds)
    {
      result.Cells = glm::dvec3(size - 1);
      result.ToCells = map.GetMatrix();
      result.Means = Pack(means, size);
    }
    seconds -= 0.125 * next.count();
  }
  return result;
}

//------------------------------------------------------------------------------
const LightGrid& LightGrid::GetDark()
{
  static const LightGrid dark{ Pack(std::vector<double>(8, 0.0), glm::ivec3(2)), glm::dvec3(1.0),
    glm::dmat4(1.0), 0.0, true };
  return dark;
}
}
