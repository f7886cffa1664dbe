// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the tests of one picture per feature share: a window and coloured bodies.
 */

#ifndef AirlightFeatureScene_h
#define AirlightFeatureScene_h

#include "AirlightCompareScene.h"

#include "vtkCubeSource.h"
#include "vtkOpenGLFXAAPass.h"
#include "vtkRegressionTestImage.h"

#include <cstdlib>

namespace airlighttest
{
class FeatureScene : public Scene
{
public:
  explicit FeatureScene(int width = 640, int height = 480)
    : Scene(width, height)
  {
    this->Renderer->SetBackground(0.0, 0.0, 0.0);
    // The buffers stay as the pass writes them; the picture's edges are smoothed.
    this->Antialiased->SetDelegatePass(this->Pass);
    this->Renderer->SetPass(this->Antialiased);
  }

  // Diffuse, under `ambient` light that no lamp sends.
  static void Paint(vtkActor* actor, const glm::dvec3& albedo, double ambient)
  {
    actor->GetProperty()->SetColor(albedo.x, albedo.y, albedo.z);
    actor->GetProperty()->SetAmbient(ambient);
  }

  vtkActor* AddBox(const glm::dvec3& low, const glm::dvec3& high, const glm::dvec3& albedo)
  {
    vtkNew<vtkCubeSource> cube;
    cube->SetBounds(low.x, high.x, low.y, high.y, low.z, high.z);
    vtkActor* actor = this->Add(cube);
    Paint(actor, albedo, this->AmbientLight);
    return actor;
  }

  vtkActor* AddBall(const glm::dvec3& centre, double radius, const glm::dvec3& albedo)
  {
    vtkNew<vtkSphereSource> sphere;
    sphere->SetCenter(centre.x, centre.y, centre.z);
    sphere->SetRadius(radius);
    sphere->SetThetaResolution(48);
    sphere->SetPhiResolution(48);
    vtkActor* actor = this->Add(sphere);
    actor->GetProperty()->SetInterpolationToPhong();
    Paint(actor, albedo, this->AmbientLight);
    return actor;
  }

  //------------------------------------------------------------------------------
  // Of the largest components.
  double GetPercentile99(const char* name)
  {
    std::vector<double> values;
    for (int pixel = 0; pixel < this->Width * this->Height; ++pixel)
    {
      const glm::dvec3 rgb =
        GetColour(this->GetBuffer(name), pixel % this->Width, pixel / this->Width);
      values.push_back(std::max({ rgb.x, rgb.y, rgb.z }));
    }
    return Errors::Quantile(values, 0.99);
  }

  // The pixel that shows a point.
  glm::ivec2 GetPixel(const glm::dvec3& point)
  {
    // The picture's middle and the rays one pixel beside it and above it span the view.
    const glm::dvec2 middle(0.5 * this->Width, 0.5 * this->Height);
    const Ray centre = this->GetRay(middle.x, middle.y);
    const auto perPixel = [&](double x, double y) {
      const glm::dvec3 d = this->GetRay(middle.x + x, middle.y + y).Direction;
      return d / glm::dot(d, centre.Direction) - centre.Direction;
    };
    const glm::dvec3 right = perPixel(1.0, 0.0);
    const glm::dvec3 up = perPixel(0.0, 1.0);
    glm::dvec3 along = point - centre.Origin;
    along /= glm::dot(along, centre.Direction);
    return { static_cast<int>(middle.x + glm::dot(along, right) / glm::dot(right, right)),
      static_cast<int>(middle.y + glm::dot(along, up) / glm::dot(up, up)) };
  }

  // A test's exit status, the picture's comparison with its baseline included.
  int Finish(int argc, char* argv[])
  {
    const int result = vtkRegressionTestImage(this->Window);
    return result != vtkTesting::FAILED && Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
  }

  Ray GetPixelRay(const glm::ivec2& pixel) { return this->GetRay(pixel.x + 0.5, pixel.y + 0.5); }

  vtkNew<vtkOpenGLFXAAPass> Antialiased;
  double AmbientLight = 0.0;
};
}

#endif
