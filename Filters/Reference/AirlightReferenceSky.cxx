// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/AirlightReferenceSky.h"

#include "vtkMath.h"
#include "vtkParticipatingMedium.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
constexpr double Pi = vtkMath::Pi();

// Panels of scattering angles, of 16 nodes each: finer towards both ends.
constexpr double FinestPanel = 1e-3;
constexpr double WidestPanel = 0.1;

// Directions on a ring: more than harmonics to order 2 need.
constexpr int RingDirections = 8;
}

//------------------------------------------------------------------------------
ReferenceSky::ReferenceSky(vtkParticipatingMedium* medium)
{
  medium->GetAmbientRadiance(&this->Even.x);
  medium->GetSkyRadiance(&this->Above.x);
  medium->GetGroundRadiance(&this->Below.x);
  medium->GetUp(&this->Up.x);
  medium->GetSkyHarmonics(&this->Harmonics[0].x);
  double from = 0.0;
  while (from < Pi)
  {
    const double rest = Pi - from;
    const double width = std::clamp(std::min(from, 0.5 * rest), FinestPanel, WidestPanel);
    const double half = 0.5 * (rest < 1.5 * width ? rest : width);
    for (int k = 0; k < 16; ++k)
    {
      const glm::dvec2 node = f64::airlightGaussNode(k / 2);
      const double theta = from + half * (k % 2 == 0 ? 1.0 + node.x : 1.0 - node.x);
      const double cosine = std::cos(theta);
      const double sine = std::sin(theta);
      this->Rings.push_back(
        { cosine, sine, 2.0 * Pi * half * node.y * sine * medium->EvaluatePhaseFunction(cosine) });
    }
    from += 2.0 * half;
  }
}

//------------------------------------------------------------------------------
// Of a ring about a direction whose cosine to the vertical is `rise`.
double ReferenceSky::GetShareAbove(const Ring& ring, double rise) const
{
  const double middle = ring.Cosine * rise;
  const double reach = ring.Sine * std::sqrt(std::max(1.0 - rise * rise, 0.0));
  if (std::abs(middle) >= reach)
  {
    return middle > 0.0 ? 1.0 : 0.0;
  }
  return 0.5 + std::asin(middle / reach) / Pi;
}

//------------------------------------------------------------------------------
glm::dvec3 ReferenceSky::GetRadiance(const glm::dvec3& from) const
{
  const double x = from.x;
  const double y = from.y;
  const double z = from.z;
  const double first = std::sqrt(3.0 / Pi) / 2.0;
  const double second = std::sqrt(15.0 / Pi) / 2.0;
  const std::array<glm::dvec3, 9>& c = this->Harmonics;
  return std::sqrt(1.0 / Pi) / 2.0 * c[0] + first * (y * c[1] + z * c[2] + x * c[3]) +
    second * (x * y * c[4] + y * z * c[5] + x * z * c[7] + 0.5 * (x * x - y * y) * c[8]) +
    std::sqrt(5.0 / Pi) / 4.0 * (3.0 * z * z - 1.0) * c[6];
}

//------------------------------------------------------------------------------
glm::dvec3 ReferenceSky::GetAmbient(const glm::dvec3& direction) const
{
  const glm::dvec3 axis =
    std::abs(direction.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 side = glm::normalize(glm::cross(direction, axis));
  const glm::dvec3 other = glm::cross(direction, side);
  const double rise = glm::dot(direction, this->Up);
  glm::dvec3 sum(0.0);
  for (const Ring& ring : this->Rings)
  {
    glm::dvec3 mean(0.0);
    for (int k = 0; k < RingDirections; ++k)
    {
      const double angle = 2.0 * Pi * k / RingDirections;
      mean += this->GetRadiance(ring.Cosine * direction +
                ring.Sine * (std::cos(angle) * side + std::sin(angle) * other)) /
        static_cast<double>(RingDirections);
    }
    const double above = this->GetShareAbove(ring, rise);
    sum += ring.Weight * (mean + above * this->Above + (1.0 - above) * this->Below);
  }
  return glm::max(this->Even + sum, glm::dvec3(0.0));
}

//------------------------------------------------------------------------------
f64::AirlightMedia WithSkies(const f64::AirlightMedia& media,
  const std::vector<ReferenceSky>& skies, const glm::dvec3& direction)
{
  f64::AirlightMedia result = media;
  for (int i = 0; i < media.count; ++i)
  {
    f64::AirlightMedium& medium = result.item[i];
    if (medium.sky.on != 0)
    {
      medium.ambient = skies[i].GetAmbient(direction);
      medium.sky.on = 0;
    }
  }
  return result;
}
}
