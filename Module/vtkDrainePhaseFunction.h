// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkDrainePhaseFunction
 * @brief   Henyey and Greenstein's function to Cornette and Shanks' in one family, and fog
 *
 * With mu the cosine of the scattering angle,
 *
 *   p = (1 - g^2)/(4 pi (1 + g^2 - 2 g mu)^(3/2)) (1 + alpha mu^2)/(1 + alpha (1 + 2 g^2)/3)
 *
 * It is Henyey and Greenstein's function at alpha = 0, Cornette and Shanks' at alpha = 1, and
 * Rayleigh's at g = 0, alpha = 1. The mean cosine of the scattering angle is
 *
 *   g (1 + alpha (3 + 2 g^2)/5)/(1 + alpha (1 + 2 g^2)/3)
 *
 * It is integrated in closed form, by a fit, or from a table, by quadrature, if no fit is good
 * enough. At the default of vtkParticipatingMedium::SetPhaseTolerance(), a fit is good enough up to
 * |g| = 0.9 with alpha up to 40, and up to |g| = 0.95 with alpha up to 1. After a change of a
 * parameter, the fit takes about a second.
 *
 * A weighted sum of it and Henyey and Greenstein's function approximates the scattering of water
 * droplets (Jendersie and d'Eon 2023). Add two media in the same region to get such a sum, and give
 * each its share of the scattering coefficient.
 *
 * B. T. Draine: Scattering by Interstellar Dust Grains. I. Optical and Ultraviolet. Astrophysical
 * Journal 598, 2003. J. Jendersie, E. d'Eon: An Approximate Mie Scattering Function for Fog and
 * Cloud Droplets. SIGGRAPH 2023 Talks.
 *
 * @sa vtkPhaseFunction vtkParticipatingMedium
 */

#ifndef vtkDrainePhaseFunction_h
#define vtkDrainePhaseFunction_h

#include "vtkPhaseFunction.h"

class VTKAIRLIGHT_EXPORT vtkDrainePhaseFunction : public vtkPhaseFunction
{
public:
  static vtkDrainePhaseFunction* New();
  vtkTypeMacro(vtkDrainePhaseFunction, vtkPhaseFunction);

  ///@{
  /**
   * The parameter g, without unit: above 0 forward, below 0 backward. Its name is "g". Range:
   * [-0.99, 0.99]. Default: 0.
   */
  void SetAnisotropy(double g) { this->SetParameterAt(0, "Anisotropy", g); }
  double GetAnisotropy() { return this->GetParameterAt(0); }
  ///@}

  ///@{
  /**
   * The weight of mu^2, without unit: the larger it is, the less light is scattered to the side.
   * Its name is "alpha". Range: [0, 100]. Default: 1.
   */
  void SetAlpha(double alpha) { this->SetParameterAt(1, "Alpha", alpha); }
  double GetAlpha() { return this->GetParameterAt(1); }
  ///@}

#ifndef __VTK_WRAP__
  double EvaluateHalfAngle(double s) override;
#endif

protected:
  vtkDrainePhaseFunction();
  ~vtkDrainePhaseFunction() override;

#ifndef __VTK_WRAP__
  std::shared_ptr<const airlight::PhaseShape> MakeShape(double tolerance) override;
#endif

private:
  vtkDrainePhaseFunction(const vtkDrainePhaseFunction&) = delete;
  void operator=(const vtkDrainePhaseFunction&) = delete;
};

#endif
