// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * How far the edges of a picture are from the mean over each pixel.
 */

#ifndef AirlightTestEdges_h
#define AirlightTestEdges_h

#include "AirlightTestTools.h"
#include "AirlightTestWindowScene.h"

#include "vtkCamera.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace airlight_test
{
using Means = std::vector<double>;

// The mean of pictures on a grid of 16 x 16 places in each pixel.
inline Means AverageByHand(vtkRenderWindow* window, vtkRenderer* renderer)
{
  constexpr int Side = 16;
  const int* size = window->GetSize();
  Means sum;
  vtkCamera* camera = renderer->GetActiveCamera();
  for (int i = 0; i < Side * Side; ++i)
  {
    camera->SetWindowCenter(((i % Side + 0.5) / Side - 0.5) * 2.0 / size[0],
      ((i / Side + 0.5) / Side - 0.5) * 2.0 / size[1]);
    const Picture picture = Capture(window);
    sum.resize(picture.size());
    std::transform(picture.begin(), picture.end(), sum.begin(), sum.begin(),
      [](int value, double before) { return before + value / double(Side * Side); });
  }
  camera->SetWindowCenter(0.0, 0.0);
  return sum;
}

// The root mean square of the differences, over the values that one frame has wrong by more than 4
// steps of 255: the edges.
inline double GetEdgeError(const Means& expected, const Picture& one, const Picture& picture)
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
// The mean is of radiance, those by hand are of what the window shows of it: the lamp is where its
// glow, which is cut off at white, is not seen.
inline void HideLamp(WindowScene& scene)
{
  vtkLightCollection* lights = scene.Renderer->GetLights();
  vtkLight* lamp = vtkLight::SafeDownCast(lights->GetItemAsObject(0));
  lamp->SetPosition(3.0, 4.5, 7.0);
  lamp->SetIntensity(4.0);
}
}

#endif
