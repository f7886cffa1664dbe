// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The expected airlight of any light in any one medium: quadrature of the integrand of single
 * scattering as physics.md states it,
 * density sigmaS p(cosTheta) I/(a + b r + c r^2) spot exp(-depths). Lengths, depths and phase
 * functions (AirlightTestPhase.h) are the tests' own; of the library they use the properties of
 * medium and light only.
 */

#ifndef AirlightTestMatrixReference_h
#define AirlightTestMatrixReference_h

#include "AirlightTestPhase.h"
#include "AirlightTestQuadrature.h"
#include "AirlightTestSurfaces.h"

#include "vtkLight.h"
#include "vtkParticipatingMedium.h"

#include <glm/glm.hpp>

#include <limits>

namespace airlight_test
{
class MatrixReference
{
public:
  MatrixReference(vtkParticipatingMedium* medium, vtkLight* light)
    : Medium(medium)
    , Phase(medium)
    , IsSun(!light->GetPositional())
    , IsSpot(light->GetPositional() && light->GetConeAngle() < 90.0)
    , Exponent(light->GetExponent())
    , CosCone(std::cos(light->GetConeAngle() * Pi / 180.0))
    , Position(Vector(light->GetPosition()))
    , Attenuation(Vector(light->GetAttenuationValues()))
    , Strength(Pi * light->GetIntensity() * Vector(light->GetDiffuseColor()))
    , Axis(glm::normalize(Vector(light->GetFocalPoint()) - Position))
    , Up(Vector(medium->GetUp()))
    , HasBoxes(medium->GetRegion() == vtkParticipatingMedium::BOX ||
        medium->GetRegion() == vtkParticipatingMedium::SURFACE)
  {
    Box bounds;
    medium->GetBounds(bounds.data());
    this->Boxes = { bounds };
  }

  // A surface's inside: where an odd number of these boxes holds a point. Else it is the medium's
  // bounds.
  void SetBoxes(const std::vector<Box>& boxes) { this->Boxes = boxes; }

  bool IsInside(const glm::dvec3& p) const
  {
    if (this->HasBoxes)
    {
      bool inside = false;
      for (const Box& b : this->Boxes)
      {
        inside ^= p.x > b[0] && p.x < b[1] && p.y > b[2] && p.y < b[3] && p.z > b[4] && p.z < b[5];
      }
      return inside;
    }
    if (this->Medium->GetRegion() == vtkParticipatingMedium::CYLINDER)
    {
      const glm::dvec3 w = p - Vector(this->Medium->GetCenter());
      const glm::dvec3 axis = Vector(this->Medium->GetAxis());
      return std::abs(glm::dot(w, axis)) < 0.5 * this->Medium->GetHeight() &&
        glm::length(glm::cross(w, axis)) < this->Medium->GetRadius();
    }
    return this->Medium->GetRegion() != vtkParticipatingMedium::SPHERE ||
      glm::distance(p, Vector(this->Medium->GetCenter())) < this->Medium->GetRadius();
  }

  // Airlight in one channel on [t0, t1]; `direction` of length 1.
  double Airlight(
    int channel, const glm::dvec3& origin, const glm::dvec3& direction, double t0, double t1) const
  {
    const double sigmaT = this->Medium->GetExtinction()[channel];
    const bool uniform = this->Medium->GetDensity() == vtkParticipatingMedium::UNIFORM;
    // Beyond this e^-100 is left in uniform media; in others rays rise 100 scale heights.
    const double end = std::min(t1, uniform ? 40.0 + 100.0 / sigmaT : 4000.0);
    std::vector<double> cuts = { t0, end };
    this->AddCuts(origin, direction, cuts);
    this->AddConeCuts(origin, direction, cuts);
    this->AddSunCuts(origin, direction, cuts);
    std::sort(cuts.begin(), cuts.end());
    const double tL = this->IsSun ? t0 : glm::dot(this->Position - origin, direction);
    const double h =
      this->IsSun ? 1.0 : glm::length(glm::cross(this->Position - origin, direction));
    const auto integrand = [&](double x) {
      return this->Integrand(sigmaT, origin, direction, tL + x);
    };
    double sum = 0.0;
    for (size_t i = 1; i < cuts.size(); ++i)
    {
      const double a = std::max(cuts[i - 1], t0);
      const double b = std::min(cuts[i], end);
      const glm::dvec3 middle = origin + 0.5 * (a + b) * direction;
      if (b > a && this->IsInside(middle) && this->IsInCone(middle))
      {
        // Dense media let in light only near their surface: smaller panels towards both ends.
        std::vector<long double> ends = PeakPanels(a - tL, b - tL, std::max(h, 1e-9));
        for (double part = 0.1; part > 1e-9; part *= 0.1)
        {
          ends.push_back(a - tL + part * (b - a));
          ends.push_back(b - tL - part * (b - a));
        }
        // And where a table of the phase function has its rows: cosTheta = -x/r.
        for (const long double angle : this->Phase.GetKinks())
        {
          ends.push_back(std::clamp<long double>(-h / std::tan(angle), a - tL, b - tL));
        }
        std::sort(ends.begin(), ends.end());
        sum += Integrate(integrand, ends, 1e-12);
      }
    }
    return this->Strength[channel] * this->Medium->GetScattering()[channel] * sum;
  }

private:
  static glm::dvec3 Vector(const double* v) { return { v[0], v[1], v[2] }; }

  bool IsInCone(const glm::dvec3& p) const
  {
    const glm::dvec3 way = p - this->Position;
    return !this->IsSpot || glm::dot(way, this->Axis) > this->CosCone * glm::length(way);
  }

  // The roots of a t^2 + 2 b t + c.
  static void AddRoots(double a, double b, double c, std::vector<double>& cuts)
  {
    const double discriminant = b * b - a * c;
    if (discriminant > 0.0)
    {
      const double q = -(b + std::copysign(std::sqrt(discriminant), b));
      cuts.push_back(q / a);
      cuts.push_back(c / q);
    }
  }

  // Where a line meets the region's surface.
  void AddCuts(const glm::dvec3& o, const glm::dvec3& d, std::vector<double>& cuts) const
  {
    if (this->HasBoxes)
    {
      for (const Box& box : this->Boxes)
      {
        for (int i = 0; i < 6; ++i)
        {
          cuts.push_back((box[i] - o[i / 2]) / d[i / 2]);
        }
      }
    }
    else if (this->Medium->GetRegion() == vtkParticipatingMedium::SPHERE)
    {
      const glm::dvec3 w = o - Vector(this->Medium->GetCenter());
      const double radius = this->Medium->GetRadius();
      AddRoots(1.0, glm::dot(w, d), glm::dot(w, w) - radius * radius, cuts);
    }
    else if (this->Medium->GetRegion() == vtkParticipatingMedium::CYLINDER)
    {
      this->AddCylinderCuts(o - Vector(this->Medium->GetCenter()), d, cuts);
    }
  }

  // The ends' planes, and |axis x (w + t d)| = radius; w from the centre.
  void AddCylinderCuts(const glm::dvec3& w, const glm::dvec3& d, std::vector<double>& cuts) const
  {
    const glm::dvec3 axis = Vector(this->Medium->GetAxis());
    const double radius = this->Medium->GetRadius();
    for (const double side : { -0.5, 0.5 })
    {
      const double t = (side * this->Medium->GetHeight() - glm::dot(w, axis)) / glm::dot(d, axis);
      cuts.push_back(std::isfinite(t) ? t : 0.0);
    }
    const glm::dvec3 a = glm::cross(axis, d);
    const glm::dvec3 b = glm::cross(axis, w);
    AddRoots(glm::dot(a, a), glm::dot(a, b), glm::dot(b, b) - radius * radius, cuts);
  }

  // (axis.w)^2 = cos^2 w^2 with w = o - light + t d.
  void AddConeCuts(const glm::dvec3& o, const glm::dvec3& d, std::vector<double>& cuts) const
  {
    if (this->IsSpot)
    {
      const glm::dvec3 w = o - this->Position;
      const double c2 = this->CosCone * this->CosCone;
      const double aw = glm::dot(this->Axis, w);
      const double ad = glm::dot(this->Axis, d);
      AddRoots(ad * ad - c2, aw * ad - c2 * glm::dot(w, d), aw * aw - c2 * glm::dot(w, w), cuts);
    }
  }

  // Where the way to the sun leaves a box through an edge: there the integrand has a kink. On the
  // way from o + t d, along l, the faces ahead are (face - o - t d)/l away.
  void AddSunCuts(const glm::dvec3& o, const glm::dvec3& d, std::vector<double>& cuts) const
  {
    if (!this->IsSun || !this->HasBoxes)
    {
      return;
    }
    const Box& bounds = this->Boxes.front();
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const double li = -this->Axis[i];
      const double lj = -this->Axis[j];
      const double fi = bounds[2 * i + (li > 0.0 ? 1 : 0)] - o[i];
      const double fj = bounds[2 * j + (lj > 0.0 ? 1 : 0)] - o[j];
      cuts.push_back((fi * lj - fj * li) / (d[i] * lj - d[j] * li));
    }
  }

  // Density at p; and its integral over [0, l] from p, all of it inside: of exp(-k s) with k the
  // slope of the way in scale heights.
  double Density(const glm::dvec3& p) const
  {
    return this->Medium->GetDensity() == vtkParticipatingMedium::UNIFORM
      ? 1.0
      : std::exp((this->Medium->GetReferenceHeight() - glm::dot(this->Up, p)) /
          this->Medium->GetScaleHeight());
  }

  double InsideDepth(const glm::dvec3& p, const glm::dvec3& d, double l) const
  {
    if (this->Medium->GetDensity() == vtkParticipatingMedium::UNIFORM)
    {
      return l;
    }
    const double k = glm::dot(this->Up, d) / this->Medium->GetScaleHeight();
    return this->Density(p) * (std::abs(k * l) < 1e-14 ? l : -std::expm1(-k * l) / k);
  }

  // The same where a part of the way is inside.
  double Depth(const glm::dvec3& o, const glm::dvec3& d, double l) const
  {
    if (this->Medium->GetRegion() == vtkParticipatingMedium::UNBOUNDED)
    {
      return this->InsideDepth(o, d, l);
    }
    std::vector<double> cuts = { 0.0, l };
    this->AddCuts(o, d, cuts);
    std::sort(cuts.begin(), cuts.end());
    double sum = 0.0;
    for (size_t i = 1; i < cuts.size(); ++i)
    {
      const double a = std::max(cuts[i - 1], 0.0);
      const double b = std::min(cuts[i], l);
      if (b > a && this->IsInside(o + 0.5 * (a + b) * d))
      {
        sum += this->InsideDepth(o + a * d, d, b - a);
      }
    }
    return sum;
  }

  // On the way to the sun: none in an unbounded uniform medium, which would swallow it; infinite
  // from below in an unbounded medium that thins out upwards.
  double SunDepth(const glm::dvec3& p) const
  {
    if (this->Medium->GetRegion() != vtkParticipatingMedium::UNBOUNDED)
    {
      return this->Depth(p, -this->Axis, 1e3);
    }
    if (this->Medium->GetDensity() == vtkParticipatingMedium::UNIFORM)
    {
      return 0.0;
    }
    const double mu = -glm::dot(this->Up, this->Axis);
    return mu > 0.0 ? this->Density(p) * this->Medium->GetScaleHeight() / mu
                    : std::numeric_limits<double>::infinity();
  }

  double Integrand(
    double sigmaT, const glm::dvec3& origin, const glm::dvec3& direction, double t) const
  {
    const glm::dvec3 point = origin + t * direction;
    const glm::dvec3 way = point - this->Position;
    const double r = glm::length(way);
    const glm::dvec3 travels = this->IsSun ? this->Axis : way / r; // of the light
    const double cosTheta = -glm::dot(travels, direction);
    double depth = this->Depth(origin, direction, t);
    depth += this->IsSun ? this->SunDepth(point) : this->Depth(point, -travels, r);
    if (!(sigmaT * depth < 700.0))
    {
      return 0.0;
    }
    const double spot = this->IsSpot && this->Exponent > 0.0
      ? std::pow(std::max(glm::dot(travels, this->Axis), 0.0), this->Exponent)
      : 1.0;
    const double fall = this->IsSun ? 1.0 : glm::dot(this->Attenuation, glm::dvec3(1.0, r, r * r));
    return this->Density(point) * this->Phase(1.0 - cosTheta, 1.0 + cosTheta) * spot / fall *
      std::exp(-sigmaT * depth);
  }

  vtkParticipatingMedium* Medium;
  ReferencePhase Phase;
  bool IsSun;
  bool IsSpot;
  double Exponent;
  double CosCone;
  glm::dvec3 Position;
  glm::dvec3 Attenuation;
  glm::dvec3 Strength;
  glm::dvec3 Axis; // from the position to the focal point
  glm::dvec3 Up;
  bool HasBoxes;
  std::vector<Box> Boxes;
};
}

#endif
