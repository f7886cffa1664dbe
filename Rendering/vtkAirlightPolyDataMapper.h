// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAirlightPolyDataMapper
 * @brief   draws polygonal data in fog, smoke, dust or water, without a render pass
 *
 * For pipelines that cannot install a vtkAirlightPass: the mapper puts its own surface behind the
 * medium, in its own shader, and leaves the renderer alone.
 * @code
 *   mapper->SetMedium(fog);
 *   actor->SetMapper(mapper);
 * @endcode
 * A fragment of colour C at distance t becomes C T(t) + L(0, t), with T the transmittance from it
 * to the eye and L the light that the medium before it scatters to the eye. That is done before VTK
 * blends, so that translucent surfaces come right one by one, with depth peeling, too. All
 * switched-on lights of the renderer (point lights, spots and directional lights, with any
 * attenuation) are attenuated on their way to the surface, and the lights of the scene are
 * scattered. Headlights and camera lights are scattered only after SetLightScatters(light, true); one
 * warning says so.
 * Arithmetic and units are those of vtkAirlightPass: linear radiance, see
 * vtkAirlight::SetRadiantIntensity(). Lines and points are drawn the same way.
 *
 * Error of L, relative, evaluated per fragment: 1e-4 for closed forms, 1e-3 where there are none
 * (vtkAirlightPass lists both), plus the media's vtkParticipatingMedium::GetPhaseErrorBound(). A
 * ray that passes a light at the distance h has, from single precision, up to 2e-8 d/h besides, d
 * the distance of the light from the eye.
 *
 * Cost: per fragment and light one evaluation of the closed form or of the quadrature, hidden
 * fragments included; per vertex and light with SetEvaluationToVertex().
 *
 * Limits:
 *  - No shadows: neither through the medium nor on surfaces.
 *  - Nothing but this surface is fogged: the background is not, nor are the actors of other
 *    mappers. Give the renderer a background of the fog's own colour.
 *  - Photometric files belong to vtkAirlightPass.
 *  - A window's own target holds colours up to 1: what is brighter is cut off before translucent
 *    surfaces are blended over it, where the pass blends radiance and cuts off last.
 *  - Points drawn as spheres and lines drawn as tubes are put at the distance of their middle.
 *  - Where a vtkAirlightPass draws the actor, the pass does all the shading and the mapper's media
 *    are not used: nothing is fogged twice.
 *  - For picking the surface is drawn plain.
 *  - At most eight media; where they overlap, their coefficients add.
 *
 * Shaders are made anew where the generated code changes (numbers of lights and media, kinds of
 * lights and regions, Evaluation), not where numbers do (positions, colours, coefficients).
 *
 * Errors: the surface is never lost. Where the camera's matrices are not finite, or the graphics
 * card has no room for the media's data or the lights, one error says so and the surface is drawn
 * without the medium. More than eight media are an error, once; lights whose numbers are not finite
 * are left out of the medium with one warning.
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
   * The media between the surface and the eye and between the lights and the surface. Each is taken
   * once; more than eight are an error when drawn, and the first eight count. Null is ignored;
   * SetMedium(nullptr) removes all. GetMedium() of an index out of range is an error and gives
   * null. A medium may be shared between mappers and passes; changes of it show in the next frame.
   * Default: none; the surface is then drawn as by a vtkPolyDataMapper.
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
   * Where the airlight before the surface, and its transmittance to the eye, are evaluated. VERTEX
   * is cheaper where there are fewer vertices than fragments, right at the vertices, and off
   * between them by what linear interpolation of T and L leaves, which falls with the square of the
   * triangles' size; where the mesh is coarse the glow of a lamp before it is lost. The light's own
   * way to the surface is evaluated per fragment in any case. Lines wider than a pixel and
   * surfaces with visible edges, which VTK draws with geometry shaders, are evaluated per fragment
   * in any case, too. Another number is an error and changes nothing. Default: FRAGMENT.
   */
  void SetEvaluation(int evaluation);
  vtkGetMacro(Evaluation, int);
  void SetEvaluationToFragment() { this->SetEvaluation(FRAGMENT); }
  void SetEvaluationToVertex() { this->SetEvaluation(VERTEX); }
  ///@}

  ///@{
  /**
   * Radius of point lights in world units: rays that pass a light more closely are shaded as if
   * they passed at this distance, which bounds the airlight near the light; by quadrature the medium
   * attenuates light on its own way. 0 is the least that single precision resolves, 1e-5 of the distance
   * from camera to light. Range: finite, at least 0; anything else is an error and changes nothing. Default: 0.
   */
  void SetLightRadius(double radius);
  vtkGetMacro(LightRadius, double);
  ///@}

  ///@{
  /**
   * Whether the medium scatters this light, as in vtkAirlightPass::SetLightScatters(). Default: true
   * for lights of the scene, false for those that are fixed to the camera.
   */
  void SetLightScatters(vtkLight* light, bool scatters);
  bool GetLightScatters(vtkLight* light);
  ///@}

  /**
   * As vtkMapper's; another vtkAirlightPolyDataMapper gives its media (shared, not copied),
   * evaluation, light radius and SetLightScatters(), too.
   */
  void ShallowCopy(vtkAbstractMapper* mapper) override;

  void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override; ///< Draws the surface
  void ReleaseGraphicsResources(vtkWindow* window) override; ///< Frees what is on the graphics card

protected:
  vtkAirlightPolyDataMapper();
  ~vtkAirlightPolyDataMapper() override;

  ///@{
  /**
   * Called by the superclass while it builds and uses its shaders.
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
