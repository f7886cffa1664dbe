// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @class   vtkAirlightReference
 * @brief   renders a scene in media on the CPU, in double precision
 *
 * Computes the picture of vtkAirlightPass in double precision, without a window or a graphics card:
 * one ray through the centre of each pixel, shadows from the triangles themselves, and for each lit
 * interval the closed form or adaptive quadrature (see vtkAirlight for their errors).
 * @code
 *   reference->SetRenderer(renderer);
 *   reference->SetMedium(fog);
 *   reference->SetSize(160, 120);
 *   reference->Update(); // reference->GetOutput(): a vtkImageData
 * @endcode
 * It shares the source text of the formulae, and the conversion of lights, media and pixels, with
 * the pass. It measures the pass's single precision and shadow planes, but not the physics; see
 * "What shares code with what" in Documentation/trust.md. Lights, casters and limits are in
 * Documentation/guide.md.
 *
 * The output has the picture's size, spacing 1, the bottom row first, and these point data in
 * double precision, which are the buffers of vtkAirlightPass::GetBuffer():
 *
 * - "Radiance" (RGB, the active scalars), W/(m^2 sr)
 * - "Airlight" (RGB), W/(m^2 sr)
 * - "Surface" (RGB), W/(m^2 sr)
 * - "Transmittance" (RGB)
 * - "Depth", world units; -1 without a surface
 * - "LitLength", world units
 *
 * The pixels are computed in parallel by vtkSMPTools; the result is bit-identical for any number of
 * threads. Progress is reported. SetAbortExecute() from an observer stops at the next rows and
 * leaves an output without points.
 *
 * Errors: a missing renderer, an unknown size, a camera without valid matrices and more than eight
 * media give an error and an output without points.
 *
 * Source: the formulae of vtkAirlight. The shadow of a triangle on a ray is the intersection of a
 * half space and the cone of the light and the triangle's three edges.
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
   * The renderer whose camera, lights, props and background make the scene. It needs no window. As
   * in rendering, it gets a camera and a light if it has none. Default: none.
   */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer();
  ///@}

  ///@{
  /**
   * The media of the scene, as in vtkAirlightPass; at most eight. Without a medium, surfaces have
   * shadows only. Null is ignored.
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
   * The size of the picture in pixels, which are square. Range: 1 to 32768, or 0 and 0 for the size
   * at which the renderer draws in its window. Default: (0, 0).
   */
  void SetSize(int width, int height);
  void SetSize(const int size[2]) { this->SetSize(size[0], size[1]); }
  vtkGetVector2Macro(Size, int);
  ///@}

  ///@{
  /**
   * Radius of point lights in world units: rays that pass a light more closely are shaded as if
   * they passed at this distance. 0 uses the smallest distance that double precision resolves,
   * 1e-12 of the distance from camera to light (the pass uses 1e-5 of it). Range: finite, at least
   * 0. Default: 0.
   */
  void SetLightRadius(double radius);
  vtkGetMacro(LightRadius, double);
  ///@}

  ///@{
  /**
   * How many points a lamp with an extent (vtkAirlightLight::SetRadius() and so on) has, by a
   * lattice of other points than the pass takes. The time grows with their number; the error, at
   * borders of shadows, falls about as its inverse. Range: 1, its middle, to 65536. Default: 256.
   */
  vtkSetClampMacro(LampPoints, int, 1, 65536);
  vtkGetMacro(LampPoints, int);
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
   * The same as vtkAirlightLight::SetScatters(): the light keeps the value.
   */
  void SetLightScatters(vtkLight* light, bool scatters);
  bool GetLightScatters(vtkLight* light);
  ///@}

  /**
   * The last modification of this object, its media, or anything visible in the renderer.
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
  int LampPoints = 256;
  bool SurfaceShadows = true;

  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
