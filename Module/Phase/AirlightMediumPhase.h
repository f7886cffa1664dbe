// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The phase function of a medium: one of vtkParticipatingMedium::PhaseFunctionType with the
 * medium's own anisotropy and table, or an object of the user's.
 */

#ifndef AirlightMediumPhase_h
#define AirlightMediumPhase_h

#include "Medium/AirlightChange.h"
#include "Phase/AirlightPhaseShape.h"
#include "vtkIndent.h"
#include "vtkPhaseFunction.h"
#include "vtkSmartPointer.h"
#include "vtkTable.h"

namespace airlight
{
class MediumPhase
{
public:
  MediumPhase();

  Change SetType(int type);
  Change SetFunction(vtkPhaseFunction* function); // null: isotropic if it was in use
  Change SetAnisotropy(double g);
  Change SetTable(vtkTable* table);
  Change SetTolerance(double tolerance);

  int GetType() const { return this->Type; }
  vtkPhaseFunction* GetFunction() const { return this->Given; }
  double GetAnisotropy() const { return this->Anisotropy; }
  vtkTable* GetTable() const { return this->Table; }
  double GetTolerance() const { return this->Tolerance; }

  // Of the function in use, whichever it is.
  vtkMTimeType GetTime() const { return this->Used->GetMTime(); }

  // Of the object and the table.
  vtkMTimeType GetMTime() const;

  // It is made when it is first needed, and again after a change. Errors are given once, then.
  std::shared_ptr<const PhaseShape> GetShape(std::string& error);

  // Not NaN.
  double Evaluate(double cosTheta, std::string& error);

  void Print(ostream& os, vtkIndent indent) const;

private:
  void Use(int type, vtkPhaseFunction* function);
  bool HasAnisotropy() const;
  std::string FindProblem() const;

  int Type = 0;                            // vtkParticipatingMedium::PhaseFunctionType
  vtkSmartPointer<vtkPhaseFunction> Used;  // Given, or made of the type
  vtkSmartPointer<vtkPhaseFunction> Given; // the user's
  double Anisotropy = 0.0;
  bool AnisotropyUnused = false; // since it was set, no function had one
  vtkSmartPointer<vtkTable> Table;
  double Tolerance = 1e-3;

  std::shared_ptr<const PhaseShape> Shape; // null: to be made
  vtkMTimeType ShapeTime = 0;              // of the function when the shape was made
};
}

#endif
