// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The rays through the pixels of a camera's picture, in double precision.
 *
 * Not installed; exported for the module's own tests.
 */

#ifndef AirlightCameraRays_h
#define AirlightCameraRays_h

#include "vtkAirlightModule.h" // for export macro

#include <glm/glm.hpp>

#include <array>

class vtkCamera;

namespace airlight
{
class VTKAIRLIGHT_EXPORT CameraRays
{
public:
  // For a picture of this size in pixels. `aspect` is its width by its height.
  CameraRays(vtkCamera* camera, double aspect, int width, int height);

  bool IsValid() const { return this->Valid; }
  bool IsParallel() const { return this->Parallel; }
  // Where all rays meet; in parallel projection the camera's position.
  const glm::dvec3& GetEye() const { return this->Eye; }
  double GetNear() const { return this->Near; }
  double GetFar() const { return this->Far; }
  // Of the picture, in pixels.
  int GetWidth() const { return this->Width; }
  int GetHeight() const { return this->Height; }
  // The camera's axis.
  const glm::dvec3& GetForward() const { return this->Forward; }

  struct Ray
  {
    glm::dvec3 Origin;    // from the eye
    glm::dvec3 Direction; // unit
    double Nearest;       // distances at which the clipping range begins and ends
    double Farthest;
  };

  // Through a point of the picture, in pixels from its lower left corner.
  Ray GetRay(double x, double y) const;

  // A pixel outside the picture's corners, counterclockwise.
  std::array<Ray, 4> GetCornerRays() const;

protected:
  bool Valid = false;
  bool Parallel = false;
  int Width = 0;
  int Height = 0;
  glm::dvec3 Eye{ 0.0 };
  glm::dvec3 Forward{ 0.0 };
  double Near = 0.0;
  double Far = 0.0;
  glm::dvec3 Along{ 0.0 }; // parallel projection: the rays' direction, unit
  double PerDepth = 1.0;   // parallel projection: length of a ray one unit deep
  glm::dmat4 WorldToView{ 1.0 };
  glm::dmat4 WorldToClip{ 1.0 };
  glm::dvec3 Affine[3]; // constant, per x, per y: the rays' directions, one unit deep; in parallel
                        // projection their origins
};
}

#endif
