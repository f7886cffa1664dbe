// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/AirlightPathRay.h"

#include "Integration/AirlightIntegrate.h"

#include "vtkMath.h"

#include <algorithm>

namespace airlight
{
namespace
{
constexpr double SurfaceMargin = 1e-9; // around a surface, of the largest coordinates

double GetMargin(const ReferenceTracer& tracer, const glm::dvec3& position)
{
  const glm::dvec3 world = glm::abs(position + tracer.GetEye());
  return SurfaceMargin *
    std::max({ tracer.GetScene().GetOpaque().GetScale(), world.x, world.y, world.z });
}

// The distance of the first surface, AIRLIGHT_FAR without one.
double FindEnd(const ReferenceTracer& tracer, const PathVertex& from, const glm::dvec3& direction,
  const OccluderTriangle*& triangle)
{
  const ReferenceScene& scene = tracer.GetScene();
  const double after = from.OnSurface ? GetMargin(tracer, from.Position) : 0.0;
  ReferenceHit hit{ AIRLIGHT_FAR, nullptr };
  scene.FindFirst(
    scene.GetOpaque(), from.Position + tracer.GetEye(), direction, after, AIRLIGHT_FAR, hit);
  triangle = hit.Triangle;
  return hit.T;
}
}

//------------------------------------------------------------------------------
PathRay::PathRay(const ReferenceTracer& tracer, const PathVertex& from, const glm::dvec3& direction)
  : Tracer(tracer)
  , Segment(
      tracer.GetMedia(), from.Position, direction, FindEnd(tracer, from, direction, this->Triangle))
{
  if (this->Triangle)
  {
    const glm::dvec3 end = from.Position + tracer.GetEye() + this->Segment.GetEnd() * direction;
    this->Surface.emplace(
      tracer.GetScene().GetPart(*this->Triangle), *this->Triangle, end, direction);
  }
}

//------------------------------------------------------------------------------
void PathRay::SampleFlight(const glm::dvec3& shares, RandomNumbers& random)
{
  this->Shares = shares;
  double t = 0.0;
  this->Flight.reset();
  if (this->Segment.SampleFlight(shares, random, t))
  {
    this->Flight = this->Segment.GetPlace(t);
  }
}

//------------------------------------------------------------------------------
bool PathRay::Move(PathVertex& vertex) const
{
  if (this->Flight)
  {
    const double density = PathSegment::GetFlightDensity(this->Shares, *this->Flight);
    vertex.EnterMedium(this->Segment, this->Flight->T, density > 0.0 ? 1.0 / density : 0.0);
  }
  else if (this->Triangle && this->Tracer.IsShaded(*this->Triangle))
  {
    vertex.EnterSurface(
      *this->Surface, *this->Triangle, this->Segment, 1.0 / this->Segment.GetPassing(this->Shares));
  }
  else
  {
    return false;
  }
  return vertex.GetLargestWeight() > 0.0;
}

//------------------------------------------------------------------------------
glm::dvec3 PathRay::GatherAt(
  const PathLights& lights, const ReferenceLight& light, const PathPlace& place) const
{
  if (place.SigmaS == glm::dvec3(0.0))
  {
    return glm::dvec3(0.0);
  }
  glm::dvec3 toLight;
  const glm::dvec3 arriving = lights.GetArriving(light, place.Position, 0.0, true, toLight);
  return arriving == glm::dvec3(0.0) ? arriving
                                     : arriving * place.Transmittance *
      this->Segment.GetScattered(place, glm::dot(toLight, this->Segment.GetDirection()));
}

//------------------------------------------------------------------------------
// What the surface that ends it reflects of a light.
glm::dvec3 PathRay::GatherAtEnd(const PathLights& lights, const ReferenceLight& light) const
{
  if (!this->Triangle || !this->Tracer.IsShaded(*this->Triangle))
  {
    return glm::dvec3(0.0);
  }
  const glm::dvec3 weight = this->Surface->GetAlbedo() * this->Segment.GetTransmittance();
  if (weight == glm::dvec3(0.0))
  {
    return weight;
  }
  const glm::dvec3 position =
    this->Segment.GetOrigin() + this->Segment.GetEnd() * this->Segment.GetDirection();
  glm::dvec3 toLight;
  const glm::dvec3 arriving = lights.GetArriving(
    light, position, GetMargin(this->Tracer, position), this->Tracer.HasSurfaceShadows(), toLight);
  const double cosine = std::max(glm::dot(toLight, this->Surface->Normal), 0.0);
  return weight * arriving * cosine / vtkMath::Pi();
}

//------------------------------------------------------------------------------
glm::dvec3 PathRay::Gather(
  const PathLights& lights, const ReferenceLight& light, RandomNumbers& random) const
{
  glm::dvec3 sum = this->GatherAtEnd(lights, light);
  if (!(this->Segment.GetFrom() < this->Segment.GetTo()))
  {
    return sum;
  }
  std::optional<EquiangularPlaces> places;
  if (!f64::airlightIsDirectional(light.Values))
  {
    places.emplace(light.Values.position, light.Values.radius, this->Segment);
  }
  const bool byAngle = places && !places->IsEmpty();
  const auto gather = [&](const PathPlace& place) {
    const double density = PathSegment::GetFlightDensity(this->Shares, place) +
      (byAngle ? places->GetDensity(place.T) : 0.0);
    if (density > 0.0)
    {
      sum += this->GatherAt(lights, light, place) / density;
    }
  };
  if (byAngle)
  {
    gather(this->Segment.GetPlace(places->Sample(random)));
  }
  if (this->Flight)
  {
    gather(*this->Flight);
  }
  return sum;
}

//------------------------------------------------------------------------------
glm::dvec3 PathRay::GetEmission() const
{
  glm::dvec3 sum = this->Tracer.GetAmbient(
    this->Segment.GetOrigin(), this->Segment.GetDirection(), this->Segment.GetEnd());
  if (this->Triangle)
  {
    const ReferenceMaterial& material = this->Surface->Material;
    sum += this->Segment.GetTransmittance() *
      (this->Tracer.IsShaded(*this->Triangle) ? material.Ambient
                                              : material.Ambient + material.Diffuse);
  }
  return sum;
}
}
