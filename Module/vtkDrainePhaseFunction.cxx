// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkDrainePhaseFunction.h"

#include "Phase/AirlightPhaseShape.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

#include <cmath>

vtkStandardNewMacro(vtkDrainePhaseFunction);

namespace
{
double Draine(double g, double alpha, double s)
{
  const double s2 = s * s;
  const double mu = s > 1.0 ? 2.0 / (1.0 + s2) - 1.0 : (1.0 - s2) / (1.0 + s2);
  return (1.0 + alpha * mu * mu) / (1.0 + alpha * (1.0 + 2.0 * g * g) / 3.0) *
    airlight::HenyeyGreenstein(g, s);
}

// At g = 0, with m = (1 + mu)/2: 1 + alpha mu^2 = 1 + alpha - 4 alpha m + 4 alpha m^2.
airlight::PhaseFit FitEven(double alpha)
{
  const double f = 0.25 / vtkMath::Pi() / (1.0 + alpha / 3.0);
  return { { { 1.0, { f * (1.0 + alpha), -4.0 * f * alpha, 4.0 * f * alpha } } } };
}

airlight::PhaseFit Fit(double g, double alpha, double tolerance)
{
  if (alpha == 0.0)
  {
    return airlight::FitHenyeyGreenstein(g, tolerance, AIRLIGHT_MAX_POLES);
  }
  if (g == 0.0)
  {
    return FitEven(alpha);
  }
  const double forward = std::abs(g);
  const airlight::PhaseFit fit = airlight::FitPeaked(
    [=](double s) { return Draine(forward, alpha, s); }, forward, tolerance, AIRLIGHT_MAX_POLES);
  return g > 0.0 ? fit : airlight::Mirror(fit);
}
}

//------------------------------------------------------------------------------
vtkDrainePhaseFunction::vtkDrainePhaseFunction()
{
  this->AddParameter("g", -0.99, 0.99, 0.0);
  this->AddParameter("alpha", 0.0, 100.0, 1.0);
}

vtkDrainePhaseFunction::~vtkDrainePhaseFunction() = default;

//------------------------------------------------------------------------------
double vtkDrainePhaseFunction::EvaluateHalfAngle(double s)
{
  return Draine(this->GetAnisotropy(), this->GetAlpha(), s);
}

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::PhaseShape> vtkDrainePhaseFunction::MakeShape(double tolerance)
{
  const double g = this->GetAnisotropy();
  const double alpha = this->GetAlpha();
  return airlight::MakePhaseShape(
    Fit(g, alpha, tolerance), [=](double s) { return Draine(g, alpha, s); }, tolerance);
}
