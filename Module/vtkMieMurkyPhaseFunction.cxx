// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMieMurkyPhaseFunction.h"

#include "Phase/AirlightPhaseFunctions.h"
#include "Phase/AirlightPhaseShape.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMieMurkyPhaseFunction);

//------------------------------------------------------------------------------
vtkMieMurkyPhaseFunction::vtkMieMurkyPhaseFunction() = default;

vtkMieMurkyPhaseFunction::~vtkMieMurkyPhaseFunction() = default;

//------------------------------------------------------------------------------
double vtkMieMurkyPhaseFunction::EvaluateHalfAngle(double s) { return airlight::Mie(32, s); }

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::PhaseShape> vtkMieMurkyPhaseFunction::MakeShape(double)
{
  return airlight::MakePhaseShape(airlight::ExactMie(32));
}
