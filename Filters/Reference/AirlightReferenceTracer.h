// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * One pixel of vtkAirlightReference: its ray's surfaces, shadows and integrals.
 */

#ifndef AirlightReferenceTracer_h
#define AirlightReferenceTracer_h

#include "Reference/AirlightReferenceLights.h"
#include "Reference/AirlightReferenceScene.h"
#include "Reference/AirlightReferenceSky.h"
#include "Reference/AirlightReferenceSurface.h"
#include "Scene/AirlightCameraRays.h"
#include "vtkAirlightModule.h" // for export macro

#include <glm/glm.hpp>

#include <vector>

class vtkParticipatingMedium;
class vtkRenderer;

namespace airlight
{
struct ReferencePixel
{
  glm::dvec3 Radiance{ 0.0 };
  glm::dvec3 Airlight{ 0.0 };
  glm::dvec3 Surface{ 0.0 };
  glm::dvec3 Transmittance{ 1.0 };
  double Depth = -1.0;
  double LitLength = 0.0;
};

struct ReferenceSettings
{
  int Width = 0;
  int Height = 0;
  double LightRadius = 0.0;
  int LampPoints = 256;
  bool SurfaceShadows = true;
  bool TranslucentShadows = true;
  bool MultipleScattering = true; // of media that have it
  bool VolumeShadows = false;
};

// What is otherwise on a ray, to find out what rounding does to pictures.
struct ReferenceChange
{
  glm::dvec3 Shift{ 0.0 }; // of the ray, in the world
  double Wider = 1.0;      // the clipping range in which surfaces are seen
  double After = 0.0;      // distance up to which surfaces are not seen
};

// Reads the whole scene when it is made; Trace() may then run in many threads.
class VTKAIRLIGHT_EXPORT ReferenceTracer
{
public:
  ReferenceTracer(vtkRenderer* renderer, const std::vector<vtkParticipatingMedium*>& media,
    const ReferenceSettings& settings);

  // False where the camera's matrices are not finite or cannot be inverted.
  bool IsValid() const { return this->Rays.IsValid(); }
  const ReferenceScene& GetScene() const { return this->Scene; }
  const ReferenceLights& GetLights() const { return this->Lights; }

  // What is to be said of lights that the medium leaves out; empty if there are none.
  std::string DescribeLeftOut() const
  {
    return HasScattering(this->Media) ? this->Lights.DescribeLeftOut() : "";
  }

  // How many lights multiple scattering leaves out.
  int GetScatteredOnce() const { return this->ScatteredOnce; }

  // At a point of the picture, in pixels from its lower left corner; the middle of the first pixel
  // is at 0.5, 0.5.
  ReferencePixel Trace(double x, double y, const ReferenceChange& change = {}) const;

  // The medium before a surface at a distance that others found: airlight, transmittance and lit
  // length.
  ReferencePixel TraceTo(double x, double y, double end) const;

  // ---- For paths of light (AirlightPathTracer.h) ----

  const f64::AirlightMedia& GetMedia() const { return this->Media; }
  const glm::dvec3& GetEye() const { return this->Rays.GetEye(); }
  bool HasSurfaceShadows() const { return this->Settings.SurfaceShadows; }

  // Whether lights shade a triangle; else it shows its colour.
  bool IsShaded(const OccluderTriangle& triangle) const
  {
    return this->Scene.GetPart(triangle).Lighting && !this->Lights.GetAll().empty();
  }

  struct Layer
  {
    double T;
    double Opacity;
  };

  struct EyeRay
  {
    glm::dvec3 Origin; // from the eye
    glm::dvec3 Direction;
    double End = AIRLIGHT_FAR;
    const OccluderTriangle* Triangle = nullptr; // of the opaque surface that ends it
    std::vector<Layer> Layers;                  // translucent surfaces before
  };

  EyeRay FindEyeRay(double x, double y) const;
  ReferenceSurface GetSurface(const EyeRay& ray) const; // that ends it

  // What the media scatter of their ambient radiance into [0, end] of a ray.
  glm::dvec3 GetAmbient(const glm::dvec3& origin, const glm::dvec3& direction, double end) const;

private:
  struct PixelRay;
  using SurfaceHit = ReferenceHit;

  PixelRay MakeRay(double x, double y, const ReferenceChange& change) const;
  void TraceMedium(PixelRay& ray, double end, ReferencePixel& pixel) const;
  bool FindSurface(const Occluders& surfaces, const PixelRay& ray, double after, double before,
    SurfaceHit& hit) const;
  void FindLitParts(PixelRay& ray, double end) const;
  glm::dvec3 GetPassing(const PixelRay& ray, size_t light, double t) const;
  double PassVolumes(const ReferenceLight& light, const glm::dvec3& point) const;
  glm::dvec3 ScatterLight(
    const ReferenceLight& light, const f64::AirlightRay& ray, double from, double to) const;
  glm::dvec3 Scatter(const PixelRay& ray, double end, double* litLength) const;
  glm::dvec4 Shade(const PixelRay& ray, const SurfaceHit& hit) const;
  glm::dvec3 Pass(const PixelRay& ray, double end) const;
  void AddLayers(const PixelRay& ray, double end, glm::dvec3& radiance) const;
  glm::dvec3 GetBackground(double y) const;

  ReferenceSettings Settings;
  CameraRays Rays;
  f64::AirlightMedia Media;
  std::vector<ReferenceSky> Skies; // of all media, if any has one
  int ScatteredOnce = 0;           // lights that multiple scattering leaves out
  ReferenceScene Scene;
  ReferenceLights Lights;
  glm::dvec3 Bottom{ 0.0 }; // of the background
  glm::dvec3 Top{ 0.0 };
};
}

#endif
