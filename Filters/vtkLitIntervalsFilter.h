// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkLitIntervalsFilter
 * @brief   the lit parts of lines in a participating medium, in double precision
 *
 * Splits lines into the parts that a light reaches: inside the medium, inside the light's cone, and
 * not in the shadow of an occluder. Gives the length of each part, its optical depth, and its
 * airlight. See "A laser sheet" in Documentation/guide.md.
 *
 * Input port 0: vtkPolyData with lines and polylines; other cells are ignored. Port 1 (optional,
 * repeatable): vtkPolyData whose polygons and strips are opaque occluders, of any orientation, in
 * the coordinates of the lines.
 *
 * Output: one line or polyline per lit part, in the order of the input's cells and along each of
 * them, with double points. A part continues around the bends of a polyline. With lengths in metres
 * the cell data are
 *
 * | array | components | meaning, unit |
 * |---|---|---|
 * | Length | 1 | length of the part, world units |
 * | Start, End | 1 | its ends: length from the line's first point, world units |
 * | Airlight | RGB | radiance that the part sends to the line's first point, W/(m^2 sr) |
 * | OpticalDepth | RGB | of the part |
 * | Transmittance | RGB | of the line from its first point to the part's end, lit or not |
 * | StartCause, EndCause | 1 | CauseType |
 * | StartOccluder, EndOccluder | 1 | the connection of port 1 if the cause is SHADOW, else -1 |
 * | StartOccluderCell, EndOccluderCell | 1 | the cell of its data if the cause is SHADOW, else -1 |
 * | SourceCell | 1 | the line's cell in the input |
 *
 * Airlight is the integral of vtkAirlight::Inscatter() over the part. On a polyline the light
 * returns along the line, as if each bend were a mirror. The sum over the parts of a straight line
 * is the airlight that an eye at its first point sees, with shadows, without ambient radiance.
 *
 * Numerical errors: those of vtkAirlight; for the ends rounding, about 1e-12 of the largest
 * coordinate. Parts shorter than that between two shadows count as dark. The output does not depend
 * on the number of threads (vtkSMPTools).
 *
 * Errors: a missing light or medium, or a light with NaN or infinite values, gives an error and an
 * output without cells. Lines with points that are NaN, infinite or beyond 1e15 are left out with a
 * warning; segments of length 0 are ignored.
 *
 * @sa vtkAirlight vtkAirlightProbeFilter vtkAirlightPass
 */

#ifndef vtkLitIntervalsFilter_h
#define vtkLitIntervalsFilter_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h" // for members

class vtkLight;
class vtkParticipatingMedium;

class VTKAIRLIGHT_EXPORT vtkLitIntervalsFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkLitIntervalsFilter* New();
  vtkTypeMacro(vtkLitIntervalsFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Why a part begins or ends.
   */
  enum CauseType
  {
    LINE_END = 0, ///< the line itself begins or ends
    SHADOW = 1,   ///< the shadow of an occluder, or the occluder itself where the line meets it
    MEDIUM = 2,   ///< the edge of the medium's region
    CONE = 3,     ///< the edge of a spot's cone
    BEND = 4      ///< a bend of the polyline, beyond which it is dark at once
  };

  ///@{
  /**
   * The light. A light that is switched off or of intensity 0 gives an output without parts.
   * Default: none.
   */
  void SetLight(vtkLight* light);
  vtkLight* GetLight();
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
   * An occluder for port 1. AddInputConnection(1, port) adds one that stays up to date.
   */
  void AddOccluderData(vtkPolyData* data);
  void RemoveAllOccluders();
  ///@}

  /**
   * The last modification of the filter, its light or its medium.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkLitIntervalsFilter();
  ~vtkLitIntervalsFilter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(
    vtkInformation* request, vtkInformationVector** inputs, vtkInformationVector* outputs) override;

private:
  vtkLitIntervalsFilter(const vtkLitIntervalsFilter&) = delete;
  void operator=(const vtkLitIntervalsFilter&) = delete;

  bool CheckSettings();

  vtkSmartPointer<vtkLight> Light;
  vtkSmartPointer<vtkParticipatingMedium> Medium;
};

#endif
