// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameMessages.h"

#include "vtkObjectFactory.h"

#include <algorithm>

namespace airlight_test
{
vtkStandardNewMacro(FrameMessages);

namespace
{
// Limits that the pass' documentation names, in the words of its warnings.
const char* const Announced[] = {
  "cast no shadows on surfaces.", "No shadow planes can be drawn from what the mappers",
  "Shadow maps know of light and dark only", "light surfaces directly only.",
  "is drawn without the medium before it", "SetScatteredSurfaceLight()",
  "Multiple scattering is left out", "Multiple scattering leaves out",
  "was deprecated for VTK", // vtkLODActor calls what VTK has given up
};
}

//------------------------------------------------------------------------------
void FrameMessages::DisplayText(const char* text) { this->Texts.emplace_back(text); }

//------------------------------------------------------------------------------
std::vector<std::string> FrameMessages::TakeUnexpected()
{
  std::vector<std::string> unexpected;
  for (const std::string& text : this->Texts)
  {
    const bool announced = std::any_of(std::begin(Announced), std::end(Announced),
      [&](const char* part) { return text.find(part) != std::string::npos; });
    if (!announced)
    {
      unexpected.push_back(text);
    }
  }
  this->Texts.clear();
  return unexpected;
}
}
