// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkCornetteShanksPhaseFunction
 * @brief   Henyey and Greenstein's function with Rayleigh's as its limit
 *
 * p = 3/(8 pi) (1 - g^2)/(2 + g^2) (1 + mu^2)/(1 + g^2 - 2 g mu)^(3/2), with mu the cosine of the
 * scattering angle. At g = 0 it is exactly Rayleigh's. It is integrated in closed form, by a fit.
 *
 * W. M. Cornette, J. G. Shanks: Physically Reasonable Analytic Expression for the Single-Scattering
 * Phase Function. Applied Optics 31(16), 1992.
 *
 * @sa vtkPhaseFunction vtkParticipatingMedium
 */

#ifndef vtkCornetteShanksPhaseFunction_h
#define vtkCornetteShanksPhaseFunction_h

#include "vtkPhaseFunction.h"

class VTKAIRLIGHT_EXPORT vtkCornetteShanksPhaseFunction : public vtkPhaseFunction
{
public:
  static vtkCornetteShanksPhaseFunction* New();
  vtkTypeMacro(vtkCornetteShanksPhaseFunction, vtkPhaseFunction);

  ///@{
  /**
   * The parameter g, without unit: above 0 forward, below 0 backward. The mean cosine of the
   * scattering angle is 3 g (4 + g^2)/(5 (2 + g^2)). Its name is "g". Range: [-0.99, 0.99].
   * Default: 0.
   */
  void SetAnisotropy(double g) { this->SetParameterAt(0, "Anisotropy", g); }
  double GetAnisotropy() { return this->GetParameterAt(0); }
  ///@}

#ifndef __VTK_WRAP__
  double EvaluateHalfAngle(double s) override;
#endif

protected:
  vtkCornetteShanksPhaseFunction();
  ~vtkCornetteShanksPhaseFunction() override;

#ifndef __VTK_WRAP__
  std::shared_ptr<const airlight::PhaseShape> MakeShape(double tolerance) override;
#endif

private:
  vtkCornetteShanksPhaseFunction(const vtkCornetteShanksPhaseFunction&) = delete;
  void operator=(const vtkCornetteShanksPhaseFunction&) = delete;
};

#endif
