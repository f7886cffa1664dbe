// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkSchlickPhaseFunction.h"

#include "Phase/AirlightPhaseFunctions.h"
#include "Phase/AirlightPhaseShape.h"
#include "vtkObjectFactory.h"

vtkStandardNewMacro(vtkSchlickPhaseFunction);

//------------------------------------------------------------------------------
vtkSchlickPhaseFunction::vtkSchlickPhaseFunction() { this->AddParameter("k", -0.99, 0.99, 0.0); }

vtkSchlickPhaseFunction::~vtkSchlickPhaseFunction() = default;

//------------------------------------------------------------------------------
double vtkSchlickPhaseFunction::EvaluateHalfAngle(double s)
{
  return airlight::Schlick(this->GetAnisotropy(), s);
}

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::PhaseShape> vtkSchlickPhaseFunction::MakeShape(double)
{
  return airlight::MakePhaseShape(airlight::ExactSchlick(this->GetAnisotropy()));
}
