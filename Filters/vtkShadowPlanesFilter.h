// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkShadowPlanesFilter
 * @brief   the surfaces that bound the shadows of a mesh, as polygons
 *
 * Extrudes the edges of vtkSilhouetteEdgesFilter away from the light. The light, the input, what is
 * assumed of it (nothing), composite data, cost, threads and errors are described there.
 *
 * Every triangle has a shadow volume of its own, so that a point in the shadow of a closed surface
 * is in two: its front's and its back's. What bounds several volumes at once is one polygon with a
 * weight, and what bounds none has none. A line that crosses a polygon from its front to its back
 * enters Weight volumes, and leaves them the other way round; a point that n volumes hold is lit if
 * n = 0. n is also the number of triangles between it and the light.
 *
 * The polygons end at FarDistance beyond their edges, as quads with common points, or at the faces
 * of Bounds, where they are cut exactly to the box and each has points of its own. With both caps
 * they bound the shadow volumes completely (in a box: the parts in it): the weighted sum of their
 * area vectors is zero, and line crossings count the volumes. Without caps, crossings of triangles
 * count, too.
 *
 * Point data are those of the mesh where the light's ray to the point meets it, interpolated in
 * bounds. Global ids are not passed on, as points come several times.
 *
 * Cell data:
 *  - `Weight` (int): at least 1.
 *  - `EdgePoints` (vtkIdType, 2 components): the input's points at the ends of the source edge, the
 *    shadow to its left, seen from the light; -1 for caps.
 *  - `Part` (int): PLANE, LIGHT_CAP or FAR_CAP.
 *
 * Errors besides those of vtkSilhouetteEdgesFilter: Bounds without volume where they are used.
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
   * How far every point of an edge is moved along its ray from the light, in world units. 0 stands
   * for twice the diagonal of the box around the input's triangles (in composite data, the
   * block's). The ends of a long edge close to the light move apart, and the plane between them
   * reaches less far: use Bounds where it has to fill a region. Range: finite, at least 0; others
   * are refused with an error and the old value stays. Default: 0.
   */
  void SetFarDistance(double distance);
  vtkGetMacro(FarDistance, double);
  ///@}

  ///@{
  /**
   * The box (xmin, xmax, ymin, ymax, zmin, zmax) that the planes are cut to, in world units, where
   * Extent is BOUNDS. Range: finite, at most 1e100 in size; others are refused with an error and
   * the old values stay. That each minimum lies below its maximum is checked when the filter
   * executes. Default: (0, 1, 0, 1, 0, 1).
   */
  void SetBounds(double xmin, double xmax, double ymin, double ymax, double zmin, double zmax);
  void SetBounds(const double bounds[6]);
  vtkGetVector6Macro(Bounds, double);
  ///@}

  ///@{
  /**
   * Whether the triangles that cast come, too, turned to the light, with weight 1. Default: off.
   */
  vtkSetMacro(LightCap, bool);
  vtkGetMacro(LightCap, bool);
  vtkBooleanMacro(LightCap, bool);
  ///@}

  ///@{
  /**
   * Whether the far ends of the triangles' shadow volumes come, too, turned away from the light,
   * with weight 1: moved triangles at the FarDistance, parts of the box' faces in Bounds. Default:
   * off.
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
