// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lamps that are seen as bright shapes: vtkAirlightLight::SetVisible().
 */

#ifndef AirlightLampShapes_h
#define AirlightLampShapes_h

#include "vtkSmartPointer.h"

#include <glm/vec2.hpp>

#include <map>
#include <vector>

class vtkActor;
class vtkCamera;
class vtkLight;
class vtkProp;
class vtkRenderer;
class vtkWindow;

namespace airlight
{
class LampShapes
{
public:
  // The shapes of a renderer's lamps, for its camera; they cast no shadows, as they are none of its
  // props. `linear`: the colours of surfaces are radiances, else their powers of 1/2.2.
  const std::vector<vtkProp*>& Update(vtkRenderer* renderer, bool linear);

  bool IsEmpty() const { return this->Props.empty(); }

  // The distances before the camera, along its view, between which they are; 0 and 0 for none.
  const glm::dvec2& GetRange() const { return this->Range; }

  void Release(vtkWindow* window);

private:
  void AddToRange(vtkCamera* camera, vtkActor* actor);

  std::map<vtkLight*, vtkSmartPointer<vtkActor>> Actors;
  std::vector<vtkProp*> Props;
  glm::dvec2 Range{ 0.0 };
};

// Whether a light was set to be visible, though nothing is seen of it.
bool IsInvisiblePoint(vtkLight* light);
}

#endif
