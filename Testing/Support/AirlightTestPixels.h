// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A small window with a pass that records its buffers, and the ray of each pixel, computed in
 * double precision from what the user set on the camera.
 */

#ifndef AirlightTestPixels_h
#define AirlightTestPixels_h

#include "vtkAirlightPass.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <glm/glm.hpp>

#include <cmath>

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

  PixelScene()
  {
    this->Window->SetOffScreenRendering(1);
    this->Window->SetMultiSamples(0);
    this->Window->SetSize(Width, Height);
    this->Window->AddRenderer(this->Renderer);
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
    this->Renderer->AutomaticLightCreationOff();
    this->Renderer->SetPass(this->Pass);
    this->Pass->RecordBuffersOn();
    this->Pass->SetMedium(this->Medium);
  }

  // Releases the pass's OpenGL objects while there is a context.
  ~PixelScene() { this->Pass->ReleaseGraphicsResources(this->Window); }
  PixelScene(const PixelScene&) = delete;
  void operator=(const PixelScene&) = delete;

  // Through the centre of pixel (i, j), counted from the lower left; fractions are between pixels.
  PixelRay GetRay(double i, double j)
  {
    vtkCamera* camera = this->Renderer->GetActiveCamera();
    const glm::dvec3 position = Vector(camera->GetPosition());
    const glm::dvec3 forward = glm::normalize(Vector(camera->GetFocalPoint()) - position);
    const glm::dvec3 right = glm::normalize(glm::cross(forward, Vector(camera->GetViewUp())));
    const glm::dvec3 up = glm::cross(right, forward);
    const double y = (2.0 * (j + 0.5) - Height) / Height;
    const double x = (2.0 * (i + 0.5) - Width) / Height; // the aspect ratio is in it
    if (camera->GetParallelProjection())
    {
      const double scale = camera->GetParallelScale(); // half the height
      return { position + scale * (x * right + y * up), forward };
    }
    const double half = std::tan(glm::radians(0.5 * camera->GetViewAngle()));
    return { position, glm::normalize(forward + half * (x * right + y * up)) };
  }

  // One pixel of a buffer of the last frame; null where there is no such buffer.
  const float* GetPixel(const char* name, int i, int j)
  {
    vtkImageData* image = this->Pass->GetBuffer(name);
    return image ? static_cast<float*>(image->GetScalarPointer(i, j, 0)) : nullptr;
  }

  // Where the ray of pixel (i, j) ended in the last frame; far away where it hit nothing.
  double GetEnd(int i, int j)
  {
    const float depth = *this->GetPixel("Depth", i, j);
    return depth >= 0.0f ? depth : 1e18;
  }

  vtkNew<vtkRenderWindow> Window;
  vtkNew<vtkRenderer> Renderer;
  vtkNew<vtkAirlightPass> Pass;
  vtkNew<vtkParticipatingMedium> Medium;

private:
  static glm::dvec3 Vector(const double* v) { return { v[0], v[1], v[2] }; }
};
}

#endif
