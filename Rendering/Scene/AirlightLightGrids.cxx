// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightLightGrids.h"

#include "Integration/AirlightMembers.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace airlight
{
namespace
{
constexpr int MostAge = 4;

bool IsNear(const glm::dvec3& a, const glm::dvec3& b, double near)
{
  return glm::length(a - b) <= near;
}

// Whether regions are the same but for positions, which may be `near` each other, as a moving eye
// rounds them.
class RegionComparison
{
public:
  explicit RegionComparison(double near)
    : Near(near)
  {
  }
  bool IsSame() const { return this->Same; }

  void operator()(const Member& member, const glm::dvec3& a, const glm::dvec3& b)
  {
    this->Same = this->Same && IsNear(a, b, member.IsPosition ? this->Near : 0.0);
  }
  template <typename Number>
  void operator()(const Member&, Number a, Number b)
  {
    this->Same = this->Same && a == b;
  }

private:
  double Near;
  bool Same = true;
};

bool IsSame(const f64::AirlightRegion& a, const f64::AirlightRegion& b, double near)
{
  RegionComparison comparison(near);
  VisitRegion(comparison, a, b);
  return comparison.IsSame();
}

f64::AirlightRegion Translate(f64::AirlightRegion region, const glm::dvec3& way)
{
  VisitRegion(
    [&way](const Member& member, auto& value) {
      if constexpr (std::is_same_v<decltype(value), glm::dvec3&>)
      {
        value += member.IsPosition ? way : glm::dvec3(0.0);
      }
    },
    region);
  return region;
}
}

//------------------------------------------------------------------------------
const LightGrid& LightGrids::GetLight(const f64::AirlightMedium& medium,
  const std::shared_ptr<const SurfaceTree>& surface, const f64::AirlightLight& light,
  const glm::dvec3& eye, bool everywhere, double seconds)
{
  const bool directional = f64::airlightIsDirectional(light);
  // Back in the world, where a moving eye rounds a little.
  f64::AirlightMedium there = medium;
  there.gridOrigin = glm::dvec3(0.0);
  there.region = Translate(medium.region, eye);
  f64::AirlightLight sceneLight = light;
  sceneLight.position += directional ? glm::dvec3(0.0) : eye;
  const double near =
    1e-9 * (glm::length(eye) + glm::length(there.region.boxMax - there.region.boxMin));
  for (const std::unique_ptr<Entry>& entry : this->Entries)
  {
    if (entry->Surface == surface && entry->Directional == directional &&
      IsNear(entry->Position, sceneLight.position, near) && entry->Everywhere == everywhere &&
      entry->SigmaT == medium.sigmaT && IsSame(entry->Region, there.region, near))
    {
      entry->Age = 0;
      if (!entry->Values.IsFinest && std::isinf(seconds))
      {
        entry->Values = LightGrid::Build(there, sceneLight, everywhere, seconds);
      }
      return entry->Values;
    }
  }
  this->Entries.push_back(
    std::make_unique<Entry>(Entry{ surface, there.region, medium.sigmaT, sceneLight.position,
      directional, everywhere, 0, LightGrid::Build(there, sceneLight, everywhere, seconds) }));
  return this->Entries.back()->Values;
}

//------------------------------------------------------------------------------
bool LightGrids::Forget()
{
  this->Entries.erase(std::remove_if(this->Entries.begin(), this->Entries.end(),
                        [](const std::unique_ptr<Entry>& entry) { return ++entry->Age > MostAge; }),
    this->Entries.end());
  return this->Entries.empty();
}
}
