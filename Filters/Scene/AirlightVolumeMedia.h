// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Volumes that are media themselves (vtkAirlightPass::SetVolumeScatters()): the density and its
 * extinction are those that VolumeExtinction has, the albedos are the volume's colours.
 *
 * Not installed; exported for the module's own tests.
 */

#ifndef AirlightVolumeMedia_h
#define AirlightVolumeMedia_h

#include "vtkAirlightModule.h" // for export macro
#include "vtkParticipatingMedium.h"
#include "vtkSmartPointer.h"
#include "vtkType.h"

#include <glm/glm.hpp>

#include <map>
#include <string>
#include <vector>

class vtkRenderer;
class vtkVolume;

namespace airlight
{
// A volume of the renderer that is to scatter light.
struct VolumeMedium
{
  vtkVolume* Volume = nullptr;
  vtkSmartPointer<vtkParticipatingMedium> Medium; // null where it cannot, or is all transparent
  std::string Error;                              // then why, in the first case
};

// Those of the last frames.
class VTKAIRLIGHT_EXPORT VolumeMedia
{
public:
  // Of all visible volumes that the renderer has as props of their own and that have the key. Media
  // are made again only if what they depend on has changed.
  std::vector<VolumeMedium> Update(vtkRenderer* renderer);

private:
  struct Entry
  {
    vtkMTimeType Time = 0;
    glm::dmat4 ToWorld{ 0.0 };
    VolumeMedium Found;
    int Age = 0; // calls of Update() since it was used
  };

  const VolumeMedium& Get(vtkVolume* volume);

  std::map<vtkVolume*, Entry> Entries;
};
}

#endif
