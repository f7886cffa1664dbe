// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The exposure that shows a picture's middle luminance as middle grey.
 */

#ifndef AirlightExposureMeter_h
#define AirlightExposureMeter_h

#include "Frame/AirlightTargets.h"
#include "OpenGL/AirlightQuad.h"

#include "vtkAirlightModule.h" // for export macro
#include "vtkWeakPointer.h"

#include <glm/vec4.hpp>

#include <string>
#include <vector>

class vtkOpenGLRenderWindow;
class vtkRenderWindow;
class vtkRenderer;
class vtkTextureObject;
class vtkWindow;

namespace airlight
{
// Whether the user moves something: interactor styles then let the window ask for frames.
bool IsMoving(vtkRenderWindow* window);

class ExposureMeter
{
public:
  // Of a renderer's picture, a part of a texture (corner and size). Binds a framebuffer. While the
  // user moves something the exposure follows what is measured within some tenths of a second. The
  // right eye has the left one's, a tile that of the picture before. False with a reason in
  // GetError().
  bool Measure(vtkRenderer* renderer, vtkTextureObject* radiances, const glm::ivec4& picture);

  // The factor of the radiance. What is black does not change it.
  double GetExposure() const { return this->Exposure; }

  const std::string& GetError() const { return this->Error; }
  void Release(vtkWindow* window);

private:
  bool IsPart(vtkRenderer* renderer) const;
  void Follow(vtkOpenGLRenderWindow* window, double measured);

  Targets Textures;
  Quad LuminanceQuad;
  vtkWeakPointer<vtkRenderer> Measured; // whose exposure it is
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
// the darkest count, nor what is black but for roundings.
VTKAIRLIGHT_EXPORT double ChooseExposure(std::vector<LuminanceBlock> blocks);
}

#endif
