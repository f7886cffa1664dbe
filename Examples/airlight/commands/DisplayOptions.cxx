// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/DisplayOptions.h"

#include "commands/OptionText.h"
#include "formats/UserError.h"

#include <map>

namespace airlight
{

namespace
{
const char* const Automatic = "auto";

const std::map<std::string, int> Curves = { { "clamp", vtkAirlightPass::CLAMP },
  { "reinhard", vtkAirlightPass::REINHARD }, { "exponential", vtkAirlightPass::EXPONENTIAL },
  { "filmic", vtkAirlightPass::GENERIC_FILMIC }, { "neutral", vtkAirlightPass::NEUTRAL_PBR } };

const std::map<std::string, int> ColorSpaces = { { "srgb", vtkAirlightPass::SRGB },
  { "linear", vtkAirlightPass::LINEAR } };

double ParseExposure(const std::string& text)
{
  const double exposure = ParseNumber("--exposure", text, 0.0, LargestNumber);
  if (!(exposure > 1.0 / LargestNumber))
  {
    throw UserError("--exposure '" + text + "': a factor above 0, or " + Automatic);
  }
  return exposure;
}
}

//------------------------------------------------------------------------------
void DisplayOptions::AddTo(CLI::App* command)
{
  command->add_option("--exposure", this->Exposure,
    "Factor of the radiance; auto shows the picture's middle luminance as middle grey (default "
    "auto; of linear floats 1)");
  command
    ->add_option("--tone-mapping", this->ToneMapping,
      "How radiances above 1 become colours: clamp, reinhard, exponential, filmic, or neutral, "
      "which keeps hues below 0.8 (default neutral)")
    ->check(CLI::IsMember(&Curves));
  command
    ->add_option("--color-space", this->ColorSpace,
      "Numbers of the picture: srgb, which screens expect, or linear (default srgb)")
    ->check(CLI::IsMember(&ColorSpaces));
  command->add_flag("--no-dithering", this->NoDithering,
    "Round to 8 bits as is; else a fixed pattern of less than half a step breaks up the rings of "
    "smooth glows");
}

//------------------------------------------------------------------------------
DisplaySettings DisplayOptions::GetSettings() const
{
  DisplaySettings settings;
  settings.AutomaticExposure = this->Exposure.empty() || this->Exposure == Automatic;
  settings.Exposure = settings.AutomaticExposure ? 1.0 : ParseExposure(this->Exposure);
  if (!this->ToneMapping.empty())
  {
    settings.ToneMapping = Curves.at(this->ToneMapping);
  }
  if (!this->ColorSpace.empty())
  {
    settings.OutputColorSpace = ColorSpaces.at(this->ColorSpace);
  }
  settings.Dithering = !this->NoDithering;
  return settings;
}

//------------------------------------------------------------------------------
double DisplayOptions::GetFactor() const
{
  if (!this->ToneMapping.empty() || !this->ColorSpace.empty() || this->NoDithering)
  {
    throw UserError("--tone-mapping, --color-space and --no-dithering are for pictures: linear "
                    "values stay linear");
  }
  if (this->Exposure == Automatic)
  {
    throw UserError("--exposure auto is for pictures: linear values take a number");
  }
  return this->Exposure.empty() ? 1.0 : ParseExposure(this->Exposure);
}

}
