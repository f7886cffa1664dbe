// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Phase/AirlightPhaseShape.h"

#include "Phase/AirlightPhaseSampler.h"

namespace airlight
{
namespace
{
bool IsGoodEnough(const PhaseFit& fit, double tolerance)
{
  return fit.ErrorBound <= tolerance && HasClosedForm(Convert(fit));
}
}

//------------------------------------------------------------------------------
std::shared_ptr<const PhaseShape> MakePhaseShape(const PhaseFit& fit)
{
  auto shape = std::make_shared<PhaseShape>();
  shape->Fit = fit;
  return shape;
}

//------------------------------------------------------------------------------
std::shared_ptr<const PhaseShape> MakePhaseShape(
  const PhaseFit& fit, const PhaseTable& table, double tolerance)
{
  if (IsGoodEnough(fit, tolerance))
  {
    return MakePhaseShape(fit);
  }
  auto shape = std::make_shared<PhaseShape>();
  shape->Rows = table.GetRows();
  return shape;
}

//------------------------------------------------------------------------------
std::shared_ptr<const PhaseShape> MakePhaseShape(
  const PhaseFit& fit, const PhaseFunction& function, double tolerance)
{
  if (IsGoodEnough(fit, tolerance))
  {
    return MakePhaseShape(fit);
  }
  auto shape = std::make_shared<PhaseShape>();
  shape->Rows = SamplePhase(function, shape->Fit.ErrorBound);
  return shape;
}
}
