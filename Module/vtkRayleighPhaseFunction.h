// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkRayleighPhaseFunction
 * @brief   scattering by particles far smaller than the wavelength, such as air's molecules
 *
 * p = 3/(16 pi) (1 + mu^2), with mu the cosine of the scattering angle. It has no parameters. It is
 * integrated exactly in closed form.
 *
 * Lord Rayleigh: On the Light from the Sky, its Polarization and Colour. Philosophical Magazine 41,
 * 1871.
 *
 * @sa vtkPhaseFunction vtkParticipatingMedium
 */

#ifndef vtkRayleighPhaseFunction_h
#define vtkRayleighPhaseFunction_h

#include "vtkPhaseFunction.h"

class VTKAIRLIGHT_EXPORT vtkRayleighPhaseFunction : public vtkPhaseFunction
{
public:
  static vtkRayleighPhaseFunction* New();
  vtkTypeMacro(vtkRayleighPhaseFunction, vtkPhaseFunction);

#ifndef __VTK_WRAP__
  double EvaluateHalfAngle(double s) override;
#endif

protected:
  vtkRayleighPhaseFunction();
  ~vtkRayleighPhaseFunction() override;

#ifndef __VTK_WRAP__
  std::shared_ptr<const airlight::PhaseShape> MakeShape(double tolerance) override;
#endif

private:
  vtkRayleighPhaseFunction(const vtkRayleighPhaseFunction&) = delete;
  void operator=(const vtkRayleighPhaseFunction&) = delete;
};

#endif
