// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkHenyeyGreensteinPhaseFunction
 * @brief   a peak of adjustable width, for haze, smoke and water
 *
 * p = (1 - g^2)/(4 pi (1 + g^2 - 2 g mu)^(3/2)), with mu the cosine of the scattering angle. At
 * g = 0 it is isotropic. It is integrated in closed form, by a fit.
 *
 * L. G. Henyey, J. L. Greenstein: Diffuse Radiation in the Galaxy. Astrophysical Journal 93, 1941.
 *
 * @sa vtkPhaseFunction vtkParticipatingMedium
 */

#ifndef vtkHenyeyGreensteinPhaseFunction_h
#define vtkHenyeyGreensteinPhaseFunction_h

#include "vtkPhaseFunction.h"

class VTKAIRLIGHT_EXPORT vtkHenyeyGreensteinPhaseFunction : public vtkPhaseFunction
{
public:
  static vtkHenyeyGreensteinPhaseFunction* New();
  vtkTypeMacro(vtkHenyeyGreensteinPhaseFunction, vtkPhaseFunction);

  ///@{
  /**
   * The mean cosine g of the scattering angle, without unit: above 0 forward, below 0 backward. Its
   * name is "g". Range: [-0.99, 0.99]. Default: 0.
   */
  void SetAnisotropy(double g) { this->SetParameterAt(0, "Anisotropy", g); }
  double GetAnisotropy() { return this->GetParameterAt(0); }
  ///@}

#ifndef __VTK_WRAP__
  double EvaluateHalfAngle(double s) override;
#endif

protected:
  vtkHenyeyGreensteinPhaseFunction();
  ~vtkHenyeyGreensteinPhaseFunction() override;

#ifndef __VTK_WRAP__
  std::shared_ptr<const airlight::PhaseShape> MakeShape(double tolerance) override;
#endif

private:
  vtkHenyeyGreensteinPhaseFunction(const vtkHenyeyGreensteinPhaseFunction&) = delete;
  void operator=(const vtkHenyeyGreensteinPhaseFunction&) = delete;
};

#endif
