// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAirlightProbeFilter
 * @brief   airlight, transmittance and irradiance at points in a medium
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
 * - Radiance [W/(m^2 sr)]: the radiance that the medium between the point and the viewpoint sends
 *   to the viewpoint: the airlight of all lights, with shadows, and the medium's ambient radiance.
 *   Add a surface's radiance times Transmittance.
 * - Transmittance: from the point to the viewpoint.
 * - DirectIrradiance [W/m^2]: from all lights, attenuated by the medium and with shadows. With
 *   point normals, on the side of the normal, I cos(theta)/r^2 T. Without normals, at normal
 *   incidence, I/r^2 T, summed: the power on a small sphere of unit cross-section.
 * - ScatteredIrradiance [W/m^2]: see SetScatteredIrradiance().
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
 * Errors: a missing medium, or a light with NaN or infinite values, gives an error and the input
 * without the arrays. Points that are NaN, infinite or beyond 1e15 get zeros and a warning.
 *
 * @sa vtkAirlight vtkLitIntervalsFilter vtkAirlightPass
 */

#ifndef vtkAirlightProbeFilter_h
#define vtkAirlightProbeFilter_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkDataSetAlgorithm.h"
#include "vtkSmartPointer.h" // for members

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
   * The medium. Default: none.
   */
  void SetMedium(vtkParticipatingMedium* medium);
  vtkParticipatingMedium* GetMedium();
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
   * point and light. It needs point normals and a medium that is uniform or of exponential height;
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
   * The last modification of the filter, its lights or its medium.
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
  bool CanScatter(bool hasNormals);

  std::vector<vtkSmartPointer<vtkLight>> Lights;
  vtkSmartPointer<vtkParticipatingMedium> Medium;
  double Viewpoint[3] = { 0.0, 0.0, 0.0 };
  bool ScatteredIrradiance = false;
  double ShadowTolerance = 1e-6;
};

#endif
