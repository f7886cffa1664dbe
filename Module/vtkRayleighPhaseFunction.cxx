// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkRayleighPhaseFunction.h"

#include "Phase/AirlightPhaseFunctions.h"
#include "Phase/AirlightPhaseShape.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkRayleighPhaseFunction);

//------------------------------------------------------------------------------
vtkRayleighPhaseFunction::vtkRayleighPhaseFunction() = default;

vtkRayleighPhaseFunction::~vtkRayleighPhaseFunction() = default;

//------------------------------------------------------------------------------
double vtkRayleighPhaseFunction::EvaluateHalfAngle(double s) { return airlight::Rayleigh(s); }

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::PhaseShape> vtkRayleighPhaseFunction::MakeShape(double)
{
  return airlight::MakePhaseShape(airlight::ExactRayleigh());
}
