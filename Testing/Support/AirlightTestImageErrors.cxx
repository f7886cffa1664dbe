// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestImageErrors.h"

#include "AirlightTestTools.h"

#include "vtkImageData.h"

#include <cmath>

namespace airlight_test
{
//------------------------------------------------------------------------------
double GetMean(vtkImageData* image)
{
  double sum = 0.0;
  const int* size = image->GetDimensions();
  for (int i = 0; i < size[0] * size[1]; ++i)
  {
    sum += GetValue(image, i % size[0], i / size[0]);
  }
  return sum / (size[0] * size[1]);
}

//------------------------------------------------------------------------------
double GetError(const Buffers& picture, const Buffers& exact, const std::string& name)
{
  double squares = 0.0;
  const int* size = exact.at(name)->GetDimensions();
  for (int i = 0; i < size[0] * size[1]; ++i)
  {
    const double error = GetValue(picture.at(name), i % size[0], i / size[0]) -
      GetValue(exact.at(name), i % size[0], i / size[0]);
    squares += error * error;
  }
  return std::sqrt(squares / (size[0] * size[1])) / GetMean(exact.at(name));
}
}
