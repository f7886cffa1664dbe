// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAirlightLight
 * @brief   properties of a vtkLight that VTK does not have
 *
 * Units, scattering, photometric files and extents of lights. The properties are stored in the
 * light itself (vtkLight::GetInformation()), so that everything that meets the light uses the same:
 * passes, mappers, vtkAirlightReference. vtkLight::DeepCopy() copies them. All functions are
 * static.
 *
 * Errors: a null light and invalid values give an error, and the old value is kept.
 *
 * @sa vtkAirlight vtkAirlightPass
 */

#ifndef vtkAirlightLight_h
#define vtkAirlightLight_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkObject.h"

class vtkLight;

class VTKAIRLIGHT_EXPORT vtkAirlightLight : public vtkObject
{
public:
  static vtkAirlightLight* New();
  vtkTypeMacro(vtkAirlightLight, vtkObject);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Physical units: W/sr and W/m^2 per RGB channel. The same functions as in vtkAirlight, which
   * documents them.
   */
  static void SetRadiantIntensity(vtkLight* light, const double rgb[3]);
  static void GetRadiantIntensity(vtkLight* light, double rgb[3]);
  static void SetIrradiance(vtkLight* light, const double rgb[3]);
  ///@}

  ///@{
  /**
   * Whether media scatter this light. When off, the light illuminates surfaces only, attenuated by
   * the medium. Lights fixed to the scene then still cast shadows on surfaces; lights fixed to the
   * camera (headlights, camera lights, those of vtkLightKit, and the light that a renderer creates
   * by itself) cast none. Default: true for lights fixed to the scene, false for lights fixed to
   * the camera. A warning counts those that a medium leaves out, until this is called for them.
   */
  static void SetScatters(vtkLight* light, bool scatters);
  static bool GetScatters(vtkLight* light);
  ///@}

  ///@{
  /**
   * Makes a positional light emit as a photometric file of IES LM-63 (*.ies) says, for medium and
   * surfaces: colour and intensity of the light are those of the brightest direction, and the file
   * gives the fraction in all others. The light aims from its position at its focal point.
   * Photometric types A, B and C, linear between the file's angles, zero beyond them; the light is
   * a point, its tilt is ignored. A spotlight's cone and exponent also apply. Airlight is
   * integrated by quadrature, within 1e-3, cell by cell of the file's table. Directional lights,
   * and lights whose focal point is their position, ignore the file, with one warning. Photometric
   * files apply in vtkAirlightPass and vtkAirlightReference only.
   *
   * Returns false, with an error that names file, line and cause, for an invalid file; the light is
   * then unchanged. Null or an empty name removes the file, the default.
   */
  static bool SetPhotometry(vtkLight* light, const char* file);
  static const char* GetPhotometry(vtkLight* light);
  ///@}

  /**
   * The largest intensity in the light's photometric file, candela; 0 without one. For
   * SetRadiantIntensity() with the intensity of the file.
   */
  static double GetPhotometryMaximum(vtkLight* light);

  ///@{
  /**
   * The rotation of the photometric file about the light's axis: the direction, made perpendicular
   * to the axis, of its horizontal angle 0 (type C, counted counter-clockwise when looking along
   * the axis) or of its vertical angle 90 (types A and B). World coordinates; for headlights and
   * camera lights those of the camera. Range: finite, not 0. Default: (0, 1, 0), or (0, 0, 1) if
   * that is along the axis.
   */
  static void SetPhotometryUp(vtkLight* light, double x, double y, double z);
  static void GetPhotometryUp(vtkLight* light, double up[3]);
  ///@}

  ///@{
  /**
   * The extent of a lamp, which shines by the same intensity from all its points: soft borders of
   * shadows in the medium and on surfaces. vtkAirlightPass takes another point of it for each of
   * its SubpixelFrames; with one frame, and in everything else, a lamp is a point. The points are
   * those of
   *
   * - a rectangle of SetSize() across the light's axis, its height along SetPhotometryUp();
   * - without a size, a disc of SetRadius() across the axis, for spotlights and photometric files;
   * - a ball of SetRadius() for other positional lights, dense towards its surface such that it
   *   looks evenly bright from afar, as a sphere that emits by Lambert's law does;
   * - a disc of SetAngularDiameter() in the sky, for directional lights, whose irradiance is that
   *   of a surface across the direction of each point.
   *
   * Lights that are fixed to the camera are points, and all lights while the pass has silhouettes
   * of other processes. A light whose focal point is its position has no axis. The pass moves the
   * light for each frame, and back, which invokes its ModifiedEvent. Radius and size in world
   * units, the angle in degrees (the sun: 0.53). Range: finite, at least 0; the angle below 180.
   * Default: 0.
   */
  static void SetRadius(vtkLight* light, double radius);
  static double GetRadius(vtkLight* light);
  static void SetSize(vtkLight* light, double width, double height);
  static void GetSize(vtkLight* light, double size[2]);
  static void SetAngularDiameter(vtkLight* light, double degrees);
  static double GetAngularDiameter(vtkLight* light);
  ///@}

  ///@{
  /**
   * Whether vtkAirlightPass shows a lamp of a radius or a size as a bright, even shape: its ball,
   * disc or rectangle, in its middle place; and a directional light of an angular diameter as a
   * disc in the sky. Its radiance is the radiant intensity, for a spotlight
   * that towards the eye, over the area: pi R^2, or width times height; a photometric file counts
   * by its brightest direction. The shape is fogged and occluded as surfaces are, casts no shadow,
   * is no prop of the renderer, has no part in vtkRenderer::ResetCamera(), and is not picked; the
   * pass widens the camera's clipping range for it while it draws, and depths of the window are
   * those of the wider range. A spotlight is seen from within its cone, a ball from outside.
   *
   * A sun's radiance is its irradiance over the solid angle of its disc. It is behind everything,
   * and fogged by the media on the whole ray: an unbounded uniform medium hides it. It belongs to
   * the background in recorded buffers. Parallel projections do not show it, nor suns after the
   * first 16. A disc smaller than a pixel is seen only where a ray meets it.
   *
   * Points, suns without a diameter and lights fixed to the camera show nothing. The pass warns
   * once of these, and of suns that an unbounded medium, a parallel projection or their number
   * hides, with the reason and the remedy. Default: false.
   */
  static void SetVisible(vtkLight* light, bool visible);
  static bool GetVisible(vtkLight* light);
  ///@}

protected:
  vtkAirlightLight() = default;
  ~vtkAirlightLight() override = default;

private:
  vtkAirlightLight(const vtkAirlightLight&) = delete;
  void operator=(const vtkAirlightLight&) = delete;
};

#endif
