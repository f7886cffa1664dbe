// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Casters/AirlightCasterOpticalThickness.h"

#include "vtkAirlightPass.h"
#include "vtkInformation.h"
#include "vtkInformationDoubleVectorKey.h"
#include "vtkProp.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace airlight
{
namespace
{
constexpr double ThicknessUnit = 1.0 / (1 << 20);
constexpr double LeastPassing = 1e-6;

std::string Describe(vtkProp* prop, int length, const double* values)
{
  std::ostringstream text;
  text << "SHADOW_OPACITY of the " << prop->GetClassName() << " (" << prop << ") is (";
  for (int i = 0; i < length; ++i)
  {
    text << (i > 0 ? ", " : "") << values[i];
  }
  text
    << "): give three opacities from 0 to 1, red, green and blue. Without them its shadow has the "
       "opacity of its vtkProperty";
  return text.str();
}
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

//------------------------------------------------------------------------------
bool ReadShadowOpacity(vtkProp* prop, glm::dvec3& opacity, std::string& error)
{
  vtkInformation* keys = prop->GetPropertyKeys();
  if (!keys || !keys->Has(vtkAirlightPass::SHADOW_OPACITY()))
  {
    return false;
  }
  const int length = keys->Length(vtkAirlightPass::SHADOW_OPACITY());
  const double* values = keys->Get(vtkAirlightPass::SHADOW_OPACITY());
  // Also false for what is not a number.
  if (length != 3 ||
    !std::all_of(values, values + length, [](double a) { return a >= 0.0 && a <= 1.0; }))
  {
    error = Describe(prop, length, values);
    return false;
  }
  opacity = { values[0], values[1], values[2] };
  return true;
}
}
