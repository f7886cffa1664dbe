// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Composite/AirlightDisplayStage.h"

#include "AirlightDisplay.h"
#include "OpenGL/AirlightProgram.h"

#include "vtkShaderProgram.h"

#include <cmath>

namespace airlight
{
namespace
{
// Anchors of T. Lottes' generic filmic curve (GDC 2016), of which these values follow the Academy's
// reference rendering; vtkToneMappingPass has the same by default.
constexpr double Contrast = 1.6773;
constexpr double Shoulder = 0.9714;
constexpr double MiddleIn = 0.18;
constexpr double MiddleOut = 0.18;
constexpr double LargestRadiance = 11.0785; // becomes white

// x^a / (x^(a d) b + c), with b and c such that the middle and white are where the anchors say.
void SetFilmic(vtkShaderProgram* program)
{
  const double power = Contrast * Shoulder;
  const double white = std::pow(LargestRadiance, Contrast);
  const double middle = std::pow(MiddleIn, Contrast) / MiddleOut;
  const double whiteShoulder = std::pow(LargestRadiance, power);
  const double clipping = (white - middle) / (whiteShoulder - std::pow(MiddleIn, power));
  const double toe = white - clipping * whiteShoulder;
  const float curve[4] = { static_cast<float>(Contrast), static_cast<float>(power),
    static_cast<float>(clipping), static_cast<float>(toe) };
  program->SetUniform4f("airlightFilmic", curve);
}
}

//------------------------------------------------------------------------------
std::string DisplayStage::GetSource() const
{
  return Define("AIRLIGHT_TONE_MAPPING", static_cast<int>(this->Curve)) +
    Define("AIRLIGHT_COLOR_SPACE", static_cast<int>(this->Space)) +
    Define("AIRLIGHT_DITHERING", this->Dithering) + AirlightDisplay;
}

//------------------------------------------------------------------------------
void DisplayStage::SetUniforms(vtkShaderProgram* program) const
{
  program->SetUniformf("airlightExposure", static_cast<float>(this->Exposure));
  if (this->Curve == ToneMapping::GenericFilmic)
  {
    SetFilmic(program);
  }
  if (this->Dithering)
  {
    const int corner[2] = { this->X, this->Y };
    program->SetUniform2i("airlightPicture", corner);
  }
}
}
