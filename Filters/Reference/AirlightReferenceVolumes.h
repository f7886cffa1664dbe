// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What volumes take away of lights, for vtkAirlightReference.
 */

#ifndef AirlightReferenceVolumes_h
#define AirlightReferenceVolumes_h

#include "Scene/AirlightVolumeOpacity.h"
#include "Silhouette/AirlightSilhouette.h" // for HomogeneousPoint

#include <glm/glm.hpp>

#include <string>
#include <vector>

class vtkMatrix4x4;
class vtkVolume;

namespace airlight
{
class ReferenceVolumes
{
public:
  // Adds a volume, or a text to GetErrors() if it cannot cast a shadow.
  void Add(vtkVolume* volume, vtkMatrix4x4* toWorld);

  bool IsEmpty() const { return this->Volumes.empty(); }
  const std::vector<std::string>& GetErrors() const { return this->Errors; }

  // Optical depth of the way from a point of the world to a light.
  double GetDepth(const HomogeneousPoint& light, const glm::dvec3& point) const;

private:
  struct Volume
  {
    VolumeOpacity Opacity;
    glm::dmat4 ToPlaces; // counted in points
  };

  std::vector<Volume> Volumes;
  std::vector<std::string> Errors;
};
}

#endif
