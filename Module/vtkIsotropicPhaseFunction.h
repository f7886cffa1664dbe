// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkIsotropicPhaseFunction
 * @brief   light scattered evenly in all directions
 *
 * p = 1/(4 pi). It has no parameters. It is integrated exactly in closed form, which makes it the
 * fastest phase function. It is the default of vtkParticipatingMedium; most real media scatter
 * forward.
 *
 * @sa vtkPhaseFunction vtkParticipatingMedium
 */

#ifndef vtkIsotropicPhaseFunction_h
#define vtkIsotropicPhaseFunction_h

#include "vtkPhaseFunction.h"

class VTKAIRLIGHT_EXPORT vtkIsotropicPhaseFunction : public vtkPhaseFunction
{
public:
  static vtkIsotropicPhaseFunction* New();
  vtkTypeMacro(vtkIsotropicPhaseFunction, vtkPhaseFunction);

#ifndef __VTK_WRAP__
  double EvaluateHalfAngle(double s) override;
#endif

protected:
  vtkIsotropicPhaseFunction();
  ~vtkIsotropicPhaseFunction() override;

#ifndef __VTK_WRAP__
  std::shared_ptr<const airlight::PhaseShape> MakeShape(double tolerance) override;
#endif

private:
  vtkIsotropicPhaseFunction(const vtkIsotropicPhaseFunction&) = delete;
  void operator=(const vtkIsotropicPhaseFunction&) = delete;
};

#endif
