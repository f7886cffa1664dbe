// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowPlanesFilter
 * @brief   the planes that bound the shadows of a mesh, as polygons
 *
 * Extrudes the edges of vtkSilhouetteEdgesFilter away from the light. Light, input, composite data
 * and errors are as described there.
 *
 * Every triangle has a shadow volume, so a point in the shadow of a closed surface is in two: that
 * of its front and that of its back. A polygon that bounds several volumes occurs once, with a
 * weight. A line that crosses a polygon from its front to its back enters Weight volumes, and
 * leaves them in the other direction. A point inside n volumes has n triangles between it and the
 * light, and is lit if n = 0.
 *
 * The polygons end at FarDistance beyond their edges, as quads with common points, or at the faces
 * of Bounds, where they are clipped exactly to the box and have separate points. With both caps
 * they bound the shadow volumes completely (in a box: the parts in it): the weighted sum of their
 * area vectors is zero, and line crossings count the volumes. Without caps, crossings of triangles
 * count, too.
 *
 * Point data are those of the mesh at the point where the light's ray meets it, interpolated if
 * clipped. Global ids are not passed on, as points occur several times.
 *
 * Cell data:
 *
 * - `Weight` (int): at least 1.
 * - `EdgePoints` (vtkIdType, 2 components): the input's points at the ends of the source edge, with
 *   the shadow to its left, seen from the light; -1 for caps.
 * - `Part` (int): PLANE, LIGHT_CAP or FAR_CAP.
 *
 * Errors in addition to those of vtkSilhouetteEdgesFilter: Bounds without volume if they are used.
 *
 * @sa vtkSilhouetteEdgesFilter vtkAirlightPass
 */

#ifndef vtkShadowPlanesFilter_h
#define vtkShadowPlanesFilter_h

#include "vtkSilhouetteEdgesFilter.h"

class VTKAIRLIGHT_EXPORT vtkShadowPlanesFilter : public vtkSilhouetteEdgesFilter
{
public:
  static vtkShadowPlanesFilter* New();
  vtkTypeMacro(vtkShadowPlanesFilter, vtkSilhouetteEdgesFilter);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * Values of the cell data array `Part`.
   */
  enum PartType
  {
    PLANE = 0,     ///< from an edge away from the light
    LIGHT_CAP = 1, ///< a triangle of the mesh, turned to the light
    FAR_CAP = 2    ///< the far end of a triangle's shadow volume
  };

  /**
   * Where the planes end.
   */
  enum ExtentType
  {
    FAR_DISTANCE = 0, ///< FarDistance beyond their edges
    BOUNDS = 1        ///< at the faces of Bounds; nothing is outside
  };

  ///@{
  /**
   * Where the planes end, an ExtentType. Default: FAR_DISTANCE.
   */
  vtkSetClampMacro(Extent, int, FAR_DISTANCE, BOUNDS);
  vtkGetMacro(Extent, int);
  void SetExtentToFarDistance() { this->SetExtent(FAR_DISTANCE); }
  void SetExtentToBounds() { this->SetExtent(BOUNDS); }
  ///@}

  ///@{
  /**
   * The distance by which every point of an edge is moved along its ray from the light, in world
   * units. 0 means twice the diagonal of the box around the input's triangles (in composite data,
   * of the block). The ends of a long edge close to the light move apart, and the plane between
   * them extends less far: use Bounds to fill a region. Range: finite, at least 0; other values
   * give an error and the old value is kept. Default: 0.
   */
  void SetFarDistance(double distance);
  vtkGetMacro(FarDistance, double);
  ///@}

  ///@{
  /**
   * The box (xmin, xmax, ymin, ymax, zmin, zmax) to which the planes are clipped if Extent is
   * BOUNDS, in world units. Range: finite, at most 1e100 in size; other values give an error and
   * the old values are kept. The filter checks that each minimum is below its maximum when it
   * executes. Default: (0, 1, 0, 1, 0, 1).
   */
  void SetBounds(double xmin, double xmax, double ymin, double ymax, double zmin, double zmax);
  void SetBounds(const double bounds[6]);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /**
   * Whether the output includes the casting triangles, oriented towards the light, with weight 1.
   * Default: off.
   */
  vtkSetMacro(LightCap, bool);
  vtkGetMacro(LightCap, bool);
  vtkBooleanMacro(LightCap, bool);
  ///@}

  ///@{
  /**
   * Whether the output includes the far ends of the triangles' shadow volumes, oriented away from
   * the light, with weight 1: moved triangles at FarDistance, or parts of the faces of Bounds.
   * Default: off.
   */
  vtkSetMacro(FarCap, bool);
  vtkGetMacro(FarCap, bool);
  vtkBooleanMacro(FarCap, bool);
  ///@}

protected:
  vtkShadowPlanesFilter() = default;
  ~vtkShadowPlanesFilter() override = default;

  bool CheckProperties() override;
  void MakeOutput(const airlight::CasterMesh& mesh, const double light[4], vtkPolyData* input,
    vtkPolyData* output) override;

  int Extent = FAR_DISTANCE;
  double FarDistance = 0.0;
  double Bounds[6] = { 0.0, 1.0, 0.0, 1.0, 0.0, 1.0 };
  bool LightCap = false;
  bool FarCap = false;

private:
  vtkShadowPlanesFilter(const vtkShadowPlanesFilter&) = delete;
  void operator=(const vtkShadowPlanesFilter&) = delete;
};

#endif
