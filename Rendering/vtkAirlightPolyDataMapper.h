// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAirlightPolyDataMapper
 * @brief   renders polygonal data in fog, smoke, dust or water, without a render pass
 *
 * For pipelines that cannot install a vtkAirlightPass: the mapper composites its own surface with
 * the medium, in its own shader, and does not affect the renderer. It renders no shadows.
 * @code
 *   mapper->SetMedium(fog);
 *   actor->SetMapper(mapper);
 * @endcode
 * A fragment of colour C at distance t becomes C T(t) + L(0, t), with the transmittance T from it
 * to the eye and the light L that the medium in front of it scatters to the eye. VTK blends
 * afterwards, so that translucent surfaces are composited one by one, also with depth peeling.
 * Lines and points are rendered in the same way. All switched-on lights of the renderer are
 * attenuated on their way to the surface; lights fixed to the scene also scatter. Units are those
 * of vtkAirlightPass: linear radiance, see vtkAirlight::SetRadiantIntensity(). Limits, costs and
 * accuracy are in Documentation/guide.md.
 *
 * Errors: the surface is always rendered. If the camera's matrices are not finite, or the graphics
 * card has no memory for the data of media or lights, one error says so and the surface is rendered
 * without the medium. More than eight media are an error, once; lights whose values are not finite
 * do not affect the medium, with one warning.
 *
 * Source: V. Biri, D. Arques and S. Michelin, "Real Time Rendering of Atmospheric Scattering and
 * Volumetric Shadows", WSCG 2006 (closed form; evaluation at vertices).
 *
 * @sa vtkAirlightPass vtkParticipatingMedium vtkAirlight
 */

#ifndef vtkAirlightPolyDataMapper_h
#define vtkAirlightPolyDataMapper_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkOpenGLPolyDataMapper.h"

#include <map>    // for shaders
#include <memory> // for the implementation

class vtkLight;
class vtkParticipatingMedium;

class VTKAIRLIGHT_EXPORT vtkAirlightPolyDataMapper : public vtkOpenGLPolyDataMapper
{
public:
  static vtkAirlightPolyDataMapper* New();
  vtkTypeMacro(vtkAirlightPolyDataMapper, vtkOpenGLPolyDataMapper);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The media between the surface and the eye and between the lights and the surface. Each is added
   * once; more than eight are an error in rendering, which uses the first eight. Null is ignored;
   * SetMedium(nullptr) removes all. GetMedium() of an index out of range is an error and returns
   * null. Mappers and passes may share a medium; changes apply to the next frame. Default: none;
   * the surface is then rendered as by a vtkPolyDataMapper.
   */
  void AddMedium(vtkParticipatingMedium* medium);
  void RemoveMedium(vtkParticipatingMedium* medium);
  void RemoveAllMedia();
  void SetMedium(vtkParticipatingMedium* medium);
  int GetNumberOfMedia();
  vtkParticipatingMedium* GetMedium(int index);
  ///@}

  /**
   * Where airlight and transmittance are evaluated.
   */
  enum EvaluationType
  {
    FRAGMENT = 0, ///< at each fragment
    VERTEX = 1    ///< at the mesh's vertices, interpolated between them
  };

  ///@{
  /**
   * Where the airlight in front of the surface and its transmittance to the eye are evaluated.
   * VERTEX is cheaper with fewer vertices than fragments. It is exact at the vertices; the error of
   * the linear interpolation of T and L between them falls with the square of the triangles' size,
   * and a coarse mesh loses the glow of a light in front of it. The attenuation from the light to
   * the surface is always evaluated per fragment. So are lines wider than a pixel and surfaces with
   * visible edges, which VTK draws with geometry shaders. Other values are an error and change
   * nothing. Default: FRAGMENT.
   */
  void SetEvaluation(int evaluation);
  vtkGetMacro(Evaluation, int);
  void SetEvaluationToFragment() { this->SetEvaluation(FRAGMENT); }
  void SetEvaluationToVertex() { this->SetEvaluation(VERTEX); }
  ///@}

  ///@{
  /**
   * Radius of point lights in world units: rays that pass a light more closely are shaded as if
   * they passed at this distance, which bounds the airlight near the light. With quadrature, the
   * path of the light is still attenuated. 0 uses the smallest distance that single precision
   * resolves, 1e-5 of the distance from camera to light. Range: finite, at least 0; other values
   * are an error and change nothing. Default: 0.
   */
  void SetLightRadius(double radius);
  vtkGetMacro(LightRadius, double);
  ///@}

  ///@{
  /**
   * The same as vtkAirlightLight::SetScatters(): the light keeps the value.
   */
  void SetLightScatters(vtkLight* light, bool scatters);
  bool GetLightScatters(vtkLight* light);
  ///@}

  /**
   * As vtkMapper's; also copies media (shared), evaluation and light radius of another
   * vtkAirlightPolyDataMapper.
   */
  void ShallowCopy(vtkAbstractMapper* mapper) override;

  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override; ///< Draws the surface
  void ReleaseGraphicsResources(vtkWindow* window) override; ///< Frees what is on the graphics card

protected:
  vtkAirlightPolyDataMapper();
  ~vtkAirlightPolyDataMapper() override;

  ///@{
  /**
   * Called by the superclass when it builds and uses its shaders.
   */
  bool GetNeedToRebuildShaders(
    vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;
  void ReplaceShaderRenderPass(std::map<vtkShader::Type, vtkShader*> shaders, vtkRenderer* renderer,
    vtkActor* actor, bool prePass) override;
  void SetMapperShaderParameters(
    vtkOpenGLHelper& cellBO, vtkRenderer* renderer, vtkActor* actor) override;
  ///@}

private:
  vtkAirlightPolyDataMapper(const vtkAirlightPolyDataMapper&) = delete;
  void operator=(const vtkAirlightPolyDataMapper&) = delete;

  int Evaluation = FRAGMENT;
  double LightRadius = 0.0;

  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
