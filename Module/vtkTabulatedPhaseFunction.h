// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkTabulatedPhaseFunction
 * @brief   a measured phase function
 *
 * Without a table the function is isotropic, and an error is reported when it is used. A table is
 * fitted by poles. If no fit matches it within vtkParticipatingMedium::SetPhaseTolerance(), the
 * table itself is integrated by quadrature.
 *
 * F. N. Fritsch, R. E. Carlson: Monotone Piecewise Cubic Interpolation. SIAM Journal on Numerical
 * Analysis 17(2), 1980.
 *
 * @sa vtkPhaseFunction vtkParticipatingMedium
 */

#ifndef vtkTabulatedPhaseFunction_h
#define vtkTabulatedPhaseFunction_h

#include "vtkPhaseFunction.h"
#include "vtkSmartPointer.h" // for the table

class vtkTable;

namespace airlight
{
class PhaseTable;
}

class VTKAIRLIGHT_EXPORT vtkTabulatedPhaseFunction : public vtkPhaseFunction
{
public:
  static vtkTabulatedPhaseFunction* New();
  vtkTypeMacro(vtkTabulatedPhaseFunction, vtkPhaseFunction);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Column 0: scattering angle in degrees, in [0, 180], ascending; column 1: value, above 0, in any
   * unit: the function is normalised. Its logarithm is a monotone cubic between the rows (Fritsch
   * and Carlson 1980) and constant before the first and after the last one. At least 2 rows. An
   * invalid table gives an error and the old one is kept. If it becomes invalid later, an error is
   * reported when it is used, and the function is isotropic. Default: none.
   */
  void SetTable(vtkTable* table);
  vtkTable* GetTable();
  ///@}

  /**
   * The time of the last modification of this object or of its table.
   */
  vtkMTimeType GetMTime() override;

#ifndef __VTK_WRAP__
  // Without a check: errors are reported when it is used. For the library's own use.
  void UseTable(vtkTable* table);

  double EvaluateHalfAngle(double s) override;
  std::string FindProblem() override;
#endif

protected:
  vtkTabulatedPhaseFunction();
  ~vtkTabulatedPhaseFunction() override;

#ifndef __VTK_WRAP__
  std::shared_ptr<const airlight::PhaseShape> MakeShape(double tolerance) override;
#endif

private:
  vtkTabulatedPhaseFunction(const vtkTabulatedPhaseFunction&) = delete;
  void operator=(const vtkTabulatedPhaseFunction&) = delete;

  const airlight::PhaseTable& Read();

  vtkSmartPointer<vtkTable> Table;
  std::unique_ptr<airlight::PhaseTable> Function; // of the table; empty if it is invalid
  std::string Problem = "its table is missing: call SetTable()";
  vtkMTimeType ReadTime = 0; // of the table when it was read
};

#endif
