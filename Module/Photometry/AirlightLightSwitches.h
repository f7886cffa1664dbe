// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which lights of a renderer a medium scatters: those of the scene, unless the user says otherwise.
 */

#ifndef AirlightLightSwitches_h
#define AirlightLightSwitches_h

#include "vtkAirlightModule.h" // for export macro

#include "vtkLight.h"
#include "vtkWeakPointer.h"

#include <string>
#include <vector>

namespace airlight
{
// Headlights and camera lights are there to show surfaces. Scattered, they would veil every picture
// evenly.
inline bool IsFixedToCamera(vtkLight* light) { return !light->LightTypeIsSceneLight(); }

class VTKAIRLIGHT_EXPORT LightSwitches
{
public:
  // False if the light was set so before. Forgets lights that are gone.
  bool Set(vtkLight* light, bool scatters);

  bool IsSet(vtkLight* light) const { return this->Find(light) != nullptr; }
  bool Scatters(vtkLight* light) const
  {
    const Entry* entry = this->Find(light);
    return entry ? entry->Scatters : light && !IsFixedToCamera(light);
  }

private:
  struct Entry
  {
    vtkWeakPointer<vtkLight> Light;
    bool Scatters;
  };

  const Entry* Find(vtkLight* light) const;

  std::vector<Entry> Entries;
};

// The warning about so many lights that are fixed to the camera and not set. `dark`: the medium
// scatters no other light.
VTKAIRLIGHT_EXPORT std::string GetCameraLightsText(int count, bool dark);
}

#endif
