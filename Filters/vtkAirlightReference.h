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
 * Light of a medium's sky is integrated over all directions with the phase function itself, to 1e-4
 * of the brightest; paths have the closed form of vtkAirlight. The renderer's environment texture
 * lights no media here: give them vtkAirlight::EnvironmentHarmonics().
 *
 * With SetScatteringOrders() it also follows light that is scattered in the media and reflected by
 * surfaces several times, which the pass approximates for some lamps: a volumetric path tracer
 * adds it, unbiased for a given number of paths.
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
 * - "StandardError" (RGB), W/(m^2 sr), only with ScatteringOrders other than 1: the standard
 *   deviation of "Radiance" by chance, estimated from the paths of its pixel
 *
 * The pixels are computed in parallel by vtkSMPTools; the result is bit-identical for any number of
 * threads, with paths, too, unless a time limit ends them. Progress is reported; while paths are
 * added, an observer of it finds the picture so far in GetOutputDataObject(0). SetAbortExecute()
 * from an observer stops at the next rows and leaves an output without points.
 *
 * Errors: a missing renderer, an unknown size, a camera without valid matrices and more than eight
 * media give an error and an output without points.
 *
 * Source: the formulae of vtkAirlight. The shadow of a triangle on a ray is the intersection of a
 * half space and the cone of the light and the triangle's three edges. Paths: E. Veach, Robust
 * Monte Carlo Methods for Light Transport Simulation, 1997; C. Kulla and M. Fajardo, Importance
 * Sampling Techniques for Path Tracing in Participating Media, 2012.
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

namespace airlight
{
class ReferenceTracer;
}

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
   * Whether translucent casters dim light by their opacity, as with
   * vtkAirlightPass::SetTranslucentShadows(): the property's, times the alpha of scalars and of a
   * texture at each point, or that of vtkAirlightPass::SetShadowOpacity(). In the air, light that
   * varying alpha lets through is constant in each of 256 parts of a triangle's shadow on a ray.
   * Default: true.
   */
  vtkSetMacro(TranslucentShadows, bool);
  vtkGetMacro(TranslucentShadows, bool);
  vtkBooleanMacro(TranslucentShadows, bool);
  ///@}

  ///@{
  /**
   * Whether volumes dim the lights, as with vtkAirlightPass::SetVolumeShadows(): in the air and on
   * surfaces, by midpoint sums of eight steps between points of the volume. The volumes themselves
   * are not drawn. With ScatteringOrders other than 1 the light that is scattered several times
   * passes volumes undimmed. A volume that cannot cast a shadow gives a warning. Volumes of
   * vtkAirlightPass::SetVolumeScatters() are media like others, and seen. Default: false.
   */
  vtkSetMacro(VolumeShadows, bool);
  vtkGetMacro(VolumeShadows, bool);
  vtkBooleanMacro(VolumeShadows, bool);
  ///@}

  ///@{
  /**
   * How many times light may be scattered by the media or reflected by surfaces on its way from a
   * lamp to the eye. 1 is single scattering and VTK's shading, as the pass draws it, without noise.
   * n > 1: at most n times. 0: any number of times. Range: at least 0. Default: 1.
   *
   * With 1, media with vtkParticipatingMedium::SetMultipleScattering() have it as in the pass, of
   * lamps with an extent as if they were points. With others, paths take its place; such media have
   * no ambient radiance.
   *
   * Light that was scattered or reflected once stays what it is with 1. Paths add the rest:
   *
   * - Surfaces reflect as Lambertian ones, of the diffuse colour of VTK's material (times its
   *   coefficient, or the colours of scalars), at most 1, as albedo. Their highlights reflect only
   *   the lamps that the eye sees in them. Those with lighting switched off reflect nothing.
   * - The ambient light of media, skies included, and the ambient colour of surfaces are light of
   *   order 1 that shines on, as do unlit surfaces. A constant that was to stand for multiple
   *   scattering must be set to 0, else that light counts twice.
   * - Backgrounds shine on nothing. Lights that do not scatter
   *   (vtkAirlightLight::SetScatters()) have order 1 alone.
   * - Translucent surfaces dim what is behind them for the eye; they neither stop nor reflect light
   *   of higher orders.
   *
   * Without absorption anywhere in a closed room, no picture exists for 0.
   */
  void SetScatteringOrders(int orders);
  vtkGetMacro(ScatteringOrders, int);
  ///@}

  ///@{
  /**
   * The number of paths of each pixel, at most where there is a target error or a time limit. The
   * standard error falls as the inverse of its square root. Range: at least 2. Default: 64.
   */
  void SetSamplesPerPixel(int samples);
  vtkGetMacro(SamplesPerPixel, int);
  ///@}

  ///@{
  /**
   * The relative error at which to stop: the root mean square of "StandardError" over the mean of
   * "Radiance", each over all pixels and colours. All pixels have as many paths. 0: no target.
   * Range: finite, at least 0. Default: 0.
   */
  void SetTargetError(double error);
  vtkGetMacro(TargetError, double);
  ///@}

  ///@{
  /**
   * Seconds after which no more paths are added, but for the first two of each pixel; how many
   * there are then depends on the machine, so that the same scene gives other numbers each time. 0:
   * no limit. Range: finite, at least 0. Default: 0.
   */
  void SetTimeLimit(double seconds);
  vtkGetMacro(TimeLimit, double);
  ///@}

  ///@{
  /**
   * Which random numbers are drawn. Pictures of two seeds are independent; the same seed gives the
   * same picture. Default: 0.
   */
  vtkSetMacro(Seed, int);
  vtkGetMacro(Seed, int);
  ///@}

  /**
   * After Update() with ScatteringOrders other than 1: the relative error that was reached, as
   * TargetError defines it; else 0.
   */
  vtkGetMacro(ReachedError, double);

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
  bool ComputeSingle(vtkImageData* image, const airlight::ReferenceTracer& tracer);
  void AddPaths(vtkImageData* image, const airlight::ReferenceTracer& tracer);

  int Size[2] = { 0, 0 };
  double LightRadius = 0.0;
  int LampPoints = 256;
  bool SurfaceShadows = true;
  bool TranslucentShadows = true;
  bool VolumeShadows = false;
  int ScatteringOrders = 1;
  int SamplesPerPixel = 64;
  double TargetError = 0.0;
  double TimeLimit = 0.0;
  int Seed = 0;
  double ReachedError = 0.0;

  class Internals;
  std::unique_ptr<Internals> Impl;
};

#endif
