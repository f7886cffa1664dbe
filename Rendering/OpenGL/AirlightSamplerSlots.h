// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Gives all slots of samplers one state before a frame.
 *
 * Buffer textures have no sampler. Mesa's software renderer leaves their slots as other programs
 * have left them, and compiles each program again for another state: the second frame of a window
 * took as long as the first.
 */

#ifndef AirlightSamplerSlots_h
#define AirlightSamplerSlots_h

#include "OpenGL/AirlightQuad.h"

class vtkOpenGLRenderWindow;
class vtkTextureObject;

namespace airlight
{
class SamplerSlots
{
public:
  // With a program that has as many samplers as OpenGL promises, all of this texture, and draws
  // nothing.
  void Fill(vtkOpenGLRenderWindow* window, vtkTextureObject* texture);

  void Release() { this->Program.Release(); }

private:
  Quad Program;
};
}

#endif
