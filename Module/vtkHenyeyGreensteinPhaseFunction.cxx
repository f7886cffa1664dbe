// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkHenyeyGreensteinPhaseFunction.h"

#include "Phase/AirlightPhaseFunctions.h"
#include "Phase/AirlightPhaseShape.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkHenyeyGreensteinPhaseFunction);

//------------------------------------------------------------------------------
vtkHenyeyGreensteinPhaseFunction::vtkHenyeyGreensteinPhaseFunction()
{
  this->AddParameter("g", -0.99, 0.99, 0.0);
}

vtkHenyeyGreensteinPhaseFunction::~vtkHenyeyGreensteinPhaseFunction() = default;

//------------------------------------------------------------------------------
double vtkHenyeyGreensteinPhaseFunction::EvaluateHalfAngle(double s)
{
  return airlight::HenyeyGreenstein(this->GetAnisotropy(), s);
}

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::PhaseShape> vtkHenyeyGreensteinPhaseFunction::MakeShape(
  double tolerance)
{
  return airlight::MakePhaseShape(
    airlight::FitHenyeyGreenstein(this->GetAnisotropy(), tolerance, AIRLIGHT_MAX_POLES));
}
