// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkIsotropicPhaseFunction.h"

#include "Phase/AirlightPhaseShape.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkIsotropicPhaseFunction);

//------------------------------------------------------------------------------
vtkIsotropicPhaseFunction::vtkIsotropicPhaseFunction() = default;

vtkIsotropicPhaseFunction::~vtkIsotropicPhaseFunction() = default;

//------------------------------------------------------------------------------
double vtkIsotropicPhaseFunction::EvaluateHalfAngle(double) { return 0.25 / vtkMath::Pi(); }

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::PhaseShape> vtkIsotropicPhaseFunction::MakeShape(double)
{
  return airlight::MakePhaseShape(airlight::ExactIsotropic());
}
