// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The last step of a picture that is the mean of several frames: from radiance to the screen.
 */

#ifndef AirlightMeanPicture_h
#define AirlightMeanPicture_h

#include "Composite/AirlightDisplayStage.h"
#include "OpenGL/AirlightQuad.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <string>

class vtkOpenGLRenderWindow;
class vtkTextureObject;

namespace airlight
{
class MeanPicture
{
public:
  // Where the mean is, the depths that go with it, and which of the caller's pixels its first is.
  struct Mean
  {
    vtkTextureObject* Radiances;
    vtkTextureObject* Depths;
    glm::ivec2 Corner;
  };

  // Into a viewport (x, y, width, height) of the framebuffer that is bound; `blend`: over what it
  // holds. False with a reason in GetError().
  bool DrawIntoViewport(vtkOpenGLRenderWindow* window, const Mean& mean, const glm::ivec4& viewport,
    const DisplayStage& display, bool blend);

  static std::string GetError();

  void Release() { this->Copy.Release(); }

private:
  Quad Copy;
};
}

#endif
