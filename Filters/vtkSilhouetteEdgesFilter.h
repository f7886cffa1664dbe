// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkSilhouetteEdgesFilter
 * @brief   the edges from which the shadow planes of a mesh extend, for any triangle soup
 *
 * Input: any vtkPolyData that casts shadows; its polygons and strips are triangulated, its vertices
 * and lines are ignored. Output: the edges that separate light from shadow as seen from the light,
 * as lines. These are the edges from which vtkAirlightPass draws its shadow planes. VTK's pipeline
 * passes composite data block by block; each block is processed separately.
 *
 * Every triangle is oriented towards the light. The weight of an edge is the sum of the directions
 * of its triangles along it: 0 inside a surface, where the edge is left out; 1 at an open border; 2
 * at the silhouette of a closed surface, whose front and back both cast. The lines are directed so
 * that their shadow is to the left, seen from the light. The mesh may be open, of any orientation,
 * non-manifold or self-intersecting; points at the same position count as one. At each point the
 * weights of the lines that arrive equal those of the lines that leave: they bound a chain of
 * triangles, so shadow planes never leak. A triangle that the light sees exactly edge-on casts
 * nothing.
 *
 * Cell data:
 *
 * - `Weight` (int): at least 1.
 * - `EdgePoints` (vtkIdType, 2 components): the input's points at the line's ends, in its order.
 *
 * Point data are the input's; of several points at one position, those of the first.
 *
 * The light is the first available of 1. the vtkLight of SetLight(), 2. LightDirection unless it is
 * (0, 0, 0), 3. LightPosition. The output does not depend on the number of threads (vtkSMPTools).
 *
 * Errors: a light that is infinite, NaN or above 1e100, a directional light without direction, a
 * light on a triangle, and an input that has cells but no triangle of three different finite
 * positions give an error that names the value, and an empty output. An input without cells gives
 * an empty output and no error. Triangles with points that are NaN or infinite are left out. An
 * aborted update leaves an empty output.
 *
 * Sources: F. Crow, "Shadow Algorithms for Computer Graphics", SIGGRAPH 1977 (shadow volumes); P.
 * Bergeron, "A General Version of Crow's Shadow Volumes", IEEE CG&A 6(9), 1986 (open meshes).
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
   * The light, or nullptr to use the properties below. A positional light shines from its
   * transformed position, any other along its transformed axis, from the position to the focal
   * point. Its switch, colour, cone and attenuation are ignored. Headlights and camera lights are
   * at the position of their renderer's last frame. The filter executes again when the light
   * changes. Default: nullptr.
   */
  virtual void SetLight(vtkLight* light);
  vtkLight* GetLight();
  ///@}

  ///@{
  /**
   * The position of a point light, in world units; used without a Light and a LightDirection.
   * Values that are infinite, NaN or above 1e100 give an error and the old values are kept.
   * Default: (0, 0, 0).
   */
  void SetLightPosition(double x, double y, double z);
  void SetLightPosition(const double position[3]);
  vtkGetVector3Macro(LightPosition, double);
  ///@}

  ///@{
  /**
   * The direction in which a directional light shines, of any length; (0, -1, 0) is the sun at
   * noon. Used without a Light; (0, 0, 0) means none. Values that are infinite, NaN or above 1e100
   * give an error and the old values are kept. Default: (0, 0, 0).
   */
  void SetLightDirection(double x, double y, double z);
  void SetLightDirection(const double direction[3]);
  vtkGetVector3Macro(LightDirection, double);
  ///@}

  /**
   * Includes the times of the light and its matrix.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkSilhouetteEdgesFilter();
  ~vtkSilhouetteEdgesFilter() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  /**
   * Whether the properties of the filter are valid; reports an error if not.
   */
  virtual bool CheckProperties();

  /**
   * Fills the output for the light (w = 1: position, w = 0: direction towards it), which is not on
   * the mesh. May leave it unfinished if AbortExecute is set.
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
