// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAirlightReference
 * @brief   the picture of a scene in media, computed on the CPU in double precision
 *
 * What vtkAirlightPass draws, in double precision: one ray through the middle of each pixel,
 * the lit parts of it from the triangles themselves, and on each of them the closed form
 * or adaptive quadrature (see vtkAirlight for their errors). It is no independent check of the
 * physics: the formulae are the same source text as the pass', and lights, media and the rays of
 * pixels come from the same code. It measures the pass' single precision and its shadow planes.
 * Testing/Oracle shares no code with either. Densities from images
 * (vtkParticipatingMedium::SetDensityToImage()) are integrated cell by cell, with the depth on
 * the way to the light summed in the same way. No window and no graphics card are needed:
 * @code
 *   reference->SetRenderer(renderer);
 *   reference->SetMedium(fog);
 *   reference->SetSize(160, 120);
 *   reference->Update(); // reference->GetOutput(): a vtkImageData
 * @endcode
 *
 * The output has the picture's size, spacing 1, the bottom row first, and as point data these
 * arrays in double precision, named and meant like the buffers of vtkAirlightPass::GetBuffer():
 *  - "Radiance" (RGB, the active scalars): what reaches the eye, background included, W/(m^2 sr);
 *  - "Airlight" (RGB): the part that the medium scattered into the ray;
 *  - "Surface" (RGB): the part that opaque surfaces sent, attenuated; 0 where there is none;
 *  - "Transmittance" (RGB): from the eye to the surface, or to the far side of the medium;
 *  - "Depth": distance along the unit ray, world units; -1 where there is no surface;
 *  - "LitLength": length of the ray inside media (once where they overlap) that light reaches,
 *    summed over lights.
 *
 * Camera, lights and surfaces count as in the pass. All visible opaque actors of polygons cast shadows,
 * but for those whose vtkAirlightPass::CASTS_SHADOW() says otherwise. Headlights and camera lights
 * neither scatter nor cast shadows unless SetLightScatters() is on; headlights cast none even then. Surfaces
 * are shaded as VTK's mappers shade them, from Phong's properties, normals of points or cells, scalars
 * mapped before interpolation, and lights with their attenuation; culling and clipping planes hide
 * them. Translucent surfaces are blended in order, each behind the medium before it; they cast no
 * shadows (as in a pass after SetTranslucentShadows(false)), and of two at the same distance one is seen.
 * A vtkLODProp3D is its level of detail that vtkAirlightPass takes. Textures, physically based shading, wireframes,
 * points and lines, glyphs, volumes and other props, and what vtkCompositePolyDataMapper2 says of
 * single blocks are left out or shaded plainly: one warning each time names them. The pass's
 * photometric files, scattered surface light, and encoded input are not known here. The colours of a
 * gradient background are not rounded; VTK rounds them to 1/255.
 *
 * Cost: pixels times lights times boundaries of shadows; tenths of a second for 160 x 120 pixels
 * in uniform media, see Documentation/accuracy.md. Pixels are computed in parallel by vtkSMPTools; the result is
 * the same to the last bit with any number of threads. Progress is reported, and SetAbortExecute()
 * from an observer ends the work at the next rows and leaves an output without points.
 *
 * Errors: a missing renderer, an unknown size, a camera without valid matrices and more than eight
 * media give an error that says so, and an output without points.
 *
 * Source: the formulae of vtkAirlight; shadows as the complement of the triangles' own shadows on the
 * ray, each the intersection of a half space and the cone of the light and three edges.
 *
 * @sa vtkAirlightPass vtkAirlight vtkParticipatingMedium
 */

#ifndef vtkAirlightReference_h
#define vtkAirlightReference_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkImageAlgorithm.h"

#include <memory> // for the implementation

class vtkLight;
class vtkParticipatingMedium;
class vtkRenderer;

class VTKAIRLIGHT_EXPORT vtkAirlightReference : public vtkImageAlgorithm
{
public:
  static vtkAirlightReference* New();
  vtkTypeMacro(vtkAirlightReference, vtkImageAlgorithm);
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The renderer whose camera, lights, props and background make the scene. It needs no window. As when
   * it draws, it gets a camera and a light where it has none. Default: none.
   */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /**
   * The media of the scene, as in vtkAirlightPass; at most eight. Without a medium surfaces have their
   * look and shadows. Null is ignored.
   */
  void AddMedium(vtkParticipatingMedium* medium);
  void RemoveMedium(vtkParticipatingMedium* medium);
  void RemoveAllMedia();
  void SetMedium(vtkParticipatingMedium* medium);
  int GetNumberOfMedia();
  vtkParticipatingMedium* GetMedium(int index);
  ///@}

  ///@{
  /**
   * The picture's size in pixels, which are square. Range: 1 to 32768, or 0 and 0 for the size at which
   * the renderer draws in its window. Default: (0, 0).
   */
  void SetSize(int width, int height);
  void SetSize(const int size[2]) { this->SetSize(size[0], size[1]); }
  vtkGetVector2Macro(Size, int);
  ///@}

  ///@{
  /**
   * Radius of point lights in world units: rays that pass a light more closely are shaded as if
   * they passed at this distance. 0 uses the smallest distance that double precision resolves, 1e-12
   * of the distance from camera to light, where the pass has 1e-5 of it. Range: finite, at least 0.
   * Default: 0.
   */
  void SetLightRadius(double radius);
  vtkGetMacro(LightRadius, double);
  ///@}

  ///@{
  /**
   * Whether shadows also fall on surfaces. Default: true.
   */
  vtkSetMacro(SurfaceShadows, bool);
  vtkGetMacro(SurfaceShadows, bool);
  vtkBooleanMacro(SurfaceShadows, bool);
  ///@}

  ///@{
  /**
   * Whether the medium scatters this light, as in vtkAirlightPass::SetLightScatters(). Default: true
   * for lights of the scene, false for those that are fixed to the camera, which then cast no shadows.
   */
  void SetLightScatters(vtkLight* light, bool scatters);
  bool GetLightScatters(vtkLight* light);
  ///@}

  /**
   * The last modification of this object, its media, or anything in the renderer that shows.
   */
  vtkMTimeType GetMTime() override;

protected:
  vtkAirlightReference();
  ~vtkAirlightReference() override;

  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkAirlightReference(const vtkAirlightReference&) = delete;
  void operator=(const vtkAirlightReference&) = delete;

  bool FindSize(int size[2]);
  bool Check();

  int Size[2] = { 0, 0 };
  double LightRadius = 0.0;
  bool SurfaceShadows = true;

  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
