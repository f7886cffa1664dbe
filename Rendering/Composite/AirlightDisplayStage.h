// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The last step of a picture, from radiance to the screen: exposure, tone mapping, the output's
 * colour space, dithering, in this order.
 */

#ifndef AirlightDisplayStage_h
#define AirlightDisplayStage_h

#include <string>

class vtkShaderProgram;

namespace airlight
{
// As vtkAirlightPass numbers them.
enum class ToneMapping
{
  Clamp = 0,
  Reinhard = 1,
  Exponential = 2,
  GenericFilmic = 3,
  NeutralPBR = 4
};
enum class ColorSpace
{
  Linear = 0,
  Gamma22 = 1,
  SRGB = 2
};

struct DisplayStage
{
  double Exposure = 1.0; // the factor of the radiance
  ToneMapping Curve = ToneMapping::Clamp;
  ColorSpace Space = ColorSpace::Linear;
  bool Dithering = false;
  int X = 0; // where the renderer's picture begins, in the target's pixels
  int Y = 0;

  // The shader's airlightDisplay(). Exposure is a uniform.
  std::string GetSource() const;

  void SetUniforms(vtkShaderProgram* program) const;
};
}

#endif
