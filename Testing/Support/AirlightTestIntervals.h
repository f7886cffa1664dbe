// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Intervals of a ray, lit and dark, for AirlightBruteForce.h.
 */

#ifndef AirlightTestIntervals_h
#define AirlightTestIntervals_h

#include <glm/glm.hpp>

#include <algorithm>
#include <limits>
#include <vector>

namespace airlighttest
{
constexpr double Infinity = std::numeric_limits<double>::infinity();

struct Interval
{
  double From, To;
};

// A part of the ray, and the share of the light that reaches it.
struct LitPart
{
  Interval Where;
  glm::dvec3 Passes;
};

//------------------------------------------------------------------------------
// The complement of the union of intervals on [0, end].
inline std::vector<Interval> Complement(std::vector<Interval> parts, double end)
{
  std::sort(parts.begin(), parts.end(),
    [](const Interval& a, const Interval& b) { return a.From < b.From; });
  std::vector<Interval> result;
  double from = 0.0;
  for (const Interval& part : parts)
  {
    if (part.From > from && from < end)
    {
      result.push_back({ from, std::min(part.From, end) });
    }
    from = std::max(from, part.To);
  }
  if (from < end)
  {
    result.push_back({ from, end });
  }
  return result;
}

//------------------------------------------------------------------------------
// Lit intervals, cut where the shadows of translucent triangles begin and end.
inline std::vector<LitPart> Dim(
  const std::vector<Interval>& lit, const std::vector<LitPart>& shadows)
{
  std::vector<LitPart> result;
  for (const Interval& whole : lit)
  {
    std::vector<double> ends = { whole.From, whole.To };
    for (const LitPart& shadow : shadows)
    {
      ends.push_back(std::clamp(shadow.Where.From, whole.From, whole.To));
      ends.push_back(std::clamp(shadow.Where.To, whole.From, whole.To));
    }
    std::sort(ends.begin(), ends.end());
    for (size_t i = 1; i < ends.size(); ++i)
    {
      LitPart part = { { ends[i - 1], ends[i] }, glm::dvec3(1.0) };
      for (const LitPart& shadow : shadows)
      {
        const bool inside =
          shadow.Where.From <= part.Where.From && shadow.Where.To >= part.Where.To;
        part.Passes *= inside ? shadow.Passes : glm::dvec3(1.0);
      }
      if (part.Where.From < part.Where.To)
      {
        result.push_back(part);
      }
    }
  }
  return result;
}
}

#endif
