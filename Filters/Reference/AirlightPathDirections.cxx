// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/AirlightPathDirections.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
constexpr int Cells = 1024;
// Each cell has at least this share of an equal one: what a table rounds to 0 is met, too.
constexpr double LeastShare = 1e-4;
}

//------------------------------------------------------------------------------
glm::dvec3 TurnFrom(const glm::dvec3& axis, double cosine, double sine, double turn)
{
  const glm::dvec3 other =
    std::abs(axis.z) < 0.9 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 across = glm::normalize(glm::cross(axis, other));
  const double angle = 2.0 * vtkMath::Pi() * turn;
  return glm::normalize(
    cosine * axis + sine * (std::cos(angle) * across + std::sin(angle) * glm::cross(axis, across)));
}

//------------------------------------------------------------------------------
// The cells are narrow in both directions of the axis, where phase functions have their peaks.
PhaseDirections::PhaseDirections(const f64::AirlightPhase& phase)
{
  this->Cosines = { 1.0 };
  this->Shares = { 0.0 };
  const double node = std::sqrt(0.6); // Gauss-Legendre, three nodes
  for (int i = 1; i <= Cells; ++i)
  {
    const double x = static_cast<double>(i) / Cells;
    const double above = this->Cosines.back();
    const double below =
      i < Cells ? std::cos(vtkMath::Pi() * x * x * (3.0 - 2.0 * x)) : -1.0; // dense at both ends
    const double middle = 0.5 * (above + below);
    const double half = 0.5 * (above - below);
    const double sum = 5.0 * f64::airlightPhase(phase, middle - node * half) +
      8.0 * f64::airlightPhase(phase, middle) +
      5.0 * f64::airlightPhase(phase, middle + node * half);
    const double mean = std::max(sum / 18.0, LeastShare / (4.0 * vtkMath::Pi()));
    this->Cosines.push_back(below);
    this->Shares.push_back(this->Shares.back() + mean * (above - below));
  }
  const double all = this->Shares.back();
  for (double& share : this->Shares)
  {
    share /= all;
  }
}

//------------------------------------------------------------------------------
double PhaseDirections::SampleCosine(RandomNumbers& random) const
{
  const double share = random.Next();
  const auto next = std::upper_bound(this->Shares.begin() + 1, this->Shares.end() - 1, share);
  const auto i = next - this->Shares.begin();
  const double part = (share - this->Shares[i - 1]) / (this->Shares[i] - this->Shares[i - 1]);
  return glm::mix(this->Cosines[i - 1], this->Cosines[i], std::clamp(part, 0.0, 1.0));
}

double PhaseDirections::GetDensity(double cosine) const
{
  const auto next = std::lower_bound(this->Cosines.begin() + 1, this->Cosines.end() - 1, cosine,
    [](double border, double value) { return border > value; });
  const auto i = next - this->Cosines.begin();
  return (this->Shares[i] - this->Shares[i - 1]) /
    (2.0 * vtkMath::Pi() * (this->Cosines[i - 1] - this->Cosines[i]));
}

//------------------------------------------------------------------------------
glm::dvec3 LampDirections::Sample(const glm::dvec3& toLamp, RandomNumbers& random)
{
  const double angle = vtkMath::Pi() * random.Next();
  return TurnFrom(toLamp, std::cos(angle), std::sin(angle), random.Next());
}

double LampDirections::GetDensity(const glm::dvec3& toLamp, const glm::dvec3& direction)
{
  const double sine = std::max(glm::length(glm::cross(toLamp, direction)), 1e-300);
  return 1.0 / (2.0 * vtkMath::Pi() * vtkMath::Pi() * sine);
}

//------------------------------------------------------------------------------
glm::dvec3 SampleCosineLobe(const glm::dvec3& normal, RandomNumbers& random)
{
  const double share = random.Next();
  return TurnFrom(normal, std::sqrt(1.0 - share), std::sqrt(share), random.Next());
}

//------------------------------------------------------------------------------
EquiangularPlaces::EquiangularPlaces(
  const glm::dvec3& lamp, double radius, const PathSegment& segment)
  : From(segment.GetFrom())
  , To(segment.GetTo())
{
  const glm::dvec3 way = lamp - segment.GetOrigin();
  this->Foot = glm::dot(way, segment.GetDirection());
  this->H = std::max(glm::length(glm::cross(way, segment.GetDirection())), radius);
  this->First = std::atan2(this->From - this->Foot, this->H);
  this->Last = std::atan2(this->To - this->Foot, this->H);
}

double EquiangularPlaces::Sample(RandomNumbers& random) const
{
  const double angle = glm::mix(this->First, this->Last, random.Next());
  return std::clamp(this->Foot + this->H * std::tan(angle), this->From, this->To);
}

double EquiangularPlaces::GetDensity(double t) const
{
  const double x = t - this->Foot;
  return t < this->From || t > this->To
    ? 0.0
    : this->H / ((this->Last - this->First) * (x * x + this->H * this->H));
}
}
