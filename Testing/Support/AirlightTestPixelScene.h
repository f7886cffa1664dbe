// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The fixture for tests of single pixels: a small window with a pass that records its buffers, one
 * plane and one light, if the test adds them, and the ray of each pixel, computed in double
 * precision from what the user set on the camera. Tests of whole pictures use AirlightTestScene.h.
 */

#ifndef AirlightTestPixelScene_h
#define AirlightTestPixelScene_h

#include "vtkActor.h"
#include "vtkAirlightPass.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkPlaneSource.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <glm/glm.hpp>

namespace airlight_test
{
struct PixelRay
{
  glm::dvec3 Origin;
  glm::dvec3 Direction; // unit
};

class PixelScene
{
public:
  static constexpr int Width = 64;
  static constexpr int Height = 48;

  PixelScene();
  // Releases the pass's OpenGL objects while there is a context.
  ~PixelScene();
  PixelScene(const PixelScene&) = delete;
  void operator=(const PixelScene&) = delete;

  // A plane from a corner to two others. It ends rays, is lit, and casts shadows.
  void AddPlane(const glm::dvec3& corner, const glm::dvec3& first, const glm::dvec3& second);

  // A tilted plane through the middle of scenes around the origin, and the light. No shadows, which
  // have their own tests.
  void AddTiltedPlane();

  // A broad diffuse plane z = 0 of this colour, seen obliquely from z > 0.
  void AddBroadPlane(const glm::dvec3& colour = glm::dvec3(1.0));

  // Renders with a clipping range that fits the plane.
  void RenderFitted();

  // Through the centre of pixel (i, j), counted from the lower left; fractions are between pixels.
  PixelRay GetRay(double i, double j);

  // One pixel of a buffer of the last frame; null if there is no such buffer.
  const float* GetPixel(const char* name, int i, int j);

  // Where the ray of pixel (i, j) ended in the last frame; far away if it hit nothing.
  double GetEnd(int i, int j);

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkAirlightPass> Pass;
  vtkNew<vtkParticipatingMedium> Medium;
  vtkNew<vtkLight> Light; // in the renderer once it was added
  vtkNew<vtkPlaneSource> Plane;
  vtkNew<vtkActor> Actor; // of the plane

private:
  vtkNew<vtkPolyDataMapper> Mapper;
};
}

#endif
