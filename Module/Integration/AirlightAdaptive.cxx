// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Integration/AirlightAdaptive.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace airlight
{
namespace
{
// One piece of the quadrature, between ends of media. Panels are halved until two halves agree with
// the whole: samples that see kinks converge that way, too.
class AdaptivePiece
{
public:
  AdaptivePiece(const f64::AirlightMedia& media, const f64::AirlightLight& light,
    const f64::AirlightRay& ray, const f64::AirlightPiece& piece, double t1)
    : Media(media)
    , Light(light)
    , Ray(ray)
    , Piece(piece)
    , T0(piece.from)
    , T1(t1)
  {
    const double x0 = this->T0 - ray.range.x - ray.foot.tL;
    this->Straight = f64::airlightIsDirectional(light) ||
      t1 - this->T0 < 1e-4 * std::max(std::abs(x0), ray.foot.h);
  }

  glm::dvec3 Integrate()
  {
    const std::vector<double> ends = this->ChooseEnds();
    std::vector<glm::dvec3> rough(ends.size());
    for (size_t i = 1; i < ends.size(); ++i)
    {
      rough[i] = this->Panel(ends[i - 1], ends[i]);
      this->Total += rough[i];
    }
    glm::dvec3 sum(0.0);
    for (size_t i = 1; i < ends.size(); ++i)
    {
      sum += this->Refine(ends[i - 1], ends[i], rough[i], MaximumDepth);
    }
    return sum;
  }

private:
  static constexpr int MaximumDepth = 40;

  // The variable of the quadrature: v of x = h sinh v, or t itself.
  double Variable(double t) const
  {
    const double x = t - this->Ray.range.x - this->Ray.foot.tL;
    return this->Straight ? t : std::asinh(x / this->Ray.foot.h);
  }

  // The way to the light can pass a corner of a surface on so short a part of the ray that no node
  // sees it: smaller panels from the first.
  int GetFineness() const
  {
    int fineness = 1;
    for (int i = 0; i < this->Media.count; ++i)
    {
      const bool surface = this->Media.item[i].region.kind == AIRLIGHT_REGION_SURFACE;
      fineness = surface ? 8 : fineness;
    }
    return fineness;
  }

  std::vector<double> ChooseEnds() const
  {
    const double from = this->Variable(this->T0);
    const double to = this->Variable(this->T1);
    const int panels = this->GetFineness() *
      (this->Straight ? 4 : static_cast<int>(std::min((to - from) / 1.5, 1000.0)) + 1);
    std::vector<double> ends;
    for (int i = 0; i <= panels; ++i)
    {
      ends.push_back(from + (to - from) * i / panels);
    }
    // Dense media let light in only near their surface: smaller panels towards both ends.
    double step = this->T1 - this->T0;
    for (int decade = 1; decade < 9; ++decade)
    {
      step *= 0.1;
      ends.push_back(std::clamp(this->Variable(this->T0 + step), from, to));
      ends.push_back(std::clamp(this->Variable(this->T1 - step), from, to));
    }
    // A channel may count on a small part only.
    const glm::dvec3 lengths =
      f64::airlightChannelLengths(this->Media, this->Piece, this->Ray.origin, this->Ray.direction);
    for (int channel = 0; channel < 3; ++channel)
    {
      ends.push_back(std::clamp(this->Variable(this->T0 + lengths[channel]), from, to));
    }
    const glm::dvec2 part(this->T0, this->T1);
    const glm::dvec3 toSun = f64::airlightToSun(this->Light);
    for (double t = this->T0; t < this->T1;)
    {
      t = f64::airlightNextLayerEnd(
        this->Media, this->Ray.origin, this->Ray.direction, part, toSun, t, this->T1);
      ends.push_back(std::clamp(this->Variable(t), from, to));
    }
    // Where the way to the light begins to leave a region through another face, what arrives can
    // change on so short a part that no node sees it.
    const f64::AirlightWay way = f64::airlightWay(this->Light, this->Ray);
    for (double t = this->T0; t < this->T1;)
    {
      t = f64::airlightNextKink(this->Media, way, t, this->T1);
      ends.push_back(std::clamp(this->Variable(t), from, to));
    }
    std::sort(ends.begin(), ends.end());
    return ends;
  }

  glm::dvec3 Panel(double from, double to) const
  {
    glm::dvec3 errorEstimate;
    return f64::airlightPanel(
      this->Media, this->Light, this->Ray, this->Piece, this->Straight, from, to, errorEstimate);
  }

  glm::dvec3 Refine(double from, double to, const glm::dvec3& whole, int depth)
  {
    const double middle = 0.5 * (from + to);
    const glm::dvec3 low = this->Panel(from, middle);
    const glm::dvec3 high = this->Panel(middle, to);
    const glm::dvec3 change = low + high - whole;
    this->Total += change;
    // Written so that NaN ends it, too. The last term is far below anything that counts.
    if (depth == 0 || !glm::any(glm::greaterThan(glm::abs(change), 1e-12 * this->Total + 1e-290)))
    {
      return low + high;
    }
    return this->Refine(from, middle, low, depth - 1) + this->Refine(middle, to, high, depth - 1);
  }

  const f64::AirlightMedia& Media;
  const f64::AirlightLight& Light;
  const f64::AirlightRay& Ray;
  const f64::AirlightPiece& Piece;
  double T0;
  double T1;
  bool Straight;
  // The best estimate so far: the first one may have missed a narrow peak by orders of magnitude,
  // and a tolerance taken from it would never be reached.
  glm::dvec3 Total{ 0.0 };
};
}

//------------------------------------------------------------------------------
glm::dvec3 AdaptiveQuadrature(const f64::AirlightMedia& media, const f64::AirlightLight& light,
  const f64::AirlightRay& ray, double t0, double t1)
{
  glm::dvec3 sum(0.0);
  while (t0 < t1)
  {
    const f64::AirlightPiece piece = f64::airlightPieceAt(media, ray.origin, ray.direction, t0, t1);
    if (piece.inside != 0)
    {
      const double end = f64::airlightNegligibleFrom(media, piece, ray.origin, ray.direction);
      sum += AdaptivePiece(media, light, ray, piece, end).Integrate();
    }
    t0 = piece.to;
  }
  return sum;
}
}
