// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "vtkTabulatedPhaseFunction.h"

#include "Phase/AirlightPhaseShape.h"
#include "vtkMath.h"
#include "vtkObjectFactory.h"
#include "vtkTable.h"

#include <algorithm>
#include <cmath>

vtkStandardNewMacro(vtkTabulatedPhaseFunction);

//------------------------------------------------------------------------------
vtkTabulatedPhaseFunction::vtkTabulatedPhaseFunction()
  : Function(std::make_unique<airlight::PhaseTable>())
{
}

vtkTabulatedPhaseFunction::~vtkTabulatedPhaseFunction() = default;

//------------------------------------------------------------------------------
void vtkTabulatedPhaseFunction::SetTable(vtkTable* table)
{
  if (this->Table == table)
  {
    return;
  }
  std::string error;
  if (table && airlight::PhaseTable::Read(table, error).IsEmpty())
  {
    vtkErrorMacro(<< "Table " << error << ". The old table stays.");
    return;
  }
  this->UseTable(table);
}

void vtkTabulatedPhaseFunction::UseTable(vtkTable* table)
{
  this->Table = table;
  this->ReadTime = 0;
  this->Modified();
}

vtkTable* vtkTabulatedPhaseFunction::GetTable() { return this->Table; }

//------------------------------------------------------------------------------
vtkMTimeType vtkTabulatedPhaseFunction::GetMTime()
{
  const vtkMTimeType time = this->Superclass::GetMTime();
  return this->Table ? std::max(time, this->Table->GetMTime()) : time;
}

//------------------------------------------------------------------------------
// The table may have changed since it was set.
const airlight::PhaseTable& vtkTabulatedPhaseFunction::Read()
{
  if (!this->Table)
  {
    *this->Function = airlight::PhaseTable();
    this->Problem = "its table is missing: call SetTable()";
  }
  else if (this->ReadTime != this->Table->GetMTime())
  {
    this->ReadTime = this->Table->GetMTime();
    std::string error;
    *this->Function = airlight::PhaseTable::Read(this->Table, error);
    this->Problem = error.empty() ? "" : "its table " + error;
  }
  return *this->Function;
}

//------------------------------------------------------------------------------
std::string vtkTabulatedPhaseFunction::FindProblem()
{
  this->Read();
  return this->Problem;
}

//------------------------------------------------------------------------------
double vtkTabulatedPhaseFunction::EvaluateHalfAngle(double s)
{
  const airlight::PhaseTable& function = this->Read();
  return function.IsEmpty() ? 0.25 / vtkMath::Pi() : function.Evaluate(s);
}

//------------------------------------------------------------------------------
std::shared_ptr<const airlight::PhaseShape> vtkTabulatedPhaseFunction::MakeShape(double tolerance)
{
  const airlight::PhaseTable& function = this->Read();
  return function.IsEmpty()
    ? airlight::MakePhaseShape(airlight::ExactIsotropic())
    : airlight::MakePhaseShape(
        airlight::FitTable(function, tolerance, AIRLIGHT_MAX_POLES), function, tolerance);
}

//------------------------------------------------------------------------------
void vtkTabulatedPhaseFunction::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Table: " << this->Table.Get() << "\n";
}
