// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkMieHazyPhaseFunction
 * @brief   scattering by droplets in hazy air
 *
 * p = (1/2 + 9/2 ((1 + mu)/2)^8)/(4 pi), with mu the cosine of the scattering angle. It has no
 * parameters. It is exact, and integrated by quadrature, which costs more than a closed form.
 *
 * T. Nishita, Y. Miyawaki, E. Nakamae: A Shading Model for Atmospheric Scattering considering
 * Luminous Intensity Distribution of Light Sources. SIGGRAPH 1987.
 *
 * @sa vtkPhaseFunction vtkParticipatingMedium
 */

#ifndef vtkMieHazyPhaseFunction_h
#define vtkMieHazyPhaseFunction_h

#include "vtkPhaseFunction.h"

class VTKAIRLIGHT_EXPORT vtkMieHazyPhaseFunction : public vtkPhaseFunction
{
public:
  static vtkMieHazyPhaseFunction* New();
  vtkTypeMacro(vtkMieHazyPhaseFunction, vtkPhaseFunction);

#ifndef __VTK_WRAP__
  double EvaluateHalfAngle(double s) override;
#endif

protected:
  vtkMieHazyPhaseFunction();
  ~vtkMieHazyPhaseFunction() override;

#ifndef __VTK_WRAP__
  std::shared_ptr<const airlight::PhaseShape> MakeShape(double tolerance) override;
#endif

private:
  vtkMieHazyPhaseFunction(const vtkMieHazyPhaseFunction&) = delete;
  void operator=(const vtkMieHazyPhaseFunction&) = delete;
};

#endif
