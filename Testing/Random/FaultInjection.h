// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A test of the comparison itself: pixels of a picture that is right are drawn wrongly on purpose, in each
 * way in which a pass can go wrong, and SceneComparison has to report them. What it explains by edges and
 * roundings may be a tenth of them.
 */

#ifndef FaultInjection_h
#define FaultInjection_h

#include "SceneComparison.h"

#include <array>

namespace airlight_test
{
class FaultInjection
{
public:
  // Some pixels of a scene, others with each seed.
  void Add(SceneComparison& comparison, std::uint64_t seed);

  // Prints how many of each kind were reported. False where one kind was reported in less than 90 % of
  // its pixels, or was injected in too few.
  bool Report() const;

private:
  enum Kind
  {
    MISSING_SURFACE, // what is behind it, with its medium
    NEARER_SURFACE,  // by a tenth, with the medium before it
    WRONG_DEPTH,     // by 5 %, alone
    DIM_SURFACE,     // by a tenth
    LIT_SURFACE,     // which is in shadow
    BRIGHT_AIR,      // by 3 %
    LIT_AIR,         // without shadows
    WRONG_TRANSMITTANCE,
    KINDS
  };
  struct Count
  {
    long Injected = 0;
    long Reported = 0;
  };

  static const char* GetName(Kind kind);
  static airlight::ReferencePixel Spoil(
    SceneComparison& comparison, vtkIdType pixel, Kind kind, const airlight::ReferencePixel& right);
  static bool IsVisible(const SceneComparison& comparison, const airlight::ReferencePixel& right,
    const airlight::ReferencePixel& wrong);

  std::array<Count, KINDS> Counts;
};
}

#endif
