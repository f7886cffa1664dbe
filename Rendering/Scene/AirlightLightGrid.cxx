// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightLightGrid.h"

#include "Density/AirlightTrilinear.h"
#include "Scene/AirlightPackedSamples.h"
#include "vtkSMPTools.h"
#include "vtkType.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

namespace airlight
{
namespace
{
// Grids are refined until optical depths between their points are no more wrong than this, up to
// the largest grid: points along the image's longest side. The shadows of images that have more
// samples than it has points have more detail: a finer one serves them where that takes less than
// half a second on two cores. Ways in closed surfaces take longer.
constexpr double Tolerance = 1e-3;
constexpr int Smallest = 5;
constexpr int Largest = 65;
constexpr int Finer = 129;
constexpr double MostOfFiner = 1e8; // points, times the samples on a way

constexpr int TestPoints = 500;
// Where less light than this is left, errors do not matter.
constexpr double OpaqueDepth = 5.0; // optical depth

// Samples that are looked at before a way is followed: it has hundreds itself.
constexpr double MostSearched = 5000.0;
// Inside by so much, in samples: ways along the image's faces are inside it.
constexpr double Inset = 1e-6;

constexpr double Unknown = std::numeric_limits<double>::quiet_NaN();

// The ways from points of the image to a light.
class Ways
{
public:
  Ways(const f64::AirlightMedium& medium, const f64::AirlightLight& light)
    : Medium(medium)
    , Grid(*medium.grid)
    , Light(light.position)
    , Directional(f64::airlightIsDirectional(light))
    , IsSurface(medium.region.kind == AIRLIGHT_REGION_SURFACE)
  {
  }

  // Mean density and length of a way from a place in samples; in a closed surface, of what is
  // inside, unknown where that is nothing.
  glm::dvec2 Measure(const glm::dvec3& samples) const
  {
    const glm::dvec3 inside = glm::clamp(
      samples, glm::dvec3(Inset), glm::max(this->Grid.GetLast() - Inset, glm::dvec3(Inset)));
    const glm::dvec3 point = this->Grid.ToWorld(inside);
    glm::dvec3 way = this->Light;
    double length = AIRLIGHT_FAR;
    if (!this->Directional)
    {
      way = this->Light - point;
      length = std::max(glm::length(way), 1e-300);
      way /= length;
    }
    glm::dvec2 range = f64::airlightRegionRange(this->Medium.region, point, way, length);
    range = this->Grid.GetRange(point, way, range.x, range.y);
    range.y = std::max(range.x, range.y);
    const glm::dvec3 entry = point + range.x * way;
    const double end = range.y - range.x;
    const double reach =
      this->IsSurface ? f64::airlightSurfaceSums(this->Medium, entry, way, end, 0.0).x : end;
    if (reach * glm::length(this->Grid.GetAxes() * way) > 10.0 * Inset)
    {
      const double depth =
        f64::airlightGridDepthInRegion(this->Medium, this->IsSurface, point, way, range.x, range.y);
      return { depth / reach, reach };
    }
    return { this->IsSurface && !this->Holds(point) ? Unknown : this->Grid.GetDensityAt(inside),
      reach };
  }

  // Whether something is scattered there.
  bool Scatters(const glm::dvec3& samples) const
  {
    return this->Grid.GetDensityAt(samples) > 0.0 && this->Holds(this->Grid.ToWorld(samples));
  }

  const DensityGrid& GetGrid() const { return this->Grid; }
  bool IsInSurface() const { return this->IsSurface; }

private:
  // Whether the region does.
  bool Holds(const glm::dvec3& point) const
  {
    const glm::dvec3 up(0.0, 0.0, 1.0);
    return f64::airlightPathAt(this->Medium, this->IsSurface, point, up, 0.0, 0.0, false).z > 0.5;
  }

  const f64::AirlightMedium& Medium;
  const DensityGrid& Grid;
  glm::dvec3 Light;
  bool Directional;
  bool IsSurface;
};

// As many points along each side as make cells about as long as wide.
glm::ivec3 GetSize(const DensityGrid& grid, int longest)
{
  const glm::dmat3 steps = glm::inverse(grid.GetAxes());
  const glm::dvec3 sides = grid.GetLast() *
    glm::dvec3(glm::length(steps[0]), glm::length(steps[1]), glm::length(steps[2]));
  const double most = std::max({ sides.x, sides.y, sides.z });
  return glm::max(glm::ivec3(glm::ceil(sides / most * (longest - 1.0))), 1) + 1;
}

int GetLargest(const Ways& ways)
{
  const glm::dvec3 last = ways.GetGrid().GetLast();
  const double samples = std::max({ last.x, last.y, last.z }) + 1.0;
  const glm::dvec3 size(GetSize(ways.GetGrid(), Finer));
  const bool finer = samples > Largest && size.x * size.y * size.z * samples <= MostOfFiner;
  return finer && !ways.IsInSurface() ? Finer : Largest;
}

// Whether the medium is in a cell that a point of the light's grid belongs to. `scale` is from
// points to samples.
bool IsNeeded(const DensityGrid& grid, const glm::dvec3& node, const glm::dvec3& scale)
{
  const glm::ivec3 size = glm::ivec3(grid.GetLast()) + 1;
  const glm::ivec3 low = glm::max(glm::ivec3(glm::floor((node - 1.0) * scale)), 0);
  const glm::ivec3 high = glm::min(glm::ivec3(glm::ceil((node + 1.0) * scale)), size - 1);
  const glm::ivec3 count = high - low + 1;
  if (static_cast<double>(count.x) * count.y * count.z > MostSearched)
  {
    return true;
  }
  for (int k = low.z; k <= high.z; ++k)
  {
    for (int j = low.y; j <= high.y; ++j)
    {
      const size_t row = (static_cast<size_t>(k) * size.y + j) * size.x;
      if (grid.GetSamples().IsAnyAboveZero(row + low.x, row + high.x + 1))
      {
        return true;
      }
    }
  }
  return false;
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

// 0 where nothing is scattered, unless `everywhere`.
std::vector<double> MeasureAll(const Ways& ways, const glm::ivec3& size, bool everywhere)
{
  const size_t count = static_cast<size_t>(size.x) * size.y * size.z;
  std::vector<double> means(count, ways.IsInSurface() ? Unknown : 0.0);
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
  return ways.IsInSurface() ? FillUnknown(means, size) : means;
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

std::vector<TestPoint> MakeTests(const Ways& ways, double sigmaT, bool everywhere)
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
  const Ways ways(medium, light);
  const double sigmaT = std::max({ medium.sigmaT.x, medium.sigmaT.y, medium.sigmaT.z });
  const std::vector<TestPoint> tests = MakeTests(ways, sigmaT, everywhere);
  const int largest = GetLargest(ways);
  LightGrid result{};
  for (int longest = Smallest; longest <= largest; longest = 2 * longest - 1)
  {
    const auto start = std::chrono::steady_clock::now();
    const glm::ivec3 size = GetSize(ways.GetGrid(), longest);
    const std::vector<double> means = MeasureAll(ways, size, everywhere);
    result.Error = 0.0;
    for (const TestPoint& test : tests)
    {
      const double mean = InterpolateTrilinearly(means, size, test.Share * glm::dvec3(size - 1));
      result.Error = std::max(result.Error, sigmaT * std::abs(mean - test.Mean) * test.Length);
    }
    result.IsFinest = result.Error <= Tolerance || 2 * longest - 1 > largest;
    // The next one has eight times as many points.
    const std::chrono::duration<double> next = 8.0 * (std::chrono::steady_clock::now() - start);
    if (result.IsFinest || next.count() > seconds)
    {
      result.Cells = glm::dvec3(size - 1);
      result.Means = Pack(means, size);
      break;
    }
    seconds -= 0.125 * next.count();
  }
  return result;
}

//------------------------------------------------------------------------------
const LightGrid& LightGrid::GetDark()
{
  static const LightGrid dark{ Pack(std::vector<double>(8, 0.0), glm::ivec3(2)), glm::dvec3(1.0),
    0.0, true };
  return dark;
}
}
