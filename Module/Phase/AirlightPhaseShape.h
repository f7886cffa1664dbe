// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A phase function as it is integrated.
 */

#ifndef AirlightPhaseShape_h
#define AirlightPhaseShape_h

#include "Phase/AirlightPhaseFit.h"

#include <memory>

namespace airlight
{
// A fit, or the rows of a table where no fit is good enough.
struct PhaseShape
{
  PhaseFit Fit;
  std::vector<glm::dvec4> Rows;
};

// The fit alone; or, unless it has a closed form within the tolerance, the given rows of a table or
// a table of the function.
std::shared_ptr<const PhaseShape> MakePhaseShape(const PhaseFit& fit);
std::shared_ptr<const PhaseShape> MakePhaseShape(
  const PhaseFit& fit, const PhaseTable& table, double tolerance);
std::shared_ptr<const PhaseShape> MakePhaseShape(
  const PhaseFit& fit, const PhaseFunction& function, double tolerance);
}

#endif
