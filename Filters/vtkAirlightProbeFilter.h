// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAirlightProbeFilter
 * @brief   what lamps in a medium do at points: airlight, transmittance and irradiance
 *
 * Adds point data to any vtkDataSet. Where vtkAirlightPass draws a picture, this gives the numbers
 * behind it, in double precision: on the sensors of a room, on a grid through the air, on the
 * surfaces of a scene.
 *
 * Input port 0: vtkDataSet. Port 1 (optional, repeatable): vtkPolyData whose polygons and strips
 * are opaque, whichever way they are wound, in the coordinates of port 0; the surfaces of
 * port 0 shade nothing unless they are given here, too.
 *
 * Output: the input with these point data, double, RGB. With lamps in W/sr and lengths in metres:
 *
 *  - Radiance [W/(m^2 sr)]: what the medium between the point and the viewpoint sends to the
 *    viewpoint: the airlight of all lights, with shadows, and the medium's ambient radiance. A
 *    surface seen there comes on top, times Transmittance.
 *  - Transmittance: from the point to the viewpoint.
 *  - DirectIrradiance [W/m^2]: from all lights, attenuated by the medium and with shadows. With
 *    point normals on the side of the normal, I cos(theta)/r^2 T. Without them at normal incidence,
 *    I/r^2 T, summed: what a small sphere of unit cross-section catches.
 *  - ScatteredIrradiance [W/m^2]: see SetScatteredIrradiance().
 *
 * I and 1/r^2 stand for what vtkAirlight::SetRadiantIntensity() says of a vtkLight: its cone,
 * exponent and attenuation count; a directional light has its irradiance. Normals need not be of
 * length 1; one of length 0, or not finite, gives 0.
 *
 * Occluders between the viewpoint and the point hide nothing: the medium before and behind them is
 * summed. Errors: those of vtkAirlight; shadows come from the triangles
 * themselves, to rounding.
 *
 * A light counts where it stands, with its transform matrix; a headlight, too, casts shadows here.
 * Photometric files belong to a vtkAirlightPass and are not known here. Without lights, Radiance is
 * the ambient one, and the irradiances are 0.
 *
 * Bad input: no medium, or a light whose numbers are no good give an error, and the input comes out
 * without the arrays. Points that are not finite or beyond 1e15 get zeros and a warning.
 *
 * The same output whatever the number of threads (vtkSMPTools).
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
   * The lights, each once. Default: none. GetLight() gives null for a number outside 0 to
   * GetNumberOfLights() - 1.
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
   * Where the eye is, world units. Range: finite, at most 1e15 from the origin. Default: (0, 0, 0).
   */
  void SetViewpoint(double x, double y, double z);
  void SetViewpoint(const double viewpoint[3]);
  vtkGetVector3Macro(Viewpoint, double);
  ///@}

  ///@{
  /**
   * Whether ScatteredIrradiance is computed: the irradiance on the side of the point's normal from
   * light that the medium scattered once on its way to it. Unshadowed and without ambient radiance,
   * the same quadrature as vtkAirlightPass::SetScatteredSurfaceLight(), which states its error
   * (0.3 % to 3 %), here in double precision. It needs point normals and a uniform medium or one
   * of exponential height; otherwise there is a warning and no array. Costs 16 to 1597 rays per
   * point and light. Default: false.
   */
  vtkSetMacro(ScatteredIrradiance, bool);
  vtkGetMacro(ScatteredIrradiance, bool);
  vtkBooleanMacro(ScatteredIrradiance, bool);
  ///@}

  ///@{
  /**
   * How near to a point or a lamp occluders do not shade it, as a fraction of their largest
   * coordinate: a point on a surface lies beside its triangles by rounding, in single precision
   * by 1e-7 of its coordinates. For DirectIrradiance only. Range: [0, 1]. Default: 1e-6.
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
