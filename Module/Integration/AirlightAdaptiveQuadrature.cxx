// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Integration/AirlightAdaptiveQuadrature.h"

#include "Integration/AirlightRayCuts.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace airlight
{
namespace
{
// Gauss and Legendre's three nodes and their extensions to 7, 15 and 31 nodes (Patterson 1968),
// which are exact for polynomials of degrees 5, 11, 23 and 47. Each rule keeps the nodes of the one
// before, and the difference of the two estimates the error of the lower one.
constexpr int RuleCount = 4;
constexpr int PairCounts[RuleCount] = { 2, 4, 8, 16 };
struct Row
{
  double Node; // and its negative
  double Weights[RuleCount];
};
constexpr Row Rows[] = {
  { 0.0,
    { 0.88888888888888888889, 0.45091653865847414235, 0.22551049979820668739,
      0.11275525672076869161 } },
  { 0.77459666924148337704,
    { 0.55555555555555555556, 0.26848808986833344073, 0.13441525524378422036,
      0.06720775429599070354 } },
  { 0.434243749346802558,
    { 0.0, 0.40139741477596222291, 0.20062852937698902103, 0.10031427861179557877 } },
  { 0.96049126870802028342,
    { 0.0, 0.10465622602646726519, 0.051603282997079739697, 0.025807598096176653565 } },
  { 0.22338668642896688163, { 0.0, 0.0, 0.2191568584015874964, 0.10957842105592463824 } },
  { 0.62110294673722640294, { 0.0, 0.0, 0.17151190913639138079, 0.085755920049990351154 } },
  { 0.88845923287225699889, { 0.0, 0.0, 0.092927195315124537686, 0.046462893261757986541 } },
  { 0.99383196321275502221, { 0.0, 0.0, 0.017001719629940260339, 0.0084345657393211062463 } },
  { 0.11248894313318662575, { 0.0, 0.0, 0.0, 0.11195687302095345688 } },
  { 0.33113539325797683309, { 0.0, 0.0, 0.0, 0.10566989358023480974 } },
  { 0.53131974364437562397, { 0.0, 0.0, 0.0, 0.093627109981264473617 } },
  { 0.70249620649152707861, { 0.0, 0.0, 0.0, 0.076879620499003531043 } },
  { 0.8367259381688687355, { 0.0, 0.0, 0.0, 0.056979509494123357412 } },
  { 0.92965485742974005667, { 0.0, 0.0, 0.0, 0.035957103307129322097 } },
  { 0.98153114955374010687, { 0.0, 0.0, 0.0, 0.016446049854387810934 } },
  { 0.99909812496766759766, { 0.0, 0.0, 0.0, 0.0025447807915618744154 } },
};

// With wider panels of v, 31 nodes are seldom enough: the integrand's singularities are pi/2 away
// from real v.
constexpr double WidestPanel = 1.5;
// Pieces that are shorter than this, of the distance from the light, need no change of variable, in
// which they would have few digits.
constexpr double ShortPiece = 1e-4;
// More nodes help where a rule's error is less than this of the error of the rule before.
constexpr double Gain = 0.1;
}

//------------------------------------------------------------------------------
AdaptiveQuadrature::AdaptiveQuadrature(const f64::AirlightMedia& media,
  const f64::AirlightLight& light, const f64::AirlightRay& ray, LightShare share)
  : Media(media)
  , Light(light)
  , Ray(ray)
  , Share(std::move(share))
{
  const bool images = HasGrid(media);
  this->Tolerance = images ? 1e-6 : 1e-12;
  this->PanelTolerance = images ? 1e-9 : 1e-12;
  this->FirstRule = images ? 1 : 2;
  // The path to the light can pass a corner of a surface on so short a part of the ray that no node
  // of larger panels sees it.
  this->Fineness = HasSurface(media) && !images ? 8 : 1;
  if (this->Share)
  {
    // Its kinks are at places that are not known, and small shadows must not fall between nodes.
    this->Tolerance = 1e-5;
    this->PanelTolerance = 1e-8;
    this->FirstRule = 1;
    this->Fineness = 8;
  }
}

//------------------------------------------------------------------------------
glm::dvec3 AdaptiveQuadrature::Integrate(double t0, double t1)
{
  std::vector<f64::AirlightPiece> pieces =
    FindPieces(this->Media, this->Ray.origin, this->Ray.direction, t0, t1);
  for (f64::AirlightPiece& piece : pieces)
  {
    piece.to =
      f64::airlightNegligibleFrom(this->Media, piece, this->Ray.origin, this->Ray.direction);
    if (this->Scatters(piece))
    {
      this->AddPanels(piece);
    }
  }
  this->Refine();
  glm::dvec3 sum(0.0);
  for (const Panel& panel : this->Panels)
  {
    sum += panel.Value;
  }
  return sum;
}

//------------------------------------------------------------------------------
// False in the empty cells of an image, of which there can be many.
bool AdaptiveQuadrature::Scatters(const f64::AirlightPiece& piece) const
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

//------------------------------------------------------------------------------
void AdaptiveQuadrature::AddPanels(const f64::AirlightPiece& piece)
{
  // One variable for all of a piece. In two of them a cut would be in two places, as far apart as
  // rounding makes them, and dense media scatter much light between these.
  const double tL = this->Ray.range.x + this->Ray.foot.tL;
  const double h = this->Ray.foot.h;
  const double reach = std::max(std::abs(piece.from - tL), h);
  const bool straight =
    f64::airlightIsDirectional(this->Light) || piece.to - piece.from < ShortPiece * reach;
  std::vector<double> cuts = FindCuts(this->Media, this->Light, this->Ray, piece);
  for (double& cut : cuts)
  {
    cut = straight ? cut : std::asinh((cut - tL) / h);
  }
  for (size_t i = 1; i < cuts.size(); ++i)
  {
    const double width = cuts[i] - cuts[i - 1];
    const int count =
      this->Fineness * (straight ? 1 : static_cast<int>(std::min(width / WidestPanel, 1000.0)) + 1);
    for (int k = 0; k < count; ++k)
    {
      const double from = cuts[i - 1] + width * k / count;
      const double to = k + 1 == count ? cuts[i] : cuts[i - 1] + width * (k + 1) / count;
      this->Panels.push_back(this->MakePanel(piece, straight, from, to));
    }
  }
}

//------------------------------------------------------------------------------
AdaptiveQuadrature::Panel AdaptiveQuadrature::MakePanel(
  const f64::AirlightPiece& piece, bool straight, double from, double to)
{
  Panel panel;
  panel.Piece = &piece;
  panel.Straight = straight;
  panel.From = from;
  panel.To = to;
  while (panel.Rule < this->FirstRule)
  {
    this->UseNextRule(panel);
  }
  panel.Converges = true;
  return panel;
}

//------------------------------------------------------------------------------
glm::dvec3 AdaptiveQuadrature::Evaluate(const Panel& panel, double v) const
{
  const glm::dvec3 value =
    f64::airlightPanelValue(this->Media, this->Light, this->Ray, *panel.Piece, panel.Straight, v);
  if (!this->Share)
  {
    return value;
  }
  const double tL = this->Ray.range.x + this->Ray.foot.tL;
  const double t = panel.Straight ? v : tL + this->Ray.foot.h * std::sinh(v);
  return value * this->Share(this->Ray.origin + t * this->Ray.direction);
}

//------------------------------------------------------------------------------
void AdaptiveQuadrature::UseNextRule(Panel& panel)
{
  const double middle = 0.5 * (panel.From + panel.To);
  const double reach = 0.5 * (panel.To - panel.From);
  const auto integrand = [&](double v) { return this->Evaluate(panel, v); };
  const int known = panel.Rule == 0 ? 0 : PairCounts[panel.Rule];
  ++panel.Rule;
  glm::dvec3 fine(0.0);
  glm::dvec3 coarse(0.0);
  for (int k = 0; k < PairCounts[panel.Rule]; ++k)
  {
    if (k >= known)
    {
      const double step = reach * Rows[k].Node;
      panel.Pairs[k] =
        k == 0 ? integrand(middle) : integrand(middle - step) + integrand(middle + step);
    }
    fine += Rows[k].Weights[panel.Rule] * panel.Pairs[k];
    coarse += Rows[k].Weights[panel.Rule - 1] * panel.Pairs[k];
  }
  const glm::dvec3 value = reach * fine;
  const glm::dvec3 error = reach * glm::abs(fine - coarse);
  panel.Converges = !glm::any(glm::greaterThan(error, Gain * panel.Error));
  this->Total += value - panel.Value;
  this->Error += error - panel.Error;
  panel.Value = value;
  panel.Error = error;
}

//------------------------------------------------------------------------------
void AdaptiveQuadrature::Halve(size_t index)
{
  const Panel whole = this->Panels[index];
  const double middle = 0.5 * (whole.From + whole.To);
  this->Total -= whole.Value;
  this->Error -= whole.Error;
  this->Panels[index] = this->MakePanel(*whole.Piece, whole.Straight, whole.From, middle);
  this->Panels.push_back(this->MakePanel(*whole.Piece, whole.Straight, middle, whole.To));
}

//------------------------------------------------------------------------------
void AdaptiveQuadrature::Refine()
{
  std::priority_queue<std::pair<double, size_t>> queue; // of errors and panels
  const auto add = [&](size_t index) {
    const glm::dvec3 share = this->Panels[index].Error / (this->Total + 1e-290);
    queue.emplace(std::max({ share.x, share.y, share.z }), index);
  };
  for (size_t i = 0; i < this->Panels.size(); ++i)
  {
    add(i);
  }
  int halvings = 0;
  // Written so that NaN ends it, too. The last term is far below anything that counts.
  const auto isLarge = [&](const glm::dvec3& error, double tolerance) {
    return glm::any(glm::greaterThan(error, tolerance * this->Total + 1e-290));
  };
  while (!queue.empty() && halvings < MostHalvings && isLarge(this->Error, this->Tolerance))
  {
    const size_t index = queue.top().second;
    queue.pop();
    Panel& panel = this->Panels[index];
    const double middle = 0.5 * (panel.From + panel.To);
    if (!isLarge(panel.Error, this->PanelTolerance) || middle <= panel.From || middle >= panel.To)
    {
      continue;
    }
    if (panel.Converges && panel.Rule + 1 < RuleCount)
    {
      this->UseNextRule(panel);
    }
    else
    {
      this->Halve(index);
      add(this->Panels.size() - 1);
      ++halvings;
    }
    add(index);
  }
}
}
