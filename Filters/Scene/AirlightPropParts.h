// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The actors that a prop draws: the prop itself, the parts of an assembly, or a level of detail.
 */

#ifndef AirlightPropParts_h
#define AirlightPropParts_h

#include <functional>

class vtkActor;
class vtkMatrix4x4;
class vtkProp;

namespace airlight
{
using VisitActor = std::function<void(vtkActor* actor, vtkMatrix4x4* toWorld)>;

// For each visible actor. A vtkLODProp3D draws the level of detail that VTK chose for its last
// frame; before its first frame, the one that is selected or was added first. `skip` gets the props
// that draw no actor: a vtkLODProp3D that shows a volume or an image, or any other prop.
void VisitParts(
  vtkProp* prop, const VisitActor& visit, const std::function<void(vtkProp* part)>& skip);
}

#endif
