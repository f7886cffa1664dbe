// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Emission/AirlightEmissionClusters.h"

#include "Density/AirlightDensityGrid.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
// Parts along each side of the medium's box.
constexpr int Parts = 32;
constexpr int MostRounds = 50;

// Sums of weight, place and squared place from which a cluster is made.
struct Sums
{
  double Weight = 0.0;
  glm::dvec3 Place{ 0.0 };
  double Square = 0.0;
  glm::dvec3 Power{ 0.0 };

  void Add(const EmissionCluster& part)
  {
    const double square = glm::dot(part.Centre, part.Centre) + 0.6 * part.Radius * part.Radius;
    this->Weight += part.Weight;
    this->Place += part.Weight * part.Centre;
    this->Square += part.Weight * square;
    this->Power += part.Power;
  }

  EmissionCluster Get() const
  {
    if (!(this->Weight > 0.0))
    {
      return {};
    }
    const glm::dvec3 centre = this->Place / this->Weight;
    const double variance = this->Square / this->Weight - glm::dot(centre, centre);
    return { centre, this->Weight, std::sqrt(std::max(variance, 0.0) / 0.6), this->Power };
  }
};

double GetSum(const glm::dvec3& v) { return v.x + v.y + v.z; }

// By the samples of the image, each of which stands for the cell round it.
std::vector<EmissionCluster> SampleImage(const f64::AirlightMedium& medium)
{
  const DensityGrid& grid = *medium.grid;
  const glm::ivec3& size = grid.GetSize();
  const double cell = 1.0 / std::abs(glm::determinant(grid.GetAxes()));
  std::vector<Sums> sums(static_cast<size_t>(Parts) * Parts * Parts);
  // Places are relative to the image's middle, far away from which they would lose digits.
  const glm::dvec3 middle = grid.ToWorld(0.5 * grid.GetLast());
  for (int k = 0; k < size.z; ++k)
  {
    for (int j = 0; j < size.y; ++j)
    {
      for (int i = 0; i < size.x; ++i)
      {
        const glm::dvec3 sample(i, j, k);
        const glm::dvec3 place = grid.ToWorld(sample);
        const double density = grid.GetDensityAt(sample);
        if (density > 0.0 && f64::airlightHolds(medium.region, place - medium.gridOrigin))
        {
          const glm::dvec3 ends = glm::dvec3(glm::equal(sample, glm::dvec3(0.0))) +
            glm::dvec3(glm::equal(sample, grid.GetLast()));
          const glm::dvec3 share = 1.0 - 0.5 * ends;
          const glm::ivec3 part =
            glm::min(glm::ivec3(sample / grid.GetLast() * double(Parts)), glm::ivec3(Parts - 1));
          const double amount = density * cell * share.x * share.y * share.z;
          const glm::dvec3 power =
            amount * medium.emission * (medium.glow ? medium.glow->GetAt(sample) : glm::dvec3(1.0));
          sums[(static_cast<size_t>(part.z) * Parts + part.y) * Parts + part.x].Add(
            { place - middle, GetSum(power) / GetSum(medium.emission), 0.0, power });
        }
      }
    }
  }
  std::vector<EmissionCluster> parts;
  for (const Sums& sum : sums)
  {
    if (sum.Weight > 0.0)
    {
      parts.push_back(sum.Get());
      parts.back().Centre += middle;
    }
  }
  return parts;
}

// The box that holds the region.
void GetBox(const f64::AirlightRegion& region, glm::dvec3& low, glm::dvec3& high)
{
  low = region.boxMin;
  high = region.boxMax;
  if (region.kind != AIRLIGHT_REGION_BOX && region.kind != AIRLIGHT_REGION_SURFACE)
  {
    const double reach = std::hypot(region.radius, region.halfHeight);
    low = region.centre - reach;
    high = region.centre + reach;
  }
}

std::vector<EmissionCluster> SampleBox(const f64::AirlightMedium& medium)
{
  glm::dvec3 low;
  glm::dvec3 high;
  GetBox(medium.region, low, high);
  const glm::dvec3 step = (high - low) / static_cast<double>(Parts);
  std::vector<EmissionCluster> parts;
  for (int n = 0; n < Parts * Parts * Parts; ++n)
  {
    const glm::dvec3 cell(n % Parts, n / Parts % Parts, n / (Parts * Parts));
    const glm::dvec3 place = low + (cell + 0.5) * step;
    const double density =
      f64::airlightHolds(medium.region, place) ? f64::airlightDensity(medium, place) : 0.0;
    if (density > 0.0)
    {
      const double amount = density * step.x * step.y * step.z;
      parts.push_back({ place, amount, 0.0, amount * medium.emission });
    }
  }
  return parts;
}

double GetDistance2(const glm::dvec3& a, const glm::dvec3& b) { return glm::dot(a - b, a - b); }

size_t FindNearest(const std::vector<glm::dvec3>& centres, const glm::dvec3& place)
{
  size_t nearest = 0;
  for (size_t i = 1; i < centres.size(); ++i)
  {
    const bool nearer = GetDistance2(centres[i], place) < GetDistance2(centres[nearest], place);
    nearest = nearer ? i : nearest;
  }
  return nearest;
}

// The heaviest part, then again and again the one that is heavy and far from those chosen.
void AddCentres(
  const std::vector<EmissionCluster>& parts, size_t count, std::vector<glm::dvec3>& centres)
{
  while (centres.size() < std::min(count, parts.size()))
  {
    const EmissionCluster* best = nullptr;
    double most = 0.0;
    for (const EmissionCluster& part : parts)
    {
      const double apart = centres.empty()
        ? 1.0
        : GetDistance2(centres[FindNearest(centres, part.Centre)], part.Centre);
      if (part.Weight * apart > most)
      {
        most = part.Weight * apart;
        best = &part;
      }
    }
    if (!best)
    {
      return;
    }
    centres.push_back(best->Centre);
  }
}
}

//------------------------------------------------------------------------------
std::vector<EmissionCluster> SampleEmission(const f64::AirlightMedium& medium)
{
  return medium.density == AIRLIGHT_DENSITY_GRID ? SampleImage(medium) : SampleBox(medium);
}

//------------------------------------------------------------------------------
std::vector<EmissionCluster> FindClusters(
  const std::vector<EmissionCluster>& parts, int count, const std::vector<glm::dvec3>& centres)
{
  std::vector<glm::dvec3> places = centres;
  places.resize(std::min<size_t>(places.size(), count));
  std::vector<EmissionCluster> clusters;
  for (int round = 0; round < MostRounds; ++round)
  {
    AddCentres(parts, static_cast<size_t>(count), places);
    std::vector<Sums> sums(places.size());
    for (const EmissionCluster& part : parts)
    {
      sums[FindNearest(places, part.Centre)].Add(part);
    }
    clusters.clear();
    std::vector<glm::dvec3> moved;
    for (const Sums& sum : sums)
    {
      if (sum.Weight > 0.0)
      {
        clusters.push_back(sum.Get());
        moved.push_back(clusters.back().Centre);
      }
    }
    if (moved == places)
    {
      break;
    }
    places = moved;
  }
  return clusters;
}
}
