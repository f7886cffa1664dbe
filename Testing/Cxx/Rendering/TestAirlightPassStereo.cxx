// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass in stereo: each eye sees what a camera at its place sees.
//
// VTK shears the projection: with view coordinates (x, y, z), angle a between the eyes and distance
// d of the focal point, x becomes x -+ tan(a/2) (z + d). The rays then meet at x = e = -+ d
// tan(a/2), z = 0, and pass the focal plane where they did. The same rays come from a camera moved
// by e, with its frustum moved back: the frustum is d tan(v/2) aspect wide to each side in the
// focal plane, so that its centre is -e / (d tan(v/2) aspect) of that beside it.

#include "AirlightTestWindowScene.h"

using namespace airlight_test;

namespace
{
constexpr double EyeAngle = 6.0;

// What does not depend on where the viewer is: no highlights.
struct StereoScene : WindowScene
{
  StereoScene()
    : WindowScene(121, 90, 2)
  {
    this->Renderer->GetActiveCamera()->SetEyeAngle(EyeAngle);
    this->Cube->GetProperty()->SetOpacity(0.5);
  }
};

// `side` -1: left, 1: right.
void MoveCamera(StereoScene& scene, double side)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  const double distance = camera->GetDistance();
  const double offset = side * distance * std::tan(glm::radians(0.5 * EyeAngle));
  // The scene's camera looks along a vertical plane x = 0.
  camera->SetPosition(offset, 1, 10);
  camera->SetFocalPoint(offset, 0, 0);
  const double half = camera->GetParallelProjection()
    ? camera->GetParallelScale()
    : distance * std::tan(glm::radians(0.5 * camera->GetViewAngle()));
  camera->SetWindowCenter(-offset / (half * scene.Width / scene.Height), 0.0);
}

//------------------------------------------------------------------------------
void TestEye(double side)
{
  StereoScene moved;
  MoveCamera(moved, side);
  const Buffers expected = moved.Render();
  const Picture picture = Capture(moved.Window);

  StereoScene scene;
  const Picture middle = Capture(scene.Window);
  scene.Window->SetStereoType(side < 0.0 ? VTK_STEREO_LEFT : VTK_STEREO_RIGHT);
  scene.Window->StereoRenderOn();
  const Buffers buffers = scene.Render();
  const Picture stereo = Capture(scene.Window);
  const std::string what = side < 0.0 ? "left eye" : "right eye";
  CheckFinite(buffers, what);
  for (const char* name : { "Depth", "Airlight", "Radiance", "Transmittance", "LitLength" })
  {
    // Of all pixels but those at edges of bodies and shadows, where rounding decides.
    vtkImageData* a = expected.at(name);
    vtkImageData* b = buffers.at(name);
    double floor = 0.0;
    for (int i = 0; i < scene.Width * scene.Height; ++i)
    {
      floor = std::max(floor, 1e-3 * GetValue(a, i % scene.Width, i / scene.Width));
    }
    int wrong = 0;
    double worst = 0.0;
    for (int i = 0; i < scene.Width * scene.Height; ++i)
    {
      const double x = GetValue(a, i % scene.Width, i / scene.Width);
      const double y = GetValue(b, i % scene.Width, i / scene.Width);
      const double error = std::abs(x - y) / std::max(std::abs(x), floor);
      worst = error <= 1e-4 ? std::max(worst, error) : worst;
      wrong += !(error <= 1e-4);
    }
    std::cout << what << ", " << name << ": " << wrong << " pixels differ by more than 1e-4, the"
              << " others by " << worst << "\n";
    Check(wrong <= 5, what + ": " + name + " is that of a camera there");
  }
  const int different = CountDifferent(picture, stereo, 1);
  std::cout << what << ": " << different << " pixels differ from those of a camera there, "
            << CountDifferent(picture, middle, 1) << " from the middle's\n";
  Check(different <= 5, what + ": the picture is that of a camera there");
  Check(CountDifferent(picture, middle, 1) > 1000, what + ": it is not the middle's");
}

//------------------------------------------------------------------------------
// The shear tilts the rays of a parallel projection: x0 -+ tan(a/2) (z + d) where x0 was before.
Answer TraceTilted(Scene& scene, double px, double py)
{
  const double slope = std::tan(glm::radians(0.5 * EyeAngle));
  const glm::dvec3 right(1.0, 0.0, 0.0);
  Ray ray = scene.GetRay(px, py);
  const glm::dvec3 tilted = ray.Direction - slope * right;
  ray.Origin += slope * scene.Renderer->GetActiveCamera()->GetDistance() * right;
  ray.Direction = glm::normalize(tilted);
  ray.Nearest *= glm::length(tilted);
  return Trace(scene.Triangles, scene.Lights, scene.Medium, ray);
}

bool IsTiltedUnstable(Scene& scene, double px, double py, const Answer& answer)
{
  for (int i = 0; i < 4; ++i)
  {
    const Answer other =
      TraceTilted(scene, px + (i % 2 == 0 ? -0.02 : 0.02), py + (i < 2 ? -0.02 : 0.02));
    if (std::abs(other.Airlight.x / answer.Airlight.x - 1.0) > 0.01 ||
      std::abs(other.Depth - answer.Depth) > 0.1)
    {
      return true;
    }
  }
  return false;
}

void TestParallel()
{
  StereoScene scene;
  scene.Cube->GetProperty()->SetOpacity(1.0);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  scene.Renderer->GetActiveCamera()->SetParallelScale(3.0);
  scene.Window->SetStereoTypeToRight();
  scene.Window->StereoRenderOn();
  const Buffers buffers = scene.Render();
  CheckFinite(buffers, "parallel stereo");
  std::vector<double> errors;
  int rays = 0;
  for (int y = 1; y < scene.Height; y += 5)
  {
    for (int x = 1; x < scene.Width; x += 5, ++rays)
    {
      const Answer answer = TraceTilted(scene, x + 0.5, y + 0.5);
      if (IsTiltedUnstable(scene, x + 0.5, y + 0.5, answer))
      {
        continue;
      }
      const double airlight = GetValue(buffers.at("Airlight"), x, y) / answer.Airlight.x - 1.0;
      const double depth = GetValue(buffers.at("Depth"), x, y) - answer.Depth;
      errors.push_back(std::max(std::abs(airlight), std::abs(depth)));
    }
  }
  std::sort(errors.begin(), errors.end());
  const auto used = static_cast<int>(errors.size());
  std::cout << "parallel stereo: " << used << " of " << rays << " rays; errors " << errors[used / 2]
            << " (median), " << errors.back() << " (largest)\n";
  Check(used > 0.9 * rays, "parallel stereo: most rays are decided");
  Check(errors[used / 2] < 1e-5 && errors[used * 99 / 100] < 1e-3, "parallel stereo: as traced");
}

//------------------------------------------------------------------------------
// VTK takes each second column of either eye's picture for one half of the window.
void TestSplit()
{
  StereoScene scene;
  scene.Window->StereoRenderOn();
  scene.Window->SetStereoTypeToLeft();
  const Picture left = Capture(scene.Window);
  scene.Window->SetStereoTypeToRight();
  const Picture right = Capture(scene.Window);
  scene.Window->SetStereoTypeToSplitViewportHorizontal();
  const Picture split = Capture(scene.Window);
  const int middle = (scene.Width + 1) / 2;
  int different = 0;
  for (int y = 0; y < scene.Height; ++y)
  {
    for (int x = 0; x < scene.Width / 2; ++x)
    {
      const int row = y * scene.Width;
      for (int k = 0; k < 3; ++k)
      {
        different += split[3 * (row + x) + k] != left[3 * (row + 2 * x) + k];
        different += split[3 * (row + middle + x) + k] != right[3 * (row + 2 * x) + k];
      }
    }
  }
  std::cout << "split viewport: " << different << " values differ from the eyes' own\n";
  Check(different == 0, "split viewport: both eyes");
  Check(Compare(left, right) > 20, "the eyes see different pictures");
}
}

//------------------------------------------------------------------------------
int TestAirlightPassStereo(int, char*[])
{
  TestEye(-1.0);
  TestEye(1.0);
  TestParallel();
  TestSplit();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
