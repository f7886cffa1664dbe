// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSilhouetteEdgesFilter
 * @brief   the edges from which the shadow planes of a mesh extend, for any triangle soup
 *
 * Input: what casts shadows, any vtkPolyData; its polygons and strips are taken as triangles, its
 * vertices and lines are ignored. Output: the edges that separate light from shadow as seen from
 * the light, as lines. These are the very edges from which vtkAirlightPass draws its shadow planes.
 * Composite data come through VTK's own pipeline, block by block; blocks do not know of each other.
 *
 * Every triangle is turned to face the light. The weight of an edge is the sum of the directions in
 * which its triangles then run along it: 0 inside a surface, which bounds nothing and is left out,
 * 1 at an open border, 2 at the silhouette of a closed surface, whose front and back both cast. The
 * lines run so that their shadow lies to the left, seen from the light. Nothing is assumed of the
 * mesh: it may be open, wound at random, non-manifold or self-intersecting, and points at the very
 * same position are one. At each point the weights of the lines that arrive equal those of the
 * lines that leave: they bound a chain of triangles, so shadow planes never leak. A triangle that
 * the light sees exactly edge-on casts nothing.
 *
 * Cell data:
 *  - `Weight` (int): at least 1.
 *  - `EdgePoints` (vtkIdType, 2 components): the input's points at the line's ends, in its order.
 *
 * Point data are the input's; where several points are at one position, the first one's.
 *
 * The light is, in this order:
 *  1. the vtkLight, where SetLight() was given one,
 *  2. LightDirection, where it is not (0, 0, 0),
 *  3. LightPosition.
 *
 * Cost: a mesh is prepared once, in a time that is about linear in its size, and again only where
 * its points or polygons change; another light costs one look at every triangle and edge. Measured
 * in Documentation/benchmarks.md. The threads of vtkSMPTools share the work, and the output is the
 * same whatever their number.
 *
 * Errors: a light that is not finite or above 1e100, a directional light that shines nowhere, a
 * light that lies on a triangle, and an input that has cells but no triangle of three different
 * finite positions give an error that names the value, and an empty output. An input without cells
 * gives an empty output and no error. Triangles with points that are not finite are left out.
 * An abort leaves an empty output.
 *
 * Source: F. Crow, "Shadow Algorithms for Computer Graphics", SIGGRAPH 1977 (shadow volumes);
 * P. Bergeron, "A General Version of Crow's Shadow Volumes", IEEE CG&A 6(9), 1986 (open meshes).
 *
 * @sa vtkShadowPlanesFilter vtkAirlightPass vtkFeatureEdges
 */

#ifndef vtkSilhouetteEdgesFilter_h
#define vtkSilhouetteEdgesFilter_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkPolyDataAlgorithm.h"

#include <memory> // for the prepared meshes

class vtkLight;

namespace airlight
{
class CasterMesh;
}

class VTKAIRLIGHT_EXPORT vtkSilhouetteEdgesFilter : public vtkPolyDataAlgorithm
{
public:
  static vtkSilhouetteEdgesFilter* New();
  vtkTypeMacro(vtkSilhouetteEdgesFilter, vtkPolyDataAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The light, or nullptr to use the numbers below. A positional light shines from its transformed
   * position, any other along its transformed axis, from the position to the focal point. Its
   * switch, colour, cone and attenuation do not matter. Headlights and camera lights are where
   * their renderer put them when it last rendered. The filter executes again when the light
   * changes. Default: nullptr.
   */
  virtual void SetLight(vtkLight* light);
  vtkLight* GetLight();
  ///@}

  ///@{
  /**
   * The position of a point light, in world units; used where there are neither a Light nor a
   * LightDirection. Values that are not finite or above 1e100 are refused with an error and the old
   * ones stay. Default: (0, 0, 0).
   */
  void SetLightPosition(double x, double y, double z);
  void SetLightPosition(const double position[3]);
  vtkGetVector3Macro(LightPosition, double);
  ///@}

  ///@{
  /**
   * Where a directional light shines to, of any length; (0, -1, 0) is the sun at noon. Used where
   * there is no Light; (0, 0, 0) stands for none. Values that are not finite or above 1e100 are
   * refused with an error and the old ones stay. Default: (0, 0, 0).
   */
  void SetLightDirection(double x, double y, double z);
  void SetLightDirection(const double direction[3]);
  vtkGetVector3Macro(LightDirection, double);
  ///@}

  /**
   * Includes the light's and its matrix' times.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkSilhouetteEdgesFilter();
  ~vtkSilhouetteEdgesFilter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * Whether the filter's own properties can be used; gives the error where they cannot.
   */
  virtual bool CheckProperties();

  /**
   * Fills the output for the light (w = 1: position, w = 0: direction towards it), which does not
   * lie on the mesh. May leave it unfinished where AbortExecute is set.
   */
  virtual void MakeOutput(const airlight::CasterMesh& mesh, const double light[4],
    vtkPolyData* input, vtkPolyData* output);

  bool SetVector(const char* name, double x, double y, double z, double vector[3]);

  double LightPosition[3] = { 0.0, 0.0, 0.0 };
  double LightDirection[3] = { 0.0, 0.0, 0.0 };

private:
  vtkSilhouetteEdgesFilter(const vtkSilhouetteEdgesFilter&) = delete;
  void operator=(const vtkSilhouetteEdgesFilter&) = delete;

  bool FindLight(double light[4]);
  bool IsOnMesh(const airlight::CasterMesh& mesh, const double light[4]);
  std::shared_ptr<const airlight::CasterMesh> GetMesh(vtkPolyData* input);
  void BeginExecution();
  void EndExecution();

  class Internals;
  std::unique_ptr<Internals> Internal;
};

#endif
