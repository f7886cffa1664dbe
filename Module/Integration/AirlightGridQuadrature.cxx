// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Integration/AirlightGridQuadrature.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <vector>

namespace airlight
{
namespace
{
// Of the integral. The estimate is that of a rule of degree 5, the value that of one of degree 11,
// which is far better wherever the integrand is smooth.
constexpr double Tolerance = 1e-6;
constexpr int MostHalvings = 20000;

// Kronrod's extension of Gauss and Legendre's three nodes (Kronrod 1965): position, weight, weight
// in Gauss and Legendre's rule.
constexpr int NodeCount = 4;
constexpr double Nodes[NodeCount][3] = {
  { 0.0, 0.450916538658474142345110087045571, 0.888888888888888888888888888888889 },
  { 0.434243749346802558002071502844628, 0.401397414775962222905051818618432, 0.0 },
  { 0.774596669241483377035853079956480, 0.268488089868333440728569280666710,
    0.555555555555555555555555555555556 },
  { 0.960491268708020283423507092629080, 0.104656226026467265193823857192073, 0.0 },
};

// A part of the ray in which no medium begins or ends, and no cell of a grid.
struct Panel
{
  f64::AirlightPiece Piece;
  bool Straight; // integrated over t, else over v with t - tL = h sinh v
  double From;   // of that variable
  double To;
  glm::dvec3 Value;
  glm::dvec3 ErrorEstimate;
  double Weight; // of the error; the largest is halved first

  bool operator<(const Panel& other) const { return this->Weight < other.Weight; }
};

class CellwiseQuadrature
{
public:
  CellwiseQuadrature(
    const f64::AirlightMedia& media, const f64::AirlightLight& light, const f64::AirlightRay& ray)
    : Media(media)
    , Light(light)
    , Ray(ray)
  {
  }

  glm::dvec3 Integrate(double t0, double t1)
  {
    const std::vector<double> cuts = this->FindCuts(t0, t1);
    for (size_t i = 1; i < cuts.size(); ++i)
    {
      for (double t = cuts[i - 1]; t < cuts[i];)
      {
        f64::AirlightPiece piece =
          f64::airlightPieceAt(this->Media, this->Ray.origin, this->Ray.direction, t, cuts[i]);
        t = piece.to;
        // Where there is no grid, what lies beyond no longer counts.
        piece.to =
          f64::airlightNegligibleFrom(this->Media, piece, this->Ray.origin, this->Ray.direction);
        if (this->Scatters(piece))
        {
          this->AddParts(piece);
        }
      }
    }
    return this->Refine();
  }

private:
  std::vector<double> FindCuts(double t0, double t1) const
  {
    std::vector<double> cuts = { t0, t1 };
    for (int i = 0; i < this->Media.count; ++i)
    {
      const f64::AirlightMedium& medium = this->Media.item[i];
      if (medium.density == AIRLIGHT_DENSITY_GRID)
      {
        medium.grid->AddCuts(
          medium.gridOrigin + this->Ray.origin, this->Ray.direction, t0, t1, cuts);
      }
    }
    std::sort(cuts.begin(), cuts.end());
    return cuts;
  }

  // False in the empty cells of an image, of which there can be many.
  bool Scatters(const f64::AirlightPiece& piece) const
  {
    double depth = 0.0;
    for (int i = 0; i < this->Media.count; ++i)
    {
      if (f64::airlightPieceHolds(piece, i))
      {
        depth += f64::airlightInsideDepth(
          this->Media.item[i], this->Ray.origin, this->Ray.direction, piece.from, piece.to);
      }
    }
    return depth > 0.0;
  }

  // Cuts the piece where the way to the light begins to leave a region or an image through another
  // face: near their edges what arrives changes on so short a part that no node would see it.
  void AddParts(const f64::AirlightPiece& piece)
  {
    const f64::AirlightWay way = f64::airlightWay(this->Light, this->Ray);
    for (double from = piece.from; from < piece.to;)
    {
      double to = f64::airlightNextKink(this->Media, way, from, piece.to);
      for (int i = 0; i < this->Media.count; ++i)
      {
        const bool grid = this->Media.item[i].density == AIRLIGHT_DENSITY_GRID;
        to = grid ? NextImageKink(this->Media.item[i], way, from, to) : to;
      }
      this->AddPart(piece, from, to);
      from = to;
    }
  }

  // An image is a box in its own coordinates, in which straight ways stay straight.
  static double NextImageKink(
    const f64::AirlightMedium& medium, const f64::AirlightWay& way, double from, double to)
  {
    const DensityGrid& grid = *medium.grid;
    f64::AirlightWay own = way;
    own.direction = grid.GetAxes() * way.direction;
    own.origin = way.directional ? grid.ToSamples(medium.gridOrigin + way.origin)
                                 : grid.GetAxes() * way.origin;
    own.light =
      way.directional ? grid.GetAxes() * way.light : grid.ToSamples(medium.gridOrigin + way.light);
    f64::AirlightRegion box{};
    box.boxMax = grid.GetLast();
    return f64::airlightBoxKink(box, own, from + 1e-6 * (to - from), to);
  }

  void AddPart(const f64::AirlightPiece& piece, double from, double to)
  {
    const double tL = this->Ray.range.x + this->Ray.foot.tL;
    const double h = this->Ray.foot.h;
    const double reach = std::max(std::abs(from - tL), h);
    Panel panel;
    panel.Piece = piece;
    panel.Straight = f64::airlightIsDirectional(this->Light) || to - from < 0.05 * reach;
    panel.From = panel.Straight ? from : std::asinh((from - tL) / h);
    panel.To = panel.Straight ? to : std::asinh((to - tL) / h);
    this->Evaluate(panel);
    this->Panels.push_back(panel);
  }

  glm::dvec3 Integrand(const Panel& panel, double w) const
  {
    if (f64::airlightIsDirectional(this->Light))
    {
      return f64::airlightSunIntegrand(this->Media, this->Light, this->Ray, panel.Piece, w);
    }
    const double tL = this->Ray.range.x + this->Ray.foot.tL;
    const double h = this->Ray.foot.h;
    const double x = panel.Straight ? w - tL : h * std::sinh(w);
    const double r = panel.Straight ? std::sqrt(h * h + x * x) : h * std::cosh(w);
    const glm::dvec3 point = this->Ray.origin + (tL + x) * this->Ray.direction;
    return (panel.Straight ? 1.0 : r) * f64::airlightPhotometricShare(this->Light, point) *
      f64::airlightPointIntegrand(this->Media, this->Light, this->Ray, panel.Piece, x, r);
  }

  void Evaluate(Panel& panel) const
  {
    const double middle = 0.5 * (panel.From + panel.To);
    const double reach = 0.5 * (panel.To - panel.From);
    glm::dvec3 fine(0.0);
    glm::dvec3 coarse(0.0);
    for (int k = 0; k < NodeCount; ++k)
    {
      const double step = reach * Nodes[k][0];
      const glm::dvec3 value = k == 0
        ? this->Integrand(panel, middle)
        : this->Integrand(panel, middle - step) + this->Integrand(panel, middle + step);
      fine += Nodes[k][1] * value;
      coarse += Nodes[k][2] * value;
    }
    panel.Value = reach * fine;
    panel.ErrorEstimate = reach * glm::abs(fine - coarse);
  }

  static void Weigh(Panel& panel, const glm::dvec3& total)
  {
    const glm::dvec3 share = panel.ErrorEstimate / (total + 1e-290);
    panel.Weight = std::max({ share.x, share.y, share.z });
  }

  glm::dvec3 Refine()
  {
    glm::dvec3 total(0.0);
    for (const Panel& panel : this->Panels)
    {
      total += panel.Value;
    }
    double errorEstimate = 0.0;
    for (Panel& panel : this->Panels)
    {
      Weigh(panel, total);
      errorEstimate += panel.Weight;
    }
    std::priority_queue<Panel> queue(std::less<Panel>(), std::move(this->Panels));
    // Written so that NaN ends it, too.
    for (int i = 0; i < MostHalvings && errorEstimate > Tolerance; ++i)
    {
      Panel halves[2] = { queue.top(), queue.top() };
      queue.pop();
      halves[0].To = halves[1].From = 0.5 * (halves[0].From + halves[0].To);
      errorEstimate -= halves[0].Weight;
      for (Panel& half : halves)
      {
        this->Evaluate(half);
        Weigh(half, total);
        errorEstimate += half.Weight;
        queue.push(half);
      }
    }
    glm::dvec3 sum(0.0);
    for (; !queue.empty(); queue.pop())
    {
      sum += queue.top().Value;
    }
    return sum;
  }

  const f64::AirlightMedia& Media;
  const f64::AirlightLight& Light;
  const f64::AirlightRay& Ray;
  std::vector<Panel> Panels;
};
}

//------------------------------------------------------------------------------
glm::dvec3 GridQuadrature(const f64::AirlightMedia& media, const f64::AirlightLight& light,
  const f64::AirlightRay& ray, double t0, double t1)
{
  return CellwiseQuadrature(media, light, ray).Integrate(t0, t1);
}
}
