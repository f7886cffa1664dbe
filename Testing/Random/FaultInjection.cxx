// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FaultInjection.h"

#include <algorithm>
#include <cmath>
#include <iostream>

namespace airlight_test
{
namespace
{
constexpr vtkIdType Stride = 11; // one pixel of so many
constexpr double LeastShare = 0.9;
constexpr long FewPixels = 30;

// A fault is visible where a value changes by so much of itself and of the largest in the picture.
constexpr double VisibleShare = 0.02;
constexpr double VisiblePart = 0.003;
}

//------------------------------------------------------------------------------
const char* FaultInjection::GetName(Kind kind)
{
  constexpr std::array<const char*, KINDS> names = { "missing surface", "nearer surface",
    "wrong depth", "dim surface", "lit surface in shadow", "bright air", "lit air in shadow",
    "wrong transmittance" };
  return names[kind];
}

//------------------------------------------------------------------------------
airlight::ReferencePixel FaultInjection::Spoil(
  SceneComparison& comparison, vtkIdType pixel, Kind kind, const airlight::ReferencePixel& right)
{
  airlight::ReferencePixel wrong = right;
  airlight::ReferenceChange change;
  switch (kind)
  {
    case MISSING_SURFACE:
      change.After = right.Depth * (1.0 + 1e-4);
      return right.Depth > 0.0 ? comparison.Trace(pixel, change) : right;
    case NEARER_SURFACE:
      if (right.Depth > 0.0)
      {
        wrong = comparison.TraceTo(pixel, 0.9 * right.Depth);
        wrong.Depth = 0.9 * right.Depth;
        wrong.Surface = right.Surface * wrong.Transmittance / glm::max(right.Transmittance, 1e-30);
      }
      break;
    case WRONG_DEPTH:
      wrong.Depth *= right.Depth > 0.0 ? 1.05 : 1.0;
      break;
    case DIM_SURFACE:
      wrong.Surface *= 0.9;
      break;
    case LIT_SURFACE:
      wrong.Surface = comparison.TraceUnshadowed(pixel).Surface;
      break;
    case BRIGHT_AIR:
      wrong.Airlight *= 1.03;
      break;
    case LIT_AIR:
      wrong.Airlight = comparison.TraceUnshadowed(pixel).Airlight;
      wrong.LitLength = comparison.TraceUnshadowed(pixel).LitLength;
      break;
    default:
      wrong.Transmittance *= 0.95;
  }
  wrong.Radiance =
    right.Radiance + (wrong.Airlight - right.Airlight) + (wrong.Surface - right.Surface);
  return wrong;
}

//------------------------------------------------------------------------------
bool FaultInjection::IsVisible(const SceneComparison& comparison,
  const airlight::ReferencePixel& right, const airlight::ReferencePixel& wrong)
{
  const std::vector<double> before = SceneComparison::Flatten(right);
  const std::vector<double> after = SceneComparison::Flatten(wrong);
  const std::vector<double>& largest = comparison.GetLargest();
  for (size_t i = 0; i < before.size(); ++i)
  {
    const double change = std::abs(after[i] - before[i]);
    if (change > VisibleShare * std::abs(before[i]) && change > VisiblePart * largest[i])
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void FaultInjection::Add(SceneComparison& comparison, std::uint64_t seed)
{
  const vtkIdType pixels = comparison.GetFigures().Pixels;
  for (auto pixel = static_cast<vtkIdType>(seed % Stride); pixel < pixels; pixel += Stride)
  {
    const airlight::ReferencePixel right = comparison.GetDrawnPixel(pixel);
    if (comparison.Reports(pixel, right))
    {
      continue;
    }
    for (int kind = 0; kind < KINDS; ++kind)
    {
      const airlight::ReferencePixel wrong =
        Spoil(comparison, pixel, static_cast<Kind>(kind), right);
      if (IsVisible(comparison, right, wrong))
      {
        ++this->Counts[kind].Injected;
        this->Counts[kind].Reported += comparison.Reports(pixel, wrong) ? 1 : 0;
      }
    }
  }
}

//------------------------------------------------------------------------------
bool FaultInjection::Report() const
{
  bool ok = true;
  for (int kind = 0; kind < KINDS; ++kind)
  {
    const Count& count = this->Counts[kind];
    const bool fine = count.Injected >= FewPixels &&
      static_cast<double>(count.Reported) >= LeastShare * static_cast<double>(count.Injected);
    std::cout << (fine ? "ok      " : "FAILED  ") << GetName(static_cast<Kind>(kind)) << ": "
              << count.Reported << " of " << count.Injected << " reported\n";
    ok = ok && fine;
  }
  return ok;
}
}
