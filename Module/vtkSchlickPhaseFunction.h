// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSchlickPhaseFunction
 * @brief   a fast approximation of Henyey and Greenstein's function
 *
 * p = (1 - k^2)/(4 pi (1 - k mu)^2), with mu the cosine of the scattering angle.
 * k = 1.55 g - 0.55 g^3 approximates vtkHenyeyGreensteinPhaseFunction of this g. It is integrated
 * exactly in closed form.
 *
 * P. Blasi, B. Le Saec, C. Schlick: A Rendering Algorithm for Discrete Volume Density Objects.
 * Computer Graphics Forum 12(3), 1993.
 *
 * @sa vtkPhaseFunction vtkParticipatingMedium
 */

#ifndef vtkSchlickPhaseFunction_h
#define vtkSchlickPhaseFunction_h

#include "vtkPhaseFunction.h"

class VTKAIRLIGHT_EXPORT vtkSchlickPhaseFunction : public vtkPhaseFunction
{
public:
  static vtkSchlickPhaseFunction* New();
  vtkTypeMacro(vtkSchlickPhaseFunction, vtkPhaseFunction);

  ///@{
  /**
   * The parameter k, without unit: above 0 forward, below 0 backward. Its name is "k". Range:
   * [-0.99, 0.99]. Default: 0.
   */
  void SetAnisotropy(double k) { this->SetParameterAt(0, "Anisotropy", k); }
  double GetAnisotropy() { return this->GetParameterAt(0); }
  ///@}

#ifndef __VTK_WRAP__
  double EvaluateHalfAngle(double s) override;
#endif

protected:
  vtkSchlickPhaseFunction();
  ~vtkSchlickPhaseFunction() override;

#ifndef __VTK_WRAP__
  std::shared_ptr<const airlight::PhaseShape> MakeShape(double tolerance) override;
#endif

private:
  vtkSchlickPhaseFunction(const vtkSchlickPhaseFunction&) = delete;
  void operator=(const vtkSchlickPhaseFunction&) = delete;
};

#endif
