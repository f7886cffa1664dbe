// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lamps that are seen as bright shapes: vtkAirlightLight::SetVisible().
 */

#ifndef AirlightLampShapes_h
#define AirlightLampShapes_h

#include "vtkSmartPointer.h"

#include <map>
#include <vector>

class vtkActor;
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

  void Release(vtkWindow* window);

private:
  std::map<vtkLight*, vtkSmartPointer<vtkActor>> Actors;
  std::vector<vtkProp*> Props;
};

// Whether a lamp was set to be visible and has no extent.
bool IsInvisiblePoint(vtkLight* light);
}

#endif
