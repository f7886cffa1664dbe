// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the tests of windows share: a scene that can be drawn anywhere, windows, and comparisons of
 * parts of pictures.
 */

#ifndef AirlightWindowScene_h
#define AirlightWindowScene_h

#include "AirlightTestScene.h"

#include "vtkCubeSource.h"

#include <cstdlib>

namespace airlighttest
{
// Two bodies over a floor in the light of up to two lamps, in fog that leaves the background visible
// beside it.
class WindowScene : public Scene
{
public:
  explicit WindowScene(int width = 120, int height = 90, int lamps = 1)
    : Scene(width, height)
  {
    vtkNew<vtkCubeSource> floor;
    floor->SetBounds(-6, 6, -2.1, -2, -6, 6);
    this->Floor = this->Add(floor);
    this->Ball = this->Add(MakeSphere(1.0), [](vtkActor* a) { a->SetPosition(-1.2, 0, 0); });
    vtkNew<vtkCubeSource> cube;
    this->Cube = this->Add(cube, [](vtkActor* a) { a->SetPosition(1.6, -0.4, 0.5); });
    this->AddPointLight({ 3, 4, 2 });
    if (lamps > 1)
    {
      this->AddPointLight({ -3, 3, 1 }, { 5, 10, 20 });
    }
    this->Medium->SetRegionToBox();
    this->Medium->SetBounds(-7, 7, -3, 5, -7, 7);
  }

  vtkActor* Floor;
  vtkActor* Ball;
  vtkActor* Cube;
};

inline vtkSmartPointer<vtkRenderWindow> MakeWindow(int width, int height)
{
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(width, height);
  return window;
}

// Takes the scene's renderer into a part of another window.
inline void Place(Scene& scene, vtkRenderWindow* window, double x0, double y0, double x1, double y1)
{
  scene.Window->RemoveRenderer(scene.Renderer);
  window->AddRenderer(scene.Renderer);
  scene.Renderer->SetViewport(x0, y0, x1, y1);
}

// A part of a picture that is `stride` pixels wide.
inline Picture Cut(const Picture& picture, int stride, int x0, int y0, int width, int height)
{
  Picture part;
  for (int y = y0; y < y0 + height; ++y)
  {
    const auto row = picture.begin() + 3 * (static_cast<long>(stride) * y + x0);
    part.insert(part.end(), row, row + 3 * width);
  }
  return part;
}

// Number of pixels that differ by more than `most` steps of 1/255.
inline int CountDifferent(const Picture& a, const Picture& b, int most)
{
  int count = a.size() == b.size() ? 0 : static_cast<int>(a.size());
  for (size_t i = 0; i + 2 < std::min(a.size(), b.size()); i += 3)
  {
    count += std::abs(a[i] - b[i]) > most || std::abs(a[i + 1] - b[i + 1]) > most ||
      std::abs(a[i + 2] - b[i + 2]) > most;
  }
  return count;
}

// The largest difference of two buffers, relative to the largest value of the first.
inline double CompareBuffers(vtkImageData* a, vtkImageData* b)
{
  if (!a || !b || a->GetNumberOfPoints() != b->GetNumberOfPoints())
  {
    return Infinity;
  }
  double largest = 0.0;
  double difference = 0.0;
  auto* p = static_cast<float*>(a->GetScalarPointer());
  auto* q = static_cast<float*>(b->GetScalarPointer());
  for (vtkIdType i = 0; i < a->GetNumberOfPoints() * a->GetNumberOfScalarComponents(); ++i)
  {
    const double step = std::abs(static_cast<double>(p[i]) - q[i]);
    largest = std::max(largest, std::abs(static_cast<double>(p[i])));
    difference = step <= difference ? difference : step; // NaN stays
  }
  return difference > 0.0 || std::isnan(difference) ? difference / largest : 0.0;
}

inline double CompareBuffers(const Buffers& a, const Buffers& b)
{
  double largest = 0.0;
  for (const auto& entry : a)
  {
    const double difference = CompareBuffers(entry.second, b.at(entry.first));
    largest = difference <= largest ? largest : difference;
  }
  return largest;
}

// Whether the picture shows something: more than a few colours.
inline bool ShowsScene(const Picture& picture)
{
  const auto range = std::minmax_element(picture.begin(), picture.end());
  return !picture.empty() && *range.second - *range.first > 60;
}
}

#endif
