// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Casters in random places and what a camera sees of points of them.
 */

#ifndef AirlightTestCasters_h
#define AirlightTestCasters_h

#include "AirlightTestTools.h"

#include "vtkActor.h"
#include "vtkCamera.h"
#include "vtkMatrix4x4.h"
#include "vtkShaderProperty.h"

namespace airlight_test
{
// Three unit vectors at right angles.
glm::dmat3 RandomAxes(Random& random);

// In clip coordinates by VTK's own matrix: in a perspective w is the depth. `aspect`: of the picture, width by
// height.
glm::dvec4 Project(vtkCamera* camera, double aspect, const glm::dvec3& point);

// Whether it is in the picture, in or outside of the clipping range. Behind the eye no ray of a perspective
// comes along.
bool IsInPicture(const glm::dvec4& clip);

// A replacement that changes nothing in the actor's shader, of which the pass cannot know that.
void MakeUnknown(vtkActor* actor);
}

#endif
