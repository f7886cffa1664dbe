// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkPVParticipatingMedium
 * @brief   a vtkParticipatingMedium for panels and state files
 *
 * ParaView sets properties one by one, in any order, and all of them when it loads a state.
 * vtkParticipatingMedium derives some values from calls in order; this class replaces these by
 * independent properties: the thickness, in one of two ways, and an anisotropy that is ignored
 * while the phase function has none.
 *
 * Invalid values give an error and the old value is kept, as in vtkParticipatingMedium.
 *
 * @sa vtkPVAirlightRenderView
 */

#ifndef vtkPVParticipatingMedium_h
#define vtkPVParticipatingMedium_h

#include "vtkAirlightParaViewViewsModule.h" // for export macro
#include "vtkDrainePhaseFunction.h"         // for the phase function
#include "vtkNew.h"                         // for the phase function
#include "vtkParticipatingMedium.h"

#include <memory> // for the lengths

namespace airlight
{
class SceneLengths;
}

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
   * Which of the following properties determine the extinction. Default: VISIBILITY.
   */
  void SetThickness(int thickness);
  vtkGetMacro(Thickness, int);
  ///@}

  ///@{
  /**
   * The meteorological range, see vtkParticipatingMedium::SetVisibility(), in world units. 0:
   * automatic, see SetSceneBounds() and SetAutomaticVisibility(). Range: finite, at least 0.
   * Default: 10.
   */
  void SetVisibilityDistance(double distance);
  vtkGetMacro(VisibilityDistance, double);
  ///@}

  ///@{
  /**
   * The bounds of the visible data in the medium, world units, which automatic lengths follow: an
   * automatic visibility is 13.7 times their diagonal, or 10 if they are unknown (infinite, NaN,
   * empty or a point): half of the light of the data's far end is left at the camera's first place.
   * The size is that diagonal, 0 if it is unknown. Default: unknown.
   */
  void SetSceneBounds(const double bounds[6]);
  vtkGetMacro(SceneSize, double);
  ///@}

  ///@{
  /**
   * The visibility while VisibilityDistance is 0, world units, in place of that of the scene. 0:
   * none. Range: finite, at least 0. Default: 0.
   */
  void SetAutomaticVisibility(double distance);
  vtkGetMacro(AutomaticVisibility, double);
  ///@}

  ///@{
  /**
   * Lengths of the region, world units. 0 is automatic: the box of six zeros is the scene's bounds
   * and 5 % of their diagonal on each side; the sphere is that through the corners of the bounds
   * and the cylinder that round them, with the scene's centre in place of the given one; the
   * cylinder's height is how long the bounds are along its axis. In an unknown scene they are -1 to
   * 1 along each axis, the radius 1 and the height 1. Ranges: those of SetBounds(), SetCenter(),
   * SetRadius() and SetHeight() of vtkParticipatingMedium. Defaults: 0.
   */
  void SetRegionBounds(
    double xmin, double xmax, double ymin, double ymax, double zmin, double zmax);
  void SetRegionCenter(double x, double y, double z);
  void SetRegionRadius(double radius);
  void SetRegionHeight(double height);
  ///@}

  ///@{
  /**
   * Heights of the density, world units. The scale height 0 is automatic: half of how high the
   * scene is along SetUp(), with the scene's lower end in place of the reference height; 1 in an
   * unknown scene. Ranges: those of SetScaleHeight() and SetReferenceHeight() of
   * vtkParticipatingMedium. Defaults: 0.
   */
  void SetDensityScaleHeight(double height);
  void SetDensityReferenceHeight(double height);
  ///@}

  ///@{
  /**
   * The albedo per RGB channel if the thickness is a visibility: the fraction of the extinction
   * that is scattered. White for fog, grey for smoke. Extinction is the same in all channels.
   * Range: [0, 1]. Default: (1, 1, 1).
   */
  void SetColor(double r, double g, double b);
  vtkGetVector3Macro(Color, double);
  ///@}

  ///@{
  /**
   * The coefficients if the thickness is COEFFICIENTS, see vtkParticipatingMedium::SetScattering()
   * and SetAbsorption(). Unit: 1/world. Range: finite, at least 0. Default: (0.1, 0.1, 0.1) and (0,
   * 0, 0).
   */
  void SetScatteringCoefficient(double r, double g, double b);
  vtkGetVector3Macro(ScatteringCoefficient, double);
  void SetAbsorptionCoefficient(double r, double g, double b);
  vtkGetVector3Macro(AbsorptionCoefficient, double);
  ///@}

  ///@{
  /**
   * Light that arrives evenly from all directions, see
   * vtkParticipatingMedium::SetAmbientRadiance(). (0, 0, 0): automatic, see SetBackground(). Range:
   * 0 to 1e100. Default: (0, 0, 0).
   */
  void SetAmbient(double r, double g, double b);
  vtkGetVector3Macro(Ambient, double);
  ///@}

  ///@{
  /**
   * Whether an ambient radiance of (0, 0, 0) is replaced by 0.55 of the background's colour, which
   * a view sets: the sky over fog is brighter than the fog. Default: true, black.
   */
  void SetAmbientFromBackground(bool on);
  vtkGetMacro(AmbientFromBackground, bool);
  void SetBackground(const double rgb[3]);
  vtkGetVector3Macro(Background, double);
  ///@}

  ///@{
  /**
   * The phase function, a vtkParticipatingMedium::PhaseFunctionType except TABULATED, or OBJECT for
   * Draine's; and its parameters, which only some of them have: see SetAnisotropy() and
   * vtkDrainePhaseFunction::SetAlpha(). Defaults: HENYEY_GREENSTEIN, 0.5, 1.
   */
  void SetPhase(int function);
  vtkGetMacro(Phase, int);
  void SetPhaseAnisotropy(double g);
  vtkGetMacro(PhaseAnisotropy, double);
  void SetPhaseAlpha(double alpha);
  vtkGetMacro(PhaseAlpha, double);
  ///@}

  ///@{
  /**
   * Takes a surface or an image whose contents are replaced now and then, as those of a pipeline
   * source. SetSurface() and SetDensityImage() keep the old one if the new one is invalid; here the
   * medium is ignored while it is, with an error when the medium is used. Null: none.
   */
  void FollowSurface(vtkPolyData* surface);
  void FollowDensityImage(vtkImageData* image);
  ///@}

protected:
  vtkPVParticipatingMedium();
  ~vtkPVParticipatingMedium() override;

private:
  vtkPVParticipatingMedium(const vtkPVParticipatingMedium&) = delete;
  void operator=(const vtkPVParticipatingMedium&) = delete;

  void TakeDistance(const char* name, double value, double& distance);
  bool SetRange(const char* name, const double values[3], double most, double target[3]);
  void TakeLength(double value, double& length, void (vtkParticipatingMedium::*set)(double),
    double (vtkParticipatingMedium::*get)());
  double GetEffectiveVisibility();
  void UpdateThickness();
  void UpdateAmbient();
  void UpdatePhase();

  int Thickness = VISIBILITY;
  double VisibilityDistance = 10.0;
  double SceneSize = 0.0;
  double AutomaticVisibility = 0.0;
  std::unique_ptr<airlight::SceneLengths> Lengths;
  double Color[3] = { 1.0, 1.0, 1.0 };
  double ScatteringCoefficient[3] = { 0.1, 0.1, 0.1 };
  double AbsorptionCoefficient[3] = { 0.0, 0.0, 0.0 };
  double Ambient[3] = { 0.0, 0.0, 0.0 };
  bool AmbientFromBackground = true;
  double Background[3] = { 0.0, 0.0, 0.0 };
  int Phase = HENYEY_GREENSTEIN;
  double PhaseAnisotropy = 0.5;
  double PhaseAlpha = 1.0;
  vtkNew<vtkDrainePhaseFunction> Draine;
};

#endif
