// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAirlightProbeFilter
 * @brief   airlight, transmittance, irradiance and visibility at points in media
 *
 * Adds point data to any vtkDataSet, in double precision: on the sensors of a room, on a grid
 * through the air, on the surfaces of a scene. See "Sensors" in Documentation/guide.md.
 *
 * Input port 0: vtkDataSet. Port 1 (optional, repeatable): vtkPolyData whose polygons and strips
 * are opaque occluders, of any orientation, in the coordinates of port 0. Surfaces of port 0 cast
 * no shadows unless they are inputs of port 1, too.
 *
 * Output: the input with these point data, double, RGB, for lights in W/sr and lengths in metres:
 *
 * - Radiance [W/(m^2 sr)]: the radiance that the media between the point and the viewpoint sends
 *   to the viewpoint: the airlight of all lights, with shadows, and the medium's ambient radiance.
 *   Add a surface's radiance times Transmittance.
 * - Transmittance: from the point to the viewpoint.
 * - DirectIrradiance [W/m^2]: from all lights, attenuated by the medium and with shadows. With
 *   point normals, on the side of the normal, I cos(theta)/r^2 T. Without normals, at normal
 *   incidence, I/r^2 T, summed: the power on a small sphere of unit cross-section.
 * - ScatteredIrradiance [W/m^2]: see SetScatteredIrradiance().
 * - MeanExtinction, ReflectingSignVisibility, EmittingSignVisibility, SignContrast,
 *   SignContrastWithoutAirlight, of one component each: see SetSightLines().
 *
 * I is the radiant intensity of vtkAirlight::SetRadiantIntensity(); cone, exponent and attenuation
 * of a vtkLight apply, and a directional light has its irradiance. Normals need not be of length 1;
 * one of length 0, NaN or infinity gives 0. Without lights, Radiance is the ambient one and the
 * irradiances are 0. Occluders between the viewpoint and the point do not hide the medium behind
 * them.
 *
 * Numerical errors: those of vtkAirlight; shadows are exact to rounding. The output does not depend
 * on the number of threads (vtkSMPTools).
 *
 * Errors: no medium, more than 8 of them, or a light with NaN or infinite values, gives an error
 * and the input without the arrays. Points that are NaN, infinite or beyond 1e15 get zeros and a
 * warning.
 *
 * @sa vtkAirlight vtkLitIntervalsFilter vtkAirlightPass
 */

#ifndef vtkAirlightProbeFilter_h
#define vtkAirlightProbeFilter_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkDataSetAlgorithm.h"
#include "vtkSmartPointer.h" // for members

#include <limits> // for members
#include <vector> // for members

class vtkLight;
class vtkParticipatingMedium;
class vtkPolyData;

class VTKAIRLIGHT_EXPORT vtkAirlightProbeFilter : public vtkDataSetAlgorithm
{
public:
  static vtkAirlightProbeFilter* New();
  vtkTypeMacro(vtkAirlightProbeFilter, vtkDataSetAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The lights, each once. GetLight() returns null for an index outside 0 to GetNumberOfLights() -
   * 1. Default: none.
   */
  void AddLight(vtkLight* light);
  void RemoveLight(vtkLight* light);
  void RemoveAllLights();
  int GetNumberOfLights();
  vtkLight* GetLight(int index);
  ///@}

  ///@{
  /**
   * The media, each once, at most 8 of any kind; where they overlap, their coefficients add.
   * SetMedium() replaces all of them, null removes them. GetMedium() returns null for an index
   * outside 0 to GetNumberOfMedia() - 1. Default: none.
   */
  void AddMedium(vtkParticipatingMedium* medium);
  void RemoveMedium(vtkParticipatingMedium* medium);
  void RemoveAllMedia();
  void SetMedium(vtkParticipatingMedium* medium);
  int GetNumberOfMedia();
  vtkParticipatingMedium* GetMedium(int index);
  vtkParticipatingMedium* GetMedium() { return this->GetMedium(0); }
  ///@}

  ///@{
  /**
   * The position of the eye, world units. Range: finite, at most 1e15 from the origin. Default: (0,
   * 0, 0).
   */
  void SetViewpoint(double x, double y, double z);
  void SetViewpoint(const double viewpoint[3]);
  vtkGetVector3Macro(Viewpoint, double);
  ///@}

  ///@{
  /**
   * Whether ScatteredIrradiance is computed: the irradiance on the side of the point's normal from
   * light that the medium scattered once on its way to the point. It is unshadowed and excludes
   * ambient radiance. The quadrature and its error (0.3 % to 3 %) are those of
   * vtkAirlightPass::SetScatteredSurfaceLight(), in double precision, with 16 to 1597 rays per
   * point and light. It needs point normals and media that are uniform or of exponential height;
   * otherwise there is a warning and no array. With
   * vtkParticipatingMedium::SetMultipleScattering() it is the light of point lamps that was
   * scattered at least once, however often, and 0 of other lights. Default: false.
   */
  vtkSetMacro(ScatteredIrradiance, bool);
  vtkGetMacro(ScatteredIrradiance, bool);
  vtkBooleanMacro(ScatteredIrradiance, bool);
  ///@}

  ///@{
  /**
   * Whether arrays are added that say how far an eye sees towards each point, and how well it sees
   * a sign there:
   *
   * - MeanExtinction [1/world unit]: the mean of the three channels' extinctions, averaged along
   *   the straight way from the viewpoint to the point. At the viewpoint, that there.
   * - ReflectingSignVisibility, EmittingSignVisibility [world unit]: a constant K over
   *   MeanExtinction, the distance at which a sign can just be read in such smoke (Jin 1978). A
   *   sign at the point can be read from the viewpoint if its distance is at most this.
   * - SignContrast: Michelson's contrast (letters - ground)/(letters + ground) of a sign at the
   *   point, as it is seen at the viewpoint through the media and their airlight. 0 is a sign that
   *   is not seen; a contrast of 2 % with a background (Weber's) is one of 1 % here.
   * - SignContrastWithoutAirlight: the same if the media scattered no light to the eye.
   *
   * All are exact but for rounding and the error of Radiance. Default: false.
   */
  vtkSetMacro(SightLines, bool);
  vtkGetMacro(SightLines, bool);
  vtkBooleanMacro(SightLines, bool);
  ///@}

  ///@{
  /**
   * K of signs that reflect the light of lamps, and of signs that shine: visibility times
   * extinction, without unit. Measured: 2 to 4 and 5 to 10 (T. Jin, "Visibility through fire
   * smoke", J. Fire & Flammability 9, 1978); for smoke that does not irritate the eyes. Range:
   * finite, above 0. Defaults: 3 and 8.
   */
  void SetReflectingSignConstant(double constant);
  vtkGetMacro(ReflectingSignConstant, double);
  void SetEmittingSignConstant(double constant);
  vtkGetMacro(EmittingSignConstant, double);
  ///@}

  ///@{
  /**
   * Visibilities above this are cut off, world unit: those through clear air would be infinite.
   * Range: above 0. Default: infinity.
   */
  void SetMaximumVisibility(double distance);
  vtkGetMacro(MaximumVisibility, double);
  ///@}

  ///@{
  /**
   * The sign of SignContrast: the radiance of letters that shine [W/(m^2 sr)], and the diffuse
   * reflectances of the letters and of the ground that they stand on, which DirectIrradiance
   * lights. Ranges: 0 to 1e100; 0 to 1. Defaults: 0 (a sign that is lit), 0.8 and 0.1.
   */
  void SetSignRadiance(double radiance);
  vtkGetMacro(SignRadiance, double);
  void SetSignReflectance(double reflectance);
  vtkGetMacro(SignReflectance, double);
  void SetSignGroundReflectance(double reflectance);
  vtkGetMacro(SignGroundReflectance, double);
  ///@}

  ///@{
  /**
   * Occluders nearer to a point or a light than this fraction of their largest coordinate do not
   * shadow the point. The rounded position of a point on a surface is off its triangles, in single
   * precision by 1e-7 of its coordinates. For DirectIrradiance only. Range: [0, 1]. Default: 1e-6.
   */
  vtkSetClampMacro(ShadowTolerance, double, 0.0, 1.0);
  vtkGetMacro(ShadowTolerance, double);
  ///@}

  ///@{
  /**
   * An occluder for port 1. AddInputConnection(1, port) adds one that stays up to date.
   */
  void AddOccluderData(vtkPolyData* data);
  void RemoveAllOccluders();
  ///@}

  /**
   * The last modification of the filter, its lights or its media.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkAirlightProbeFilter();
  ~vtkAirlightProbeFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkAirlightProbeFilter(const vtkAirlightProbeFilter&) = delete;
  void operator=(const vtkAirlightProbeFilter&) = delete;

  bool CheckSettings();
  bool SetNumber(const char* name, double& target, double value, bool accepted, const char* range);
  bool CanScatter(bool hasNormals);

  std::vector<vtkSmartPointer<vtkLight>> Lights;
  std::vector<vtkSmartPointer<vtkParticipatingMedium>> Media;
  double Viewpoint[3] = { 0.0, 0.0, 0.0 };
  bool ScatteredIrradiance = false;
  double ShadowTolerance = 1e-6;
  bool SightLines = false;
  double ReflectingSignConstant = 3.0;
  double EmittingSignConstant = 8.0;
  double MaximumVisibility = std::numeric_limits<double>::infinity();
  double SignRadiance = 0.0;
  double SignReflectance = 0.8;
  double SignGroundReflectance = 0.1;
};

#endif
