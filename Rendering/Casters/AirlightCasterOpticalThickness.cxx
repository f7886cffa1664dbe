// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casters/AirlightCasterOpticalThickness.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
constexpr double ThicknessUnit = 1.0 / (1 << 20);
constexpr double LeastPassing = 1e-6;
}

//------------------------------------------------------------------------------
CasterOpticalThickness GetOpticalThickness(const glm::dvec3& opacity)
{
  CasterOpticalThickness thickness;
  for (int c = 0; c < 3; ++c)
  {
    const double passes = 1.0 - opacity[c];
    thickness.Blocks[c] = passes <= LeastPassing ? 1 : 0;
    thickness.Thickness[c] =
      passes <= LeastPassing ? 0 : static_cast<int>(std::lround(-std::log(passes) / ThicknessUnit));
  }
  return thickness;
}

//------------------------------------------------------------------------------
double GetThicknessError(const CasterOpticalThickness& layer)
{
  double error = 0.0;
  for (int c = 0; c < 3; ++c)
  {
    if (layer.Thickness[c] > 0)
    {
      error = std::max(error, 0.5 / (std::exp(1.0) * layer.Thickness[c]));
    }
  }
  return error;
}
}
