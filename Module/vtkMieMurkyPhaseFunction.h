// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMieMurkyPhaseFunction
 * @brief   scattering by droplets in murky air
 *
 * p = (1/2 + 33/2 ((1 + mu)/2)^32)/(4 pi), with mu the cosine of the scattering angle. It has no
 * parameters. It is exact, and integrated by quadrature, which costs more than a closed form.
 *
 * T. Nishita, Y. Miyawaki, E. Nakamae: A Shading Model for Atmospheric Scattering considering
 * Luminous Intensity Distribution of Light Sources. SIGGRAPH 1987.
 *
 * @sa vtkPhaseFunction vtkParticipatingMedium
 */

#ifndef vtkMieMurkyPhaseFunction_h
#define vtkMieMurkyPhaseFunction_h

#include "vtkPhaseFunction.h"

class VTKAIRLIGHT_EXPORT vtkMieMurkyPhaseFunction : public vtkPhaseFunction
{
public:
  static vtkMieMurkyPhaseFunction* New();
  vtkTypeMacro(vtkMieMurkyPhaseFunction, vtkPhaseFunction);

#ifndef __VTK_WRAP__
  double EvaluateHalfAngle(double s) override;
#endif

protected:
  vtkMieMurkyPhaseFunction();
  ~vtkMieMurkyPhaseFunction() override;

#ifndef __VTK_WRAP__
  std::shared_ptr<const airlight::PhaseShape> MakeShape(double tolerance) override;
#endif

private:
  vtkMieMurkyPhaseFunction(const vtkMieMurkyPhaseFunction&) = delete;
  void operator=(const vtkMieMurkyPhaseFunction&) = delete;
};

#endif
