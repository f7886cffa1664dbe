// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkCornetteShanksPhaseFunction.h"

#include "Phase/AirlightPhaseFunctions.h"
#include "Phase/AirlightPhaseShape.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkCornetteShanksPhaseFunction);

//------------------------------------------------------------------------------
vtkCornetteShanksPhaseFunction::vtkCornetteShanksPhaseFunction()
{
  this->AddParameter("g", -0.99, 0.99, 0.0);
}

vtkCornetteShanksPhaseFunction::~vtkCornetteShanksPhaseFunction() = default;

//------------------------------------------------------------------------------
double vtkCornetteShanksPhaseFunction::EvaluateHalfAngle(double s)
{
  return airlight::CornetteShanks(this->GetAnisotropy(), s);
}

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::PhaseShape> vtkCornetteShanksPhaseFunction::MakeShape(
  double tolerance)
{
  return airlight::MakePhaseShape(
    airlight::FitCornetteShanks(this->GetAnisotropy(), tolerance, AIRLIGHT_MAX_POLES));
}
