// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a lamp with a photometric table makes of a ray and of a surface, by hand: the table as
 * AirlightTestPhotometry.h looks it up, fog in a box, a sphere or everywhere, quadrature cut where
 * the ray passes from one cell of the table to the next.
 */

#ifndef AirlightTestGoniometry_h
#define AirlightTestGoniometry_h

#include "AirlightTestPhotometry.h"
#include "AirlightTestQuadrature.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace airlight_test
{
// A photometric file without TILT=INCLUDE as a table.
LampTable ReadTable(const std::string& file);

//------------------------------------------------------------------------------
// Fog in the part of a ray inside a region.
struct TestFog
{
  enum RegionType
  {
    EVERYWHERE,
    BOX,
    SPHERE
  };

  // Where a line is inside, on [t0, t1]; an empty interval where it is not.
  glm::dvec2 Clip(const glm::dvec3& origin, const glm::dvec3& direction, double t0, double t1) const
  {
    if (this->Region == BOX)
    {
      for (int i = 0; i < 3; ++i)
      {
        const double a = (this->Low[i] - origin[i]) / direction[i];
        const double b = (this->High[i] - origin[i]) / direction[i];
        t0 = std::max(t0, std::min(a, b));
        t1 = std::min(t1, std::max(a, b));
      }
    }
    else if (this->Region == SPHERE)
    {
      const double middle = glm::dot(this->Centre - origin, direction);
      const glm::dvec3 across = origin + middle * direction - this->Centre;
      const double half2 = this->Radius * this->Radius - glm::dot(across, across);
      const double half = half2 > 0.0 ? std::sqrt(half2) : 0.0;
      t0 = std::max(t0, middle - half);
      t1 = std::min(t1, middle + half);
    }
    return { t0, std::max(t0, t1) };
  }

  // Length inside between two points.
  double Length(const glm::dvec3& a, const glm::dvec3& b) const
  {
    const double length = glm::length(b - a);
    const glm::dvec2 part = this->Clip(a, (b - a) / length, 0.0, length);
    return part.y - part.x;
  }

  int Region = EVERYWHERE;
  glm::dvec3 Low{ 0.0 };
  glm::dvec3 High{ 0.0 };
  glm::dvec3 Centre{ 0.0 };
  double Radius = 0.0;
  glm::dvec3 SigmaS{ 0.0 };
  glm::dvec3 SigmaT{ 0.0 };
  double G = 0.0; // of Henyey and Greenstein's phase function
};

//------------------------------------------------------------------------------
struct TestGoniometricLamp
{
  // Where the lamp aims and the direction to turn the table by, not yet perpendicular.
  void Aim(const glm::dvec3& direction, const glm::dvec3& up)
  {
    this->Axis = glm::normalize(direction);
    this->Up = glm::normalize(up - glm::dot(up, this->Axis) * this->Axis);
    this->Right = glm::cross(this->Axis, this->Up);
  }

  // Relative to the table's largest intensity, towards a point.
  double Share(const glm::dvec3& point) const
  {
    const glm::dvec3 d = glm::normalize(point - this->Position);
    const double a = glm::dot(d, this->Axis);
    const double u = glm::dot(d, this->Up);
    const double r = glm::dot(d, this->Right);
    double v = 0.0;
    double h = 0.0;
    if (this->Table.Type == 1)
    {
      v = std::atan2(std::hypot(u, r), a);
      h = std::atan2(-r, u);
    }
    else if (this->Table.Type == 2)
    {
      v = std::atan2(u, a);
      h = std::atan2(r, std::hypot(a, u));
    }
    else
    {
      v = std::atan2(u, std::hypot(a, r));
      h = std::atan2(r, a);
    }
    return TableValue(this->Table, v / Degree, h / Degree) / this->Largest();
  }

  double Largest() const
  {
    return *std::max_element(this->Table.Candela.begin(), this->Table.Candela.end());
  }

  // Where the line may pass from one cell of the table to another: one of the two angles is that
  // from a pole, so its lines are cones, the other one that around the pole, so that its lines are
  // planes. Cuts too many do no harm: each angle is taken with both signs and its supplement.
  std::vector<double> FindCuts(const glm::dvec3& origin, const glm::dvec3& direction) const
  {
    const bool isB = this->Table.Type == 2;
    const glm::dvec3 pole = this->Table.Type == 1 ? this->Axis : (isB ? this->Right : this->Up);
    const glm::dvec3 first = this->Table.Type == 1 ? this->Up : this->Axis;
    const glm::dvec3 second = glm::cross(pole, first);
    const double zero = this->Table.Type == 1 ? 0.0 : 90.0; // from the pole
    const glm::dvec3 from = origin - this->Position;
    // Where the ray passes the pole's axis: the angle around it turns there.
    const glm::dvec3 across = direction - glm::dot(direction, pole) * pole;
    std::vector<double> cuts = { -glm::dot(from, across) / glm::dot(across, across) };
    const double least = glm::length(from + cuts[0] * direction);
    for (double width = 1e-6 * least; width < 1e3 * least; width *= 4.0)
    {
      cuts.insert(cuts.end(), { cuts[0] - width, cuts[0] + width });
    }
    for (const double angle : isB ? this->Table.Horizontal : this->Table.Vertical)
    {
      // (x.pole)^2 = cos^2 (x.x), x = from + t direction
      const double c2 = std::pow(std::cos((zero + angle) * Degree), 2.0);
      const double d = glm::dot(direction, pole);
      const double f = glm::dot(from, pole);
      const double a = d * d - c2;
      const double b = d * f - c2 * glm::dot(from, direction);
      const double c = f * f - c2 * glm::dot(from, from);
      const double root = std::sqrt(std::max(b * b - a * c, 0.0));
      cuts.insert(cuts.end(), { (-b - root) / a, (-b + root) / a });
    }
    for (const double angle : isB ? this->Table.Vertical : this->Table.Horizontal)
    {
      for (const double sign : { -1.0, 1.0 })
      {
        const glm::dvec3 normal =
          std::sin(angle * Degree) * first - sign * std::cos(angle * Degree) * second;
        cuts.push_back(-glm::dot(from, normal) / glm::dot(direction, normal));
      }
    }
    return cuts;
  }

  LampTable Table;
  glm::dvec3 Position{ 0.0 };
  double Radius = 0.0;         // least distance to rays
  glm::dvec3 Intensity{ 0.0 }; // of the brightest direction
  glm::dvec3 Axis{ 0.0 };
  glm::dvec3 Up{ 0.0 };
  glm::dvec3 Right{ 0.0 };
};

// Airlight of one channel on [begin, end] of a ray.
double GoniometricAirlight(const TestFog& fog, const TestGoniometricLamp& lamp,
  const glm::dvec3& origin, const glm::dvec3& direction, double begin, double end, int channel);

// What a white diffuse surface at distance t sends to the eye: VTK's colour of the lamp is I/pi.
double GoniometricSurface(const TestFog& fog, const TestGoniometricLamp& lamp,
  const glm::dvec3& origin, const glm::dvec3& direction, double t, const glm::dvec3& normal,
  int channel);
}

#endif
