// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Photometry/AirlightLightSwitches.h"

#include <algorithm>

namespace airlight
{
//------------------------------------------------------------------------------
const LightSwitches::Entry* LightSwitches::Find(vtkLight* light) const
{
  const auto it = std::find_if(this->Entries.begin(), this->Entries.end(),
    [light](const Entry& entry) { return entry.Light == light; });
  return light && it != this->Entries.end() ? &*it : nullptr;
}

//------------------------------------------------------------------------------
bool LightSwitches::Set(vtkLight* light, bool scatters)
{
  const Entry* own = this->Find(light);
  if (own && own->Scatters == scatters)
  {
    return false;
  }
  this->Entries.erase(
    std::remove_if(this->Entries.begin(), this->Entries.end(),
      [light](const Entry& entry) { return !entry.Light || entry.Light == light; }),
    this->Entries.end());
  this->Entries.push_back({ light, scatters });
  return true;
}

//------------------------------------------------------------------------------
std::string GetCameraLightsText(int count, bool dark)
{
  const std::string lights = count == 1 ? "1 light is" : std::to_string(count) + " lights are";
  return lights +
    " fixed to the camera (headlight or camera light): such lights light surfaces, but the medium "
    "does not scatter them, and they cast no shadows. Call SetLightScatters(light, true) for each "
    "that shall do both, or SetLightScatters(light, false) to silence this." +
    (dark ? " The medium scatters no other light: add a lamp, a vtkLight that stays in the scene "
            "(SetLightTypeToSceneLight(), its default)."
          : "");
}
}
