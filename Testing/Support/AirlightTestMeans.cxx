// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestMeans.h"

#include "AirlightTestTools.h"
#include "AirlightTestWindowScene.h"

#include "vtkCamera.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkWindowToImageFilter.h"

#include <algorithm>
#include <cmath>

namespace airlight_test
{
//------------------------------------------------------------------------------
Means AverageByHand(
  vtkRenderWindow* window, vtkRenderer* renderer, const std::function<Picture()>& capture)
{
  constexpr int Side = 16;
  const int* size = window->GetSize();
  Means sum;
  vtkCamera* camera = renderer->GetActiveCamera();
  for (int i = 0; i < Side * Side; ++i)
  {
    camera->SetWindowCenter(((i % Side + 0.5) / Side - 0.5) * 2.0 / size[0],
      ((i / Side + 0.5) / Side - 0.5) * 2.0 / size[1]);
    const Picture picture = capture();
    sum.resize(picture.size());
    std::transform(picture.begin(), picture.end(), sum.begin(), sum.begin(),
      [](int value, double before) { return before + value / double(Side * Side); });
  }
  camera->SetWindowCenter(0.0, 0.0);
  return sum;
}

//------------------------------------------------------------------------------
Means AverageByHand(vtkRenderWindow* window, vtkRenderer* renderer)
{
  return AverageByHand(window, renderer, [window] { return Capture(window); });
}

//------------------------------------------------------------------------------
double GetEdgeError(const Means& expected, const Picture& one, const Picture& picture)
{
  double sum = 0.0;
  int count = 0;
  for (size_t i = 0; i < expected.size(); ++i)
  {
    if (std::abs(one[i] - expected[i]) > 4.0)
    {
      sum += std::pow(picture[i] - expected[i], 2);
      ++count;
    }
  }
  Check(count > 100, Text("there are edges: ", count));
  return std::sqrt(sum / std::max(count, 1));
}

//------------------------------------------------------------------------------
void CheckViewports(int width, int height, const Smoothing& smooth)
{
  WindowScene left(width, height, 1);
  smooth(left, left.Window);
  const Picture whole = Capture(left.Window);
  WindowScene right(width, height, 1);
  const auto window = MakeWindow(2 * width, height);
  Place(left, window, 0.0, 0, 0.5, 1);
  Place(right, window, 0.5, 0, 1.0, 1);
  smooth(left, window);
  smooth(right, window);
  const Picture both = Capture(window);
  int different = 0;
  for (int y = 0; y < height; ++y)
  {
    for (int i = 0; i < 3 * width; ++i)
    {
      const int expected = whole[3 * width * y + i];
      different += both[6 * width * y + i] != expected ? 1 : 0;
      different += both[6 * width * y + 3 * width + i] != expected ? 1 : 0;
    }
  }
  Check(different == 0, Text("viewports side by side: ", different, " values differ"));
}

//------------------------------------------------------------------------------
void CheckTiles(int width, int height, const Smoothing& smooth, bool borders)
{
  WindowScene large(2 * width, 2 * height, 1);
  smooth(large, large.Window);
  const Picture whole = Capture(large.Window);
  WindowScene small(width, height, 1);
  smooth(small, small.Window);
  vtkNew<vtkWindowToImageFilter> filter;
  filter->SetInput(small.Window);
  filter->SetScale(2);
  filter->ReadFrontBufferOff();
  filter->Update();
  vtkImageData* tiled = filter->GetOutput();
  const auto* bytes = static_cast<const unsigned char*>(tiled->GetScalarPointer());
  Check(tiled->GetNumberOfPoints() == 4 * width * height, "four tiles");
  int apart = 0;
  for (size_t i = 0; i < whole.size(); ++i)
  {
    const int x = static_cast<int>(i / 3) % (2 * width);
    const int y = static_cast<int>(i / 3) / (2 * width);
    const bool border = x == width - 1 || x == width || y == height - 1 || y == height;
    apart += (borders || !border) && std::abs(whole[i] - bytes[i]) > 1 ? 1 : 0;
  }
  Check(apart == 0, Text("tiles differ in ", apart, " values"));
}

//------------------------------------------------------------------------------
std::vector<double> GetRelativeErrors(vtkImageData* image, const Means& expected)
{
  double mean = 0.0;
  for (const double value : expected)
  {
    mean += value / static_cast<double>(expected.size());
  }
  const int width = image->GetDimensions()[0];
  std::vector<double> errors;
  for (size_t i = 0; i < expected.size(); ++i)
  {
    const int pixel = static_cast<int>(i / 3);
    const double value = GetValue(image, pixel % width, pixel / width, static_cast<int>(i % 3));
    errors.push_back(std::abs(value - expected[i]) / std::max(expected[i], mean));
  }
  std::sort(errors.begin(), errors.end());
  return errors;
}

//------------------------------------------------------------------------------
void CheckBuffers(const Buffers& one, const Buffers& smooth, const Picture& picture)
{
  Check(one.size() == smooth.size(), "the same buffers");
  for (const char* name : { "Depth", "BoundaryCount" })
  {
    Check(AreSame(one.at(name), smooth.at(name)), Text(name, " is of the middle"));
  }
  vtkImageData* radiance = smooth.at("Radiance");
  Check(!AreSame(one.at("Radiance"), radiance), "radiance is a mean at edges");
  const int width = radiance->GetDimensions()[0];
  double most = 0.0;
  for (size_t i = 0; i < picture.size(); ++i)
  {
    const int pixel = static_cast<int>(i / 3);
    const double value = GetValue(radiance, pixel % width, pixel / width, static_cast<int>(i % 3));
    most = std::max(most, std::abs(255.0 * std::min(value, 1.0) - picture[i]));
  }
  Check(most < 0.51, Text("the mean of the radiance is the picture, but for ", most));
}
}
