// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The expected irradiance on a surface from scattered light, by brute force: a product of
 * Gauss-Legendre panels over the hemisphere, with vtkAirlight::Inscatter() for each direction,
 * which its own tests verify. Gamma is counted from the direction to the light, where the airlight
 * of a point light peaks as 1/sin(gamma), and phi around it from the normal.
 */

#ifndef AirlightTestIrradiance_h
#define AirlightTestIrradiance_h

#include "AirlightTestQuadrature.h"

#include "vtkAirlight.h"
#include "vtkLight.h"
#include "vtkParticipatingMedium.h"

#include <glm/glm.hpp>

#include <algorithm>
#include <vector>

namespace airlight_test
{
class Hemisphere
{
public:
  Hemisphere(vtkParticipatingMedium* medium, vtkLight* light, const glm::dvec3& point,
    const glm::dvec3& normal)
    : Medium(medium)
    , Light(light)
    , Point(point)
    , Normal(normal)
  {
    glm::dvec3 position;
    glm::dvec3 focus;
    light->GetPosition(&position.x);
    light->GetFocalPoint(&focus.x);
    this->Axis = glm::normalize(position - (light->GetPositional() ? point : focus));
    this->Cosine = glm::dot(normal, this->Axis);
    glm::dvec3 side = normal - this->Cosine * this->Axis;
    this->Sine = glm::length(side);
    if (this->Sine < 1e-6)
    {
      side = glm::cross(this->Axis,
        std::abs(this->Axis.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0));
    }
    this->Across = glm::normalize(side);
    this->Third = glm::cross(this->Axis, this->Across);
    this->FindSpot(glm::normalize(focus - position));
    this->FindRegion();
  }

  // `fineness` panels for each piece between the places where the integrand has kinks.
  glm::dvec3 Irradiance(int fineness) const
  {
    // Rings cross the horizon between these two.
    const double c = std::abs(0.5 * Pi - std::acos(glm::clamp(this->Cosine, -1.0, 1.0)));
    std::vector<double> ends = { 0.0, c, Pi - c, this->Largest };
    for (double gamma = 1e-4; gamma < this->Largest; gamma *= 4.0)
    {
      ends.push_back(gamma);
    }
    return Sum(ends, this->Largest, fineness,
      [&](double gamma) { return std::sin(gamma) * this->Ring(gamma, fineness); });
  }

private:
  // Composite quadrature between the ends, up to `last`.
  template <typename F>
  static glm::dvec3 Sum(std::vector<double> ends, double last, int fineness, const F& f)
  {
    static const GaussRule rule = MakeGaussRule();
    std::sort(ends.begin(), ends.end());
    glm::dvec3 sum(0.0);
    for (size_t i = 1; i < ends.size() && ends[i - 1] < last; ++i)
    {
      const double reach = 0.5 * (std::min(ends[i], last) - ends[i - 1]) / fineness;
      for (int k = 0; k < fineness * GaussCount && reach > 0.0; ++k)
      {
        const double middle = ends[i - 1] + (2 * (k / GaussCount) + 1) * reach;
        sum += reach * rule.W[k % GaussCount] * f(middle + reach * rule.X[k % GaussCount]);
      }
    }
    return sum;
  }

  glm::dvec3 Ring(double gamma, int fineness) const
  {
    // n.w = a + b cos(phi) > 0 for |phi| < horizon.
    const double a = std::cos(gamma) * this->Cosine;
    const double b = std::sin(gamma) * this->Sine;
    const double horizon = a >= b ? Pi : (a <= -b ? 0.0 : std::acos(-a / b));
    std::vector<double> ends = { -horizon, 0.0, horizon };
    for (int turn = -1; turn <= 1; ++turn)
    {
      for (const double side : { -this->SpotWidth, this->SpotWidth })
      {
        const double edge = this->SpotMiddle + side + 2.0 * Pi * turn;
        ends.push_back(glm::clamp(edge, -horizon, horizon));
      }
    }
    return Sum(ends, horizon, fineness, [&](double phi) {
      const glm::dvec3 w = std::cos(gamma) * this->Axis +
        std::sin(gamma) * (std::cos(phi) * this->Across + std::sin(phi) * this->Third);
      glm::dvec3 rgb;
      vtkAirlight::Inscatter(this->Medium, this->Light, &this->Point.x, &w.x, 0.0, 1e18, &rgb.x);
      return rgb * std::max(glm::dot(this->Normal, w), 0.0);
    });
  }

  // The azimuths between which rays meet a spot's cone: the half-plane of azimuth phi holds light
  // directions at an angle to the spot's axis of at least the one whose cosine is
  // sqrt(along^2 + (across cos(phi - middle))^2).
  void FindSpot(const glm::dvec3& axis)
  {
    const double cone = std::cos(this->Light->GetConeAngle() * Pi / 180.0);
    const double along = glm::dot(axis, this->Axis);
    if (this->Light->GetPositional() && this->Light->GetConeAngle() < 90.0 &&
      std::abs(along) < cone)
    {
      const double x = glm::dot(axis, this->Across);
      const double y = glm::dot(axis, this->Third);
      this->SpotMiddle = std::atan2(y, x);
      this->SpotWidth =
        std::acos(std::min(std::sqrt((cone * cone - along * along) / (x * x + y * y)), 1.0));
    }
  }

  // From outside, the region lies within the cone around a sphere that holds it.
  void FindRegion()
  {
    const double* b = this->Medium->GetBounds();
    glm::dvec3 centre(0.5 * (b[0] + b[1]), 0.5 * (b[2] + b[3]), 0.5 * (b[4] + b[5]));
    double radius = 0.5 * glm::length(glm::dvec3(b[1] - b[0], b[3] - b[2], b[5] - b[4]));
    if (this->Medium->GetRegion() == vtkParticipatingMedium::SPHERE)
    {
      this->Medium->GetCenter(&centre.x);
      radius = this->Medium->GetRadius();
    }
    const double distance = glm::distance(centre, this->Point);
    if (this->Medium->GetRegion() != vtkParticipatingMedium::UNBOUNDED && distance > radius)
    {
      const double angle =
        std::acos(glm::clamp(glm::dot(this->Axis, (centre - this->Point) / distance), -1.0, 1.0));
      this->Largest = std::min(Pi, angle + std::asin(radius / distance));
    }
  }

  vtkParticipatingMedium* Medium;
  vtkLight* Light;
  glm::dvec3 Point;
  glm::dvec3 Normal;
  glm::dvec3 Axis;
  glm::dvec3 Across;
  glm::dvec3 Third;
  double Cosine;
  double Sine;
  double SpotMiddle = 0.0;
  double SpotWidth = Pi;
  double Largest = Pi; // gamma
};
}

#endif
