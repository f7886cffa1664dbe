// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Integration/AirlightRayCuts.h"

#include <algorithm>

namespace airlight
{
namespace
{
// A piece of a ray on which the airlight of one light is integrated.
struct LitPiece
{
  const f64::AirlightMedia& Media;
  const f64::AirlightLight& Light;
  const f64::AirlightRay& Ray;
  const f64::AirlightPiece& Piece;
};

// Dense media let light in only near their surface: cuts towards both ends, until little depth is
// left before them.
void AddNearEnds(const LitPiece& lit, std::vector<double>& cuts)
{
  const glm::dvec3 depths = f64::airlightDepthInPiece(lit.Media, lit.Piece, lit.Ray.origin,
                              lit.Ray.direction, lit.Piece.to) -
    lit.Piece.depth;
  double depth = std::max({ depths.x, depths.y, depths.z });
  double step = lit.Piece.to - lit.Piece.from;
  for (int decade = 1; decade < 9 && depth > 0.3; ++decade)
  {
    step *= 0.1;
    depth *= 0.1;
    cuts.push_back(lit.Piece.from + step);
    cuts.push_back(lit.Piece.to - step);
  }
}

// A channel may count on a small part only.
void AddChannelEnds(const LitPiece& lit, std::vector<double>& cuts)
{
  const glm::dvec3 lengths =
    f64::airlightChannelLengths(lit.Media, lit.Piece, lit.Ray.origin, lit.Ray.direction);
  for (int channel = 0; channel < 3; ++channel)
  {
    cuts.push_back(lit.Piece.from + lengths[channel]);
  }
}

// Height fog can be lit and dense in a thin layer only.
void AddLayerEnds(const LitPiece& lit, std::vector<double>& cuts)
{
  const glm::dvec2 part(lit.Piece.from, lit.Piece.to);
  const glm::dvec3 toSun = f64::airlightToSun(lit.Light);
  for (double t = part.x; t < part.y;)
  {
    t = f64::airlightNextLayerEnd(
      lit.Media, lit.Ray.origin, lit.Ray.direction, part, toSun, t, part.y);
    cuts.push_back(t);
  }
}

// Where the path to the light begins to leave a region through another face, the light can change
// on so short a part that no node sees it.
void AddRegionKinks(const LitPiece& lit, std::vector<double>& cuts)
{
  const f64::AirlightWay way = f64::airlightWay(lit.Light, lit.Ray);
  for (double t = lit.Piece.from; t < lit.Piece.to;)
  {
    t = f64::airlightNextKink(lit.Media, way, t, lit.Piece.to);
    cuts.push_back(t);
  }
}

// The same for images: each is a box in its own coordinates, in which straight lines stay straight.
void AddImageKinks(const LitPiece& lit, std::vector<double>& cuts)
{
  const f64::AirlightWay way = f64::airlightWay(lit.Light, lit.Ray);
  for (int i = 0; i < lit.Media.count; ++i)
  {
    const f64::AirlightMedium& medium = lit.Media.item[i];
    if (medium.density != AIRLIGHT_DENSITY_GRID)
    {
      continue;
    }
    const DensityGrid& grid = *medium.grid;
    const auto toSamples = [&](const glm::dvec3& v, bool isPoint) {
      return isPoint ? grid.ToSamples(medium.gridOrigin + v) : grid.GetAxes() * v;
    };
    f64::AirlightWay own = way;
    own.direction = toSamples(way.direction, false);
    own.origin = toSamples(way.origin, way.directional);
    own.light = toSamples(way.light, !way.directional);
    f64::AirlightRegion box{};
    box.boxMax = grid.GetLast();
    for (double t = lit.Piece.from; t < lit.Piece.to;)
    {
      t = f64::airlightBoxKink(box, own, t + 1e-6 * (lit.Piece.to - t), lit.Piece.to);
      cuts.push_back(t);
    }
  }
}

// Each adds its cuts, in any order, also outside the piece.
constexpr void (*CutProviders[])(const LitPiece&, std::vector<double>&) = { AddNearEnds,
  AddChannelEnds, AddLayerEnds, AddRegionKinks, AddImageKinks };
}

//------------------------------------------------------------------------------
std::vector<f64::AirlightPiece> FindPieces(const f64::AirlightMedia& media,
  const glm::dvec3& origin, const glm::dvec3& direction, double t0, double t1)
{
  std::vector<double> cuts = { t0, t1 };
  for (int i = 0; i < media.count; ++i)
  {
    const f64::AirlightMedium& medium = media.item[i];
    if (medium.density == AIRLIGHT_DENSITY_GRID)
    {
      medium.grid->AddCuts(medium.gridOrigin + origin, direction, t0, t1, cuts);
    }
  }
  std::sort(cuts.begin(), cuts.end());
  std::vector<f64::AirlightPiece> pieces;
  for (size_t i = 1; i < cuts.size(); ++i)
  {
    for (double t = cuts[i - 1]; t < cuts[i]; t = pieces.back().to)
    {
      pieces.push_back(f64::airlightPieceAt(media, origin, direction, t, cuts[i]));
    }
  }
  return pieces;
}

//------------------------------------------------------------------------------
std::vector<double> FindCuts(const f64::AirlightMedia& media, const f64::AirlightLight& light,
  const f64::AirlightRay& ray, const f64::AirlightPiece& piece)
{
  std::vector<double> cuts = { piece.from, piece.to };
  for (const auto addCuts : CutProviders)
  {
    addCuts({ media, light, ray, piece }, cuts);
  }
  for (double& cut : cuts)
  {
    cut = std::clamp(cut, piece.from, piece.to);
  }
  std::sort(cuts.begin(), cuts.end());
  cuts.erase(std::unique(cuts.begin(), cuts.end()), cuts.end());
  return cuts;
}
}
