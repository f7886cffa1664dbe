// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightLightWays.h"

#include <algorithm>

namespace airlight
{
namespace
{
// Ways through less have no mean, in samples.
constexpr double LeastWay = 10.0 * LightWays::Inset;
}

//------------------------------------------------------------------------------
LightWays::LightWays(const f64::AirlightMedium& medium, const f64::AirlightLight& light)
  : Medium(medium)
  , Grid(*medium.grid)
  , Light(light.position)
  , Directional(f64::airlightIsDirectional(light))
  , IsSurface(medium.region.kind == AIRLIGHT_REGION_SURFACE)
{
}

//------------------------------------------------------------------------------
glm::dvec2 LightWays::Measure(const glm::dvec3& samples) const
{
  const glm::dvec3 inside = glm::clamp(
    samples, glm::dvec3(Inset), glm::max(this->Grid.GetLast() - Inset, glm::dvec3(Inset)));
  const glm::dvec3 point = this->Grid.ToWorld(inside);
  glm::dvec3 way = this->Light;
  double far = AIRLIGHT_FAR;
  if (!this->Directional)
  {
    way = this->Light - point;
    far = std::max(glm::length(way), 1e-300);
    way /= far;
  }
  glm::dvec2 range = f64::airlightRegionRange(this->Medium.region, point, way, far);
  range = this->Grid.GetRange(point, way, range.x, range.y);
  range.y = std::max(range.x, range.y);
  const double length = range.y - range.x;
  const glm::dvec3 entry = point + range.x * way;
  const glm::dvec2 sums(
    f64::airlightGridDepthInRegion(this->Medium, this->IsSurface, point, way, range.x, range.y),
    this->IsSurface ? f64::airlightSurfaceSums(this->Medium, entry, way, length, 0.0).x : length);
  const bool passes = sums.y * glm::length(this->Grid.GetAxes() * way) > LeastWay;
  return { passes ? sums.x / sums.y : this->GetMeanAt(point), sums.y };
}

//------------------------------------------------------------------------------
void LightWays::MeasureRay(const glm::dvec3& a, const glm::dvec3& b, int count,
  const std::function<void(int, double)>& keep) const
{
  const glm::dvec3 origin = this->Grid.ToWorld(a);
  const glm::dvec3 way = this->Grid.ToWorld(b) - origin;
  const double length = glm::length(way);
  const glm::dvec3 direction = way / length;
  glm::dvec2 range = f64::airlightRegionRange(this->Medium.region, origin, direction, length);
  range = this->Grid.GetRange(origin, direction, range.x, range.y);
  const bool hits = range.x < range.y;
  const double samples = glm::length(b - a) / length;
  glm::dvec2 sums(0.0);
  double from = range.x;
  for (int k = 0; k < count; ++k)
  {
    const double t = length * k / (count - 1.0);
    if (hits && from < range.y)
    {
      const double to = glm::clamp(t, range.x, range.y);
      sums += glm::dvec2(this->Grid.Integrate(origin, direction, from, to), to - from);
      from = to;
    }
    const bool passes = sums.y * samples > LeastWay;
    keep(k, passes ? sums.x / sums.y : this->GetMeanAt(origin + (hits ? from : t) * direction));
  }
}

//------------------------------------------------------------------------------
bool LightWays::Scatters(const glm::dvec3& samples) const
{
  return this->Grid.GetDensityAt(samples) > 0.0 && this->Holds(this->Grid.ToWorld(samples));
}

//------------------------------------------------------------------------------
// Of a way that begins there and is too short to have a mean.
double LightWays::GetMeanAt(const glm::dvec3& point) const
{
  return this->IsSurface && !this->Holds(point)
    ? Unknown
    : this->Grid.GetDensityAt(this->Grid.ToSamples(point));
}

//------------------------------------------------------------------------------
// Whether the region does.
bool LightWays::Holds(const glm::dvec3& point) const
{
  const glm::dvec3 up(0.0, 0.0, 1.0);
  return f64::airlightPathAt(this->Medium, this->IsSurface, point, up, 0.0, 0.0, false).z > 0.5;
}
}
