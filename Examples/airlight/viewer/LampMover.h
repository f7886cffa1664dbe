// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LampMover_h
#define LampMover_h

class vtkLight;
class vtkRenderer;

namespace airlight
{

/**
 * Move a lamp as the viewer sees it: by shares of the picture's height to the right and up. A lamp
 * at a place moves in the plane through it that is parallel to the picture, so that it follows the
 * mouse, and keeps its direction; a directional light turns about the point it aims at, by half a
 * turn for the picture's height. A lamp behind the camera moves as one as far away as the point
 * that the camera looks at.
 */
void MoveLamp(vtkRenderer* renderer, vtkLight* lamp, double right, double up);

/**
 * Multiply a lamp's distance from the camera; a directional light has none and stays.
 */
void PushLamp(vtkRenderer* renderer, vtkLight* lamp, double factor);

}

#endif
