// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAirlight
 * @brief   single scattering along a ray, as numbers, in double precision
 *
 * The CPU twin of the shaders of vtkAirlightPass: the same source text, compiled in double
 * precision. All functions are static and thread safe as long as nobody changes the medium
 * meanwhile (ask the medium for GetPhaseErrorBound() once before using it from several threads:
 * that makes it fit its phase function).
 *
 * Symbols: a ray starts at `origin` (the eye) and runs along `direction` (any length above 0; it
 * is normalised). t is the distance from the origin in world units. Radiance is in W/(m^2 sr) per
 * RGB channel when lights are given in W/sr and lengths in metres.
 *
 * Errors: values that are not finite or above 1e100, a direction of length 0 or a null medium give an
 * error that names the value, an answer of zeros, and the return value false. A reversed or empty interval
 * gives zeros and true.
 *
 * Source: the closed form of V. Biri, D. Arques and S. Michelin, "Real Time Rendering of
 * Atmospheric Scattering and Volumetric Shadows", WSCG 2006, evaluated here through the complex
 * exponential integral instead of a table.
 *
 * @sa vtkParticipatingMedium vtkAirlightPass
 */

#ifndef vtkAirlight_h
#define vtkAirlight_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkObject.h"

class vtkLight;
class vtkParticipatingMedium;

class VTKAIRLIGHT_EXPORT vtkAirlight : public vtkObject
{
public:
  static vtkAirlight* New();
  vtkTypeMacro(vtkAirlight, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Airlight that reaches `origin` from the part [t0, t1] of the ray, of a point light of radiant
   * intensity `radiantIntensity` [W/sr] at `lightPosition`, unshadowed:
   * the integral of sigma_s p(cosTheta) I/r^2 exp(-sigma_t (lengths inside the medium)) dt.
   * t0 is clamped at 0. t1 may be infinite. Relative error: 1e-9 in a uniform medium that is
   * unbounded or a box or sphere that holds the light, and 1e-6 by quadrature in all others, and
   * with Mie's phase functions or a table that no fit follows; 1e-5 with densities from images,
   * 5e-5 where the medium's region cuts the image; to
   * all comes at most vtkParticipatingMedium::GetPhaseErrorBound().
   */
  static bool Inscatter(vtkParticipatingMedium* medium, const double lightPosition[3],
    const double radiantIntensity[3], const double origin[3], const double direction[3], double t0,
    double t1, double rgb[3]);

  /**
   * The same for a vtkLight: a point light or spot with any attenuation, or a directional light. A
   * directional light in an unbounded uniform medium arrives unattenuated. A light that is switched
   * off gives zeros. Photometric files belong to a vtkAirlightPass and are not known here. Relative
   * error (plus the phase function's): 1e-9 for point lights and spots of exponent 0 with attenuation
   * (0, 0, c) where the function above has it, for directional lights in a box or unbounded; 1e-6 for
   * all others, which take quadrature.
   */
  static bool Inscatter(vtkParticipatingMedium* medium, vtkLight* light, const double origin[3],
    const double direction[3], double t0, double t1, double rgb[3]);

  /**
   * Fraction of light that passes from point a to point b, per RGB channel:
   * exp(-sigma_t * integral of the density inside the medium).
   */
  static bool Transmittance(
    vtkParticipatingMedium* medium, const double a[3], const double b[3], double rgb[3]);

  /**
   * Ambient light scattered into the ray on [0, t1] by the medium's ambient radiance:
   * albedo * L_ambient * (1 - transmittance). t1 may be infinite.
   */
  static bool Ambient(vtkParticipatingMedium* medium, const double origin[3],
    const double direction[3], double t1, double rgb[3]);

  ///@{
  /**
   * The lamp that a vtkLight stands for, and back. VTK shows a white diffuse surface under a light
   * of colour * intensity c as c * cos(theta), with no 1/pi, where a Lambertian surface of albedo
   * 1 shows E/pi * cos(theta): so c = E/pi. A point light with attenuation (0, 0, 1) therefore has
   * the radiant intensity I = pi * c [W/sr], and a directional light the irradiance E = pi * c
   * [W/m^2] on a plane that faces it. With another attenuation a + b r + c r^2 the light has
   * I(r) = pi * colour * intensity * r^2/(a + b r + c r^2).
   *
   * SetRadiantIntensity() makes the light a switched-on point light (positional, cone angle 180,
   * attenuation (0, 0, 1)) of this radiant intensity; SetIrradiance() makes it directional.
   * GetRadiantIntensity() returns pi * colour * intensity.
   */
  static void SetRadiantIntensity(vtkLight* light, const double rgb[3]);
  static void GetRadiantIntensity(vtkLight* light, double rgb[3]);
  static void SetIrradiance(vtkLight* light, const double rgb[3]);
  ///@}

protected:
  vtkAirlight() = default;
  ~vtkAirlight() override = default;

private:
  vtkAirlight(const vtkAirlight&) = delete;
  void operator=(const vtkAirlight&) = delete;
};

#endif
