// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestMeans.h"

#include "AirlightTestTools.h"

#include "vtkCamera.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

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
}
