// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/AirlightPathVertex.h"

#include "vtkMath.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
//------------------------------------------------------------------------------
PathMedia::PathMedia(const f64::AirlightMedia& media)
  : Media(media)
{
  for (int i = 0; i < media.count; ++i)
  {
    this->Phases.emplace_back(media.item[i].phase);
  }
}

//------------------------------------------------------------------------------
glm::dvec3 PathVertex::GetShares() const
{
  const double sum = this->Weight.x + this->Weight.y + this->Weight.z;
  return sum > 0.0 ? this->Weight / sum : glm::dvec3(1.0 / 3.0);
}

//------------------------------------------------------------------------------
void PathVertex::EnterMedium(const PathSegment& segment, double t, double factor)
{
  this->OnSurface = false;
  this->T = t;
  this->Place = segment.GetPlace(t);
  this->Position = this->Place.Position;
  this->Direction = segment.GetDirection();
  this->Weight *= factor * this->Place.SigmaS * this->Place.Transmittance;
}

//------------------------------------------------------------------------------
void PathVertex::EnterSurface(const ReferenceSurface& surface, const OccluderTriangle& triangle,
  const PathSegment& segment, double factor)
{
  this->OnSurface = true;
  this->T = segment.GetEnd();
  this->Position = segment.GetOrigin() + segment.GetEnd() * segment.GetDirection();
  this->Direction = segment.GetDirection();
  this->Normal = surface.Normal;
  const glm::dvec3 flat =
    glm::normalize(glm::cross(triangle.B - triangle.A, triangle.C - triangle.A));
  this->Flat = glm::dot(flat, this->Direction) < 0.0 ? flat : -flat;
  this->Weight *= factor * surface.GetAlbedo() * segment.GetTransmittance();
}

//------------------------------------------------------------------------------
glm::dvec3 PathVertex::SampleDirection(const PathMedia& media, RandomNumbers& random) const
{
  if (this->OnSurface)
  {
    return SampleCosineLobe(this->Normal, random);
  }
  const auto getStrength = [&](int i) {
    const glm::dvec3& sigma = this->Place.Scattering[i];
    return sigma.x + sigma.y + sigma.z;
  };
  double rest =
    random.Next() * (this->Place.SigmaS.x + this->Place.SigmaS.y + this->Place.SigmaS.z);
  int chosen = -1;
  for (int i = 0; i < media.Media.count && (chosen < 0 || rest >= 0.0); ++i)
  {
    const double strength = getStrength(i);
    chosen = strength > 0.0 ? i : chosen;
    rest -= strength;
  }
  const double cosine = media.Phases[std::max(chosen, 0)].SampleCosine(random);
  return TurnFrom(this->Direction, cosine,
    std::sqrt(std::max((1.0 - cosine) * (1.0 + cosine), 0.0)), random.Next());
}

//------------------------------------------------------------------------------
double PathVertex::GetDensity(const PathMedia& media, const glm::dvec3& direction) const
{
  if (this->OnSurface)
  {
    return std::max(glm::dot(this->Normal, direction), 0.0) / vtkMath::Pi();
  }
  const double cosine = std::clamp(glm::dot(this->Direction, direction), -1.0, 1.0);
  double density = 0.0;
  double sum = 0.0;
  for (int i = 0; i < media.Media.count; ++i)
  {
    const glm::dvec3& sigma = this->Place.Scattering[i];
    const double strength = sigma.x + sigma.y + sigma.z;
    if (strength > 0.0)
    {
      density += strength * media.Phases[i].GetDensity(cosine);
      sum += strength;
    }
  }
  return sum > 0.0 ? density / sum : 0.0;
}

//------------------------------------------------------------------------------
glm::dvec3 PathVertex::GetScattering(const PathMedia& media, const glm::dvec3& direction) const
{
  if (this->OnSurface)
  {
    return glm::dvec3(
      glm::dot(this->Flat, direction) > 0.0 ? this->GetDensity(media, direction) : 0.0);
  }
  const double cosine = std::clamp(glm::dot(this->Direction, direction), -1.0, 1.0);
  glm::dvec3 sum(0.0);
  for (int i = 0; i < media.Media.count; ++i)
  {
    if (this->Place.Density[i] > 0.0)
    {
      const f64::AirlightMedium& medium = media.Media.item[i];
      sum += this->Place.Scattering[i] * f64::airlightPhase(medium.phase, cosine);
    }
  }
  for (int c = 0; c < 3; ++c)
  {
    sum[c] = this->Place.SigmaS[c] > 0.0 ? sum[c] / this->Place.SigmaS[c] : 0.0;
  }
  return sum;
}
}
