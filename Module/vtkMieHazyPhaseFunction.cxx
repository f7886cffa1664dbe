// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkMieHazyPhaseFunction.h"

#include "Phase/AirlightPhaseFunctions.h"
#include "Phase/AirlightPhaseShape.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkMieHazyPhaseFunction);

//------------------------------------------------------------------------------
vtkMieHazyPhaseFunction::vtkMieHazyPhaseFunction() = default;

vtkMieHazyPhaseFunction::~vtkMieHazyPhaseFunction() = default;

//------------------------------------------------------------------------------
double vtkMieHazyPhaseFunction::EvaluateHalfAngle(double s) { return airlight::Mie(8, s); }

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::PhaseShape> vtkMieHazyPhaseFunction::MakeShape(double)
{
  return airlight::MakePhaseShape(airlight::ExactMie(8));
}
