// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The exposure that shows a picture's middle luminance as middle grey.
 */

#ifndef AirlightExposureMeter_h
#define AirlightExposureMeter_h

#include "Frame/AirlightTargets.h"
#include "OpenGL/AirlightQuad.h"

#include <glm/vec4.hpp>

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkTextureObject;
class vtkWindow;

namespace airlight
{
class ExposureMeter
{
public:
  // Of a part of a texture (corner and size). Binds a framebuffer. While the user moves something
  // the exposure follows what is measured within some tenths of a second. False with a reason in
  // GetError().
  bool Measure(
    vtkOpenGLRenderWindow* window, vtkTextureObject* radiances, const glm::ivec4& picture);

  // The factor of the radiance. What is black does not change it.
  double GetExposure() const { return this->Exposure; }

  const std::string& GetError() const { return this->Error; }
  void Release(vtkWindow* window);

private:
  void Follow(vtkOpenGLRenderWindow* window, double measured);

  Targets Textures;
  Quad LuminanceQuad;
  double Exposure = 1.0;
  double Time = 0.0; // of the last picture, in seconds
  std::string Error;
};

// A block of pixels: the mean of the binary logarithm of their luminance, and how many have any.
struct LuminanceBlock
{
  double Logarithm = 0.0;
  double Count = 0.0;
};

// The exposure for these blocks, 0 if all are black. Neither the brightest, which are lamps, nor
// the darkest count.
double ChooseExposure(std::vector<LuminanceBlock> blocks);
}

#endif
