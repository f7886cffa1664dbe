// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lamps that are not points: each frame of a mean has them at another of their points.
 */

#ifndef AirlightLampSamples_h
#define AirlightLampSamples_h

#include "Photometry/AirlightLightProperties.h"
#include "vtkAirlightModule.h" // for export macro

#include "vtkSmartPointer.h"

#include <glm/glm.hpp>

#include <vector>

class vtkLight;
class vtkRenderer;

namespace airlight
{
// Where a lamp of this extent is for these numbers, from its middle. `axis`: its direction, of
// length 1, 0 where it shines in all directions alike; `up`: its height's, across the axis.
VTKAIRLIGHT_EXPORT glm::dvec3 GetLampOffset(const LampExtent& extent, const glm::dvec3& axis,
  const glm::dvec3& up, const glm::dvec3& numbers);

// The direction of a lamp that shines along one, of length 1; 0 for a lamp that shines in all
// directions alike, and where position and focal point are the same.
glm::dvec3 GetLampAxis(vtkLight* light);

// Whether a renderer has lamps that frames have at different points.
bool HasMovingLamps(vtkRenderer* renderer);

// The lamps of a renderer at their points for a frame, until this goes out of scope.
class MovedLamps
{
public:
  MovedLamps(vtkRenderer* renderer, int number);
  ~MovedLamps();
  MovedLamps(const MovedLamps&) = delete;
  void operator=(const MovedLamps&) = delete;

private:
  struct Place
  {
    vtkSmartPointer<vtkLight> Light;
    glm::dvec3 Position;
    glm::dvec3 FocalPoint;
  };

  void Move(vtkLight* light, const glm::dvec3& numbers);

  std::vector<Place> Places;
};
}

#endif
