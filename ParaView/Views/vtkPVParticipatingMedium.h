// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVParticipatingMedium
 * @brief   a vtkParticipatingMedium for panels and state files
 *
 * ParaView sets properties one by one, in any order, and all of them when it loads a state. So what
 * vtkParticipatingMedium derives from several calls in order is here said by values that do not
 * depend on each other: how thick the medium is in one of two ways that COEFFICIENTS chooses
 * between, and an anisotropy that waits where the phase function has none.
 *
 * Bad values are refused with an error, as vtkParticipatingMedium does.
 *
 * @sa vtkPVAirlightRenderView
 */

#ifndef vtkPVParticipatingMedium_h
#define vtkPVParticipatingMedium_h

#include "vtkAirlightParaViewViewsModule.h" // for export macro
#include "vtkParticipatingMedium.h"

class VTKAIRLIGHTPARAVIEWVIEWS_EXPORT vtkPVParticipatingMedium : public vtkParticipatingMedium
{
public:
  static vtkPVParticipatingMedium* New();
  vtkTypeMacro(vtkPVParticipatingMedium, vtkParticipatingMedium);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum ThicknessType
  {
    VISIBILITY = 0,  ///< see SetVisibilityDistance() and SetColor()
    COEFFICIENTS = 1 ///< see SetScatteringCoefficient() and SetAbsorptionCoefficient()
  };

  ///@{
  /**
   * By which of the following numbers the medium is as thick as it is. Default: VISIBILITY.
   */
  void SetThickness(int thickness);
  vtkGetMacro(Thickness, int);
  ///@}

  ///@{
  /**
   * The meteorological range, see vtkParticipatingMedium::SetVisibility(): one sees this far. Unit:
   * world. 0: automatic, see SetSceneSize(). Range: finite, at least 0. Default: 10.
   */
  void SetVisibilityDistance(double distance);
  vtkGetMacro(VisibilityDistance, double);
  ///@}

  ///@{
  /**
   * The diagonal of what is to be seen in the medium, world units. An automatic visibility is
   * 20 times this, or 10 if nothing is known of the scene (0, or a number that is not finite).
   * Default: 0.
   */
  void SetSceneSize(double diagonal);
  vtkGetMacro(SceneSize, double);
  ///@}

  ///@{
  /**
   * The albedo per RGB channel where the thickness is a visibility: the part of the extinction that
   * is scattered. White for fog, grey for smoke. Extinction is the same in all channels. Range: [0,
   * 1]. Default: (1, 1, 1).
   */
  void SetColor(double r, double g, double b);
  vtkGetVector3Macro(Color, double);
  ///@}

  ///@{
  /**
   * The coefficients where the thickness is COEFFICIENTS, see
   * vtkParticipatingMedium::SetScattering() and SetAbsorption(). Unit: 1/world. Range: finite, at
   * least 0. Default: (0.1, 0.1, 0.1) and (0, 0, 0).
   */
  void SetScatteringCoefficient(double r, double g, double b);
  vtkGetVector3Macro(ScatteringCoefficient, double);
  void SetAbsorptionCoefficient(double r, double g, double b);
  vtkGetVector3Macro(AbsorptionCoefficient, double);
  ///@}

  ///@{
  /**
   * The phase function, a vtkParticipatingMedium::PhaseFunctionType but TABULATED, and its
   * anisotropy, which only some of them have. Defaults: ISOTROPIC, 0.
   */
  void SetPhase(int function);
  vtkGetMacro(Phase, int);
  void SetPhaseAnisotropy(double g);
  vtkGetMacro(PhaseAnisotropy, double);
  ///@}

protected:
  vtkPVParticipatingMedium();
  ~vtkPVParticipatingMedium() override;

private:
  vtkPVParticipatingMedium(const vtkPVParticipatingMedium&) = delete;
  void operator=(const vtkPVParticipatingMedium&) = delete;

  bool SetRange(const char* name, const double values[3], double most, double target[3]);
  double GetEffectiveVisibility();
  void UpdateThickness();
  void UpdatePhase();

  int Thickness = VISIBILITY;
  double VisibilityDistance = 10.0;
  double SceneSize = 0.0;
  double Color[3] = { 1.0, 1.0, 1.0 };
  double ScatteringCoefficient[3] = { 0.1, 0.1, 0.1 };
  double AbsorptionCoefficient[3] = { 0.0, 0.0, 0.0 };
  int Phase = ISOTROPIC;
  double PhaseAnisotropy = 0.0;
};

#endif
