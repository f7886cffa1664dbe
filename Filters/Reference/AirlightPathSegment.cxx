// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Reference/AirlightPathSegment.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
constexpr int MostSteps = 100; // of the search for a depth: each halves the bracket at least
}

//------------------------------------------------------------------------------
PathSegment::PathSegment(const f64::AirlightMedia& media, const glm::dvec3& origin,
  const glm::dvec3& direction, double end)
  : Media(media)
  , Origin(origin)
  , Direction(direction)
  , End(std::min(end, AIRLIGHT_FAR))
{
  glm::dvec3 depth(0.0);
  for (double t = 0.0; t < this->End;)
  {
    const f64::AirlightPiece piece =
      f64::airlightPieceAt(media, this->Origin, this->Direction, t, this->End);
    if (piece.inside != 0)
    {
      depth = f64::airlightDepthInPiece(media, piece, this->Origin, this->Direction, piece.to);
      this->Pieces.push_back(piece);
      this->Depths.push_back(depth);
    }
    t = piece.to;
  }
  this->Passed = glm::exp(-depth);
}

//------------------------------------------------------------------------------
PathPlace PathSegment::GetPlace(double t) const
{
  PathPlace place;
  place.T = t;
  place.Position = this->Origin + t * this->Direction;
  const auto piece = std::find_if(this->Pieces.begin(), this->Pieces.end(),
    [t](const f64::AirlightPiece& one) { return t <= one.to; });
  if (piece == this->Pieces.end())
  {
    place.Transmittance = this->Passed;
    return place;
  }
  if (t < piece->from)
  {
    place.Transmittance = glm::exp(-piece->depth);
    return place;
  }
  place.Transmittance =
    glm::exp(-f64::airlightDepthInPiece(this->Media, *piece, this->Origin, this->Direction, t));
  for (int i = 0; i < this->Media.count; ++i)
  {
    if (f64::airlightPieceHolds(*piece, i))
    {
      place.Density[i] = f64::airlightDensity(this->Media.item[i], place.Position);
      place.Scattering[i] =
        place.Density[i] * f64::airlightScatteringAt(this->Media.item[i], place.Position);
      place.SigmaS += place.Scattering[i];
      place.SigmaT += place.Density[i] * this->Media.item[i].sigmaT;
    }
  }
  return place;
}

//------------------------------------------------------------------------------
glm::dvec3 PathSegment::GetScattered(const PathPlace& place, double cosine) const
{
  glm::dvec3 sum(0.0);
  for (int i = 0; i < this->Media.count; ++i)
  {
    if (place.Density[i] > 0.0)
    {
      const f64::AirlightMedium& medium = this->Media.item[i];
      sum += place.Scattering[i] * f64::airlightPhase(medium.phase, cosine);
    }
  }
  return sum;
}

//------------------------------------------------------------------------------
bool PathSegment::SampleFlight(const glm::dvec3& shares, RandomNumbers& random, double& t) const
{
  const double pick = random.Next();
  const int channel = pick < shares.x ? 0 : (pick < shares.x + shares.y ? 1 : 2);
  const double depth = -std::log(random.Next());
  for (size_t i = 0; i < this->Pieces.size(); ++i)
  {
    if (depth < this->Depths[i][channel])
    {
      t = this->FindInPiece(this->Pieces[i], channel, depth);
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
// Where in a piece a channel's depth is reached: in closed form in uniform media, else by Newton's
// steps kept inside a bracket.
double PathSegment::FindInPiece(const f64::AirlightPiece& piece, int channel, double depth) const
{
  const double rest = std::max(depth - piece.depth[channel], 0.0);
  const glm::dvec3 start = this->Origin + piece.from * this->Direction;
  double rate = 0.0;
  bool uniform = true;
  double low = piece.from;
  double high = piece.to;
  for (int i = 0; i < this->Media.count; ++i)
  {
    const f64::AirlightMedium& medium = this->Media.item[i];
    if (!f64::airlightPieceHolds(piece, i))
    {
      continue;
    }
    rate += medium.sigmaT[channel];
    uniform = uniform && medium.density == AIRLIGHT_DENSITY_UNIFORM;
    if (medium.density != AIRLIGHT_DENSITY_GRID)
    {
      high = std::min(high,
        piece.from +
          f64::airlightFadingLength(medium, start, this->Direction, medium.sigmaT[channel], rest));
    }
  }
  if (uniform)
  {
    return std::clamp(piece.from + rest / rate, piece.from, piece.to);
  }
  double t = 0.5 * (low + high);
  for (int step = 0; step < MostSteps && high - low > 1e-12 * high; ++step)
  {
    const double error =
      f64::airlightDepthInPiece(this->Media, piece, this->Origin, this->Direction, t)[channel] -
      depth;
    (error > 0.0 ? high : low) = t;
    if (std::abs(error) < 1e-12 * depth)
    {
      break;
    }
    const double slope = this->GetPlace(t).SigmaT[channel];
    const double next = slope > 0.0 ? t - error / slope : low;
    t = next > low && next < high ? next : 0.5 * (low + high);
  }
  return t;
}
}
