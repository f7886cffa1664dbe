// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAirlight
 * @brief   single scattering along a ray, in double precision; units of lights
 *
 * Computes airlight, transmittance and ambient light of single rays with the source text of
 * vtkAirlightPass's shaders, compiled in double precision. SetRadiantIntensity() and
 * SetIrradiance() give a vtkLight physical units. See Documentation/guide.md.
 *
 * A ray starts at `origin` (the eye) and runs along `direction`, of any length above 0, which is
 * normalised. t is the distance from the origin in world units. Radiance is in W/(m^2 sr) per RGB
 * channel if lights are in W/sr and lengths in metres.
 *
 * All functions are static. They are thread safe while nobody changes the medium; call its
 * GetPhaseErrorBound() once before, which fits the phase function, and with multiple scattering
 * GetMultipleScatteringErrorBound().
 *
 * Errors: values that are infinite, NaN or above 1e100, a direction of length 0 and a null medium
 * give an error that names the value, a result of zeros, and the return value false. A reversed or
 * empty interval gives zeros and true.
 *
 * Source: V. Biri, D. Arques and S. Michelin, "Real Time Rendering of Atmospheric Scattering and
 * Volumetric Shadows", WSCG 2006 (closed form), evaluated with the complex exponential integral
 * instead of a table; see Documentation/physics.md.
 *
 * @sa vtkParticipatingMedium vtkAirlightPass
 */

#ifndef vtkAirlight_h
#define vtkAirlight_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkObject.h"

class vtkLight;
class vtkParticipatingMedium;
class vtkTexture;

class VTKAIRLIGHT_EXPORT vtkAirlight : public vtkObject
{
public:
  static vtkAirlight* New();
  vtkTypeMacro(vtkAirlight, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The airlight that reaches `origin` from the part [t0, t1] of the ray, of a point light of
   * radiant intensity `radiantIntensity` [W/sr] at `lightPosition`, unshadowed: the integral of
   * sigma_s p(cosTheta) I/r^2 exp(-sigma_t (lengths inside the medium)) dt. t0 is clamped at 0; t1
   * may be infinite.
   *
   * Relative error: 1e-9 in a uniform medium that is unbounded or a box or sphere that contains the
   * light; otherwise, and with Mie's phase functions or a table that no fit matches, 1e-6 by
   * quadrature; 1e-5 with density images, 5e-5 if the medium's region cuts the image. The error of
   * the phase function, at most vtkParticipatingMedium::GetPhaseErrorBound(), is added to all of
   * these.
   */
  static bool Inscatter(vtkParticipatingMedium* medium, const double lightPosition[3],
    const double radiantIntensity[3], const double origin[3], const double direction[3], double t0,
    double t1, double rgb[3]);

  /**
   * The same for a vtkLight: a point light or spotlight with any attenuation, or a directional
   * light. A directional light in an unbounded uniform medium arrives unattenuated. A light that is
   * switched off gives zeros. Photometric files are ignored.
   *
   * Relative error (plus that of the phase function): 1e-9 for point lights and spotlights of
   * exponent 0 with attenuation (0, 0, c) under the conditions of the function above, and for
   * directional lights in a box or unbounded; 1e-6 by quadrature for all others.
   */
  static bool Inscatter(vtkParticipatingMedium* medium, vtkLight* light, const double origin[3],
    const double direction[3], double t0, double t1, double rgb[3]);

  /**
   * Light of a point lamp that was scattered more than once and reaches `origin` from [0, t1] of
   * the ray, of radiant intensity `radiantIntensity` [W/sr]: see
   * vtkParticipatingMedium::SetMultipleScattering(), which must be on; else zeros. t1 may be
   * infinite. A lamp outside the medium's region needs a phase function whose mean cosine is at
   * most 0.65; else there is an error, and zeros.
   *
   * Relative error in an unbounded medium: GetMultipleScatteringErrorBound() of the medium, and of
   * the quadrature 0.5 % of this plus the light that was scattered once.
   */
  static bool MultipleScattering(vtkParticipatingMedium* medium, const double lightPosition[3],
    const double radiantIntensity[3], const double origin[3], const double direction[3], double t1,
    double rgb[3]);

  /**
   * The irradiance [W/m^2] that light of the same lamp which was scattered at least once brings to
   * a surface at `point`: a quarter of its fluence and half of its flux against the normal, whose
   * length does not matter. Faces of the medium's region and casters are
   * left out of account. It replaces what vtkAirlightPass::SetScatteredSurfaceLight() adds.
   */
  static bool MultipleIrradiance(vtkParticipatingMedium* medium, const double lightPosition[3],
    const double radiantIntensity[3], const double point[3], const double normal[3], double rgb[3]);

  /**
   * The radiance of a black body at a temperature [K] in linear sRGB, W/(m^2 sr): Planck's law seen
   * by the CIE 1931 observer (the fits of Wyman, Sloan and Shirley, JCGT 2013, good to some per
   * cent), so that the luminance is 683 (0.2126 r + 0.7152 g + 0.0722 b) cd/m^2. Colours outside of
   * sRGB, as those below 1900 K, lose their negative part. Times the absorption it is
   * vtkParticipatingMedium::SetEmission() of gas in thermal equilibrium. False and zeros unless the
   * temperature is finite and above 0.
   */
  static bool BlackbodyRadiance(double temperature, double rgb[3]);

  /**
   * The fraction of light that passes from point a to point b, per RGB channel: exp(-sigma_t *
   * integral of the density inside the medium).
   */
  static bool Transmittance(
    vtkParticipatingMedium* medium, const double a[3], const double b[3], double rgb[3]);

  /**
   * The ambient light that the medium scatters into the ray on [0, t1] and what it emits: (albedo *
   * L_ambient + emission / extinction) * (1 - transmittance), with L_ambient that of the ray's
   * direction if the medium has a sky. t1 may be infinite. Without the ambient light if the medium
   * has multiple scattering, which takes its place.
   */
  static bool Ambient(vtkParticipatingMedium* medium, const double origin[3],
    const double direction[3], double t1, double rgb[3]);

  /**
   * The coefficients for vtkParticipatingMedium::SetSkyHarmonics() of an equirectangular texture as
   * VTK orients it, with the renderer's EnvironmentUp and EnvironmentRight. Each texel has its
   * radiance on its part of the sphere: floating point numbers as they are, integers as parts of
   * their largest value, bytes decoded from sRGB if the texture's UseSRGBColorSpace is on; texels
   * below 0 or not finite are dark. False, zeros and an error of the texture without an image, for
   * a cube map, and for vectors that are 0, parallel or not finite.
   */
  static bool EnvironmentHarmonics(
    vtkTexture* texture, const double up[3], const double right[3], double coefficients[27]);

  ///@{
  /**
   * Physical units of a vtkLight. VTK shades a white diffuse surface under a light of colour *
   * intensity c as c * cos(theta), without 1/pi, while a Lambertian surface of albedo 1 has the
   * radiance E/pi * cos(theta): so c = E/pi. A point light with attenuation (0, 0, 1) therefore has
   * the radiant intensity I = pi * c [W/sr], and a directional light the irradiance E = pi * c
   * [W/m^2] on a plane that faces it. With another attenuation a + b r + c r^2, a light has I(r) =
   * pi * colour * intensity * r^2/(a + b r + c r^2).
   *
   * SetRadiantIntensity() switches the light on and makes it a point light (positional, cone angle
   * 180, attenuation (0, 0, 1)) of this radiant intensity. SetIrradiance() makes it directional.
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
