// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A mean of frames that grows from one picture to the next, as long as nothing changes.
 */

#ifndef AirlightRefinement_h
#define AirlightRefinement_h

#include "Pass/AirlightSceneStamp.h"

#include "vtkWeakPointer.h"

#include <glm/vec4.hpp>

class vtkObject;
class vtkRenderState;
class vtkRenderer;

namespace airlight
{
class Refinement
{
public:
  // A picture of so many frames in a viewport, by a pass.
  struct Picture
  {
    const vtkRenderState* State;
    vtkObject* Pass;
    vtkObject* Delegate;
    glm::ivec4 Viewport;
    int Count;
    bool Requested; // by the pass, to refine it
  };

  // Whether pictures may be refined: neither eyes nor tiles take turns, and no pass outside draws
  // into a framebuffer of its own, with cameras of its own.
  static bool MayRefine(const vtkRenderState* s);

  // The frames that a picture adds to the mean: from those that it has, 0 if it starts again, to
  // one more, or to all of a scene that changes whenever it is drawn.
  struct Frames
  {
    int First;
    int Last;
  };
  Frames Begin(const Picture& picture);

  // A frame has been drawn: the mean has so many. To be called before others can change the scene.
  void Keep(const Picture& picture, int done);
  void Forget() { this->Done = 0; }

private:
  SceneStamp Stamp;
  vtkWeakPointer<vtkRenderer> Renderer;
  glm::ivec4 Viewport{ 0 };
  int Count = 0;
  int Done = 0;
  int Changes = 0; // of requested pictures, one after the other
};
}

#endif
