// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/AirlightPathTracer.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
constexpr int FirstRoulette = 4; // order from which on paths may end by chance

// From here on paths end by chance even if nothing absorbs: in closed rooms they would never.
constexpr int LastCertain = 1000;
constexpr double CertainSurvival = 0.999;

// So often the first few turns of a path aim at a light: media that scatter forward do so rarely,
// and then all the light is there. Each makes the path's weight 4/3 of what it is at most.
constexpr int LastAimed = 3; // order
constexpr double AimedShare = 0.25;
}

//------------------------------------------------------------------------------
PathTracer::PathTracer(const ReferenceTracer& tracer, int orders)
  : Tracer(tracer)
  , Media(tracer.GetMedia())
  , Lights(tracer)
  , Orders(orders)
{
}

//------------------------------------------------------------------------------
// Where light is scattered or reflected into the eye's ray: a place drawn by free flight or, half
// of the time, by the angle seen from a light.
bool PathTracer::FindFirst(
  const ReferenceTracer::EyeRay& eye, RandomNumbers& random, PathVertex& vertex) const
{
  const PathSegment segment(this->Media.Media, eye.Origin, eye.Direction, eye.End);
  const glm::dvec3 shares(1.0 / 3.0);
  std::optional<EquiangularPlaces> places;
  if (!this->Lights.IsEmpty() && segment.GetFrom() < segment.GetTo())
  {
    const PathLights::Choice choice = this->Lights.Choose(segment.GetOrigin(), random);
    if (choice.HasPlace())
    {
      places.emplace(choice.Light->Values.position, choice.Light->Values.radius, segment);
    }
  }
  const double byAngle = places && !places->IsEmpty() ? 0.5 : 0.0;
  double t = 0.0;
  if (random.Next() < byAngle)
  {
    t = places->Sample(random);
  }
  else if (!segment.SampleFlight(shares, random, t))
  {
    const double passing = (1.0 - byAngle) * segment.GetPassing(shares);
    if (!eye.Triangle || !this->Tracer.IsShaded(*eye.Triangle) || !(passing > 0.0))
    {
      return false;
    }
    vertex.EnterSurface(this->Tracer.GetSurface(eye), *eye.Triangle, segment, 1.0 / passing);
    return vertex.GetLargestWeight() > 0.0;
  }
  const double density =
    (1.0 - byAngle) * PathSegment::GetFlightDensity(shares, segment.GetPlace(t)) +
    (byAngle > 0.0 ? byAngle * places->GetDensity(t) : 0.0);
  if (!(density > 0.0))
  {
    return false;
  }
  vertex.EnterMedium(segment, t, 1.0 / density);
  return vertex.GetLargestWeight() > 0.0;
}

//------------------------------------------------------------------------------
// Russian roulette by what the path still may bring, compared with its first vertex.
bool PathTracer::Survives(PathVertex& vertex, int order, double first, RandomNumbers& random) const
{
  double chance = 1.0;
  if (order >= FirstRoulette)
  {
    const double now = vertex.GetLargestWeight() * this->Lights.GetImportance(vertex.Position);
    chance = std::min(1.0, now / first);
  }
  chance *= order > LastCertain ? CertainSurvival : 1.0;
  if (chance < 1.0 && !(random.Next() < chance))
  {
    return false;
  }
  vertex.Weight /= chance;
  return true;
}

//------------------------------------------------------------------------------
// All that reaches a vertex and goes on towards the eye.
glm::dvec3 PathTracer::Gather(PathVertex vertex, RandomNumbers& random) const
{
  glm::dvec3 sum(0.0);
  const double first = vertex.GetLargestWeight() * this->Lights.GetImportance(vertex.Position);
  Choice choice = this->Choose(vertex, random);
  double share = 1.0; // of the light gathered at the vertex
  for (int order = 2; this->Survives(vertex, order, first, random); ++order)
  {
    const std::optional<Turn> turn =
      this->GatherAround(vertex, choice, share, order <= LastAimed ? AimedShare : 0.0, sum, random);
    if (!turn)
    {
      break;
    }
    vertex.Weight *= turn->Factor;
    sum += vertex.Weight * turn->Ray.GetEmission();
    if (order == this->Orders)
    {
      break;
    }
    choice = this->Choose(vertex, random);
    share = this->GatherBeside(vertex, *turn, choice, sum, random);
    if (!turn->Ray.Move(vertex))
    {
      break;
    }
  }
  return sum;
}

//------------------------------------------------------------------------------
PathTracer::Choice PathTracer::Choose(const PathVertex& vertex, RandomNumbers& random) const
{
  return this->Lights.IsEmpty() ? Choice() : this->Lights.Choose(vertex.Position, random);
}

//------------------------------------------------------------------------------
// Adds a share of what a light brings to a vertex by one more scattering or reflection: from a
// direction drawn around the light and from the one in which the path goes on, which it returns
// unless nothing comes from there. The latter aims at the light with the probability `aim`.
std::optional<PathTracer::Turn> PathTracer::GatherAround(const PathVertex& vertex,
  const Choice& choice, double share, double aim, glm::dvec3& sum, RandomNumbers& random) const
{
  const glm::dvec3 shares = vertex.GetShares();
  const bool hasPlace = choice && choice->HasPlace();
  const glm::dvec3 toLight =
    choice ? PathLights::GetDirection(*choice->Light, vertex.Position) : glm::dvec3(0.0);
  const double aimed = hasPlace ? aim : 0.0;
  const auto getDensity = [&](const glm::dvec3& direction) {
    const double density = (1.0 - aimed) * vertex.GetDensity(this->Media, direction);
    return aimed > 0.0 ? density + aimed * LampDirections::GetDensity(toLight, direction) : density;
  };
  const auto gather = [&](const PathRay& ray, const glm::dvec3& scattering) {
    const glm::dvec3& direction = ray.GetSegment().GetDirection();
    const double both =
      getDensity(direction) + (hasPlace ? LampDirections::GetDensity(toLight, direction) : 0.0);
    sum += share / (both * choice->Probability) * vertex.Weight * scattering *
      ray.Gather(this->Lights, *choice->Light, random);
  };
  if (hasPlace)
  {
    const glm::dvec3 direction = LampDirections::Sample(toLight, random);
    const glm::dvec3 scattering = vertex.GetScattering(this->Media, direction);
    if (scattering != glm::dvec3(0.0))
    {
      PathRay ray(this->Tracer, vertex, direction);
      ray.SampleFlight(shares, random);
      gather(ray, scattering);
    }
  }
  const glm::dvec3 direction = aimed > 0.0 && random.Next() < aimed
    ? LampDirections::Sample(toLight, random)
    : vertex.SampleDirection(this->Media, random);
  const glm::dvec3 scattering = vertex.GetScattering(this->Media, direction);
  const double density = getDensity(direction);
  if (scattering == glm::dvec3(0.0) || !(density > 0.0))
  {
    return std::nullopt;
  }
  Turn turn{ PathRay(this->Tracer, vertex, direction), scattering / density };
  turn.Ray.SampleFlight(shares, random);
  if (choice)
  {
    gather(turn.Ray, scattering);
  }
  return turn;
}

//------------------------------------------------------------------------------
// The light around a vertex grows as the inverse of its distance from the lamp. So it is gathered
// at a place drawn by angle, too; returns the share that is left for the end of the free flight.
double PathTracer::GatherBeside(const PathVertex& vertex, const Turn& turn, const Choice& choice,
  glm::dvec3& sum, RandomNumbers& random) const
{
  const PathSegment& segment = turn.Ray.GetSegment();
  if (!choice || !choice->HasPlace() || !(segment.GetFrom() < segment.GetTo()))
  {
    return 1.0;
  }
  const f64::AirlightLight& light = choice->Light->Values;
  const EquiangularPlaces places(light.position, light.radius, segment);
  if (places.IsEmpty())
  {
    return 1.0;
  }
  const double t = places.Sample(random);
  const double density = turn.Ray.GetFlightDensity(segment.GetPlace(t)) + places.GetDensity(t);
  PathVertex beside = vertex;
  beside.EnterMedium(segment, t, density > 0.0 ? 1.0 / density : 0.0);
  if (beside.GetLargestWeight() > 0.0)
  {
    this->GatherAround(beside, choice, 1.0, 0.0, sum, random);
  }
  const PathPlace* flight = turn.Ray.GetFlight();
  const double byFlight = flight ? turn.Ray.GetFlightDensity(*flight) : 0.0;
  return flight ? byFlight / (byFlight + places.GetDensity(flight->T)) : 1.0;
}

//------------------------------------------------------------------------------
PathRadiance PathTracer::Trace(const ReferenceTracer::EyeRay& eye, RandomNumbers& random) const
{
  PathRadiance result;
  PathVertex vertex;
  if (!this->FindFirst(eye, random, vertex))
  {
    return result;
  }
  glm::dvec3 radiance = this->Gather(vertex, random);
  for (int c = 0; c < 3; ++c)
  {
    radiance[c] = std::isfinite(radiance[c]) ? radiance[c] : 0.0;
  }
  (vertex.OnSurface ? result.Surface : result.Airlight) = radiance;
  result.Radiance = radiance;
  for (const ReferenceTracer::Layer& layer : eye.Layers)
  {
    result.Radiance *= layer.T < vertex.T ? 1.0 - layer.Opacity : 1.0;
  }
  return result;
}
}
