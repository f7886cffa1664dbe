// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/LightOptions.h"

#include "commands/LightText.h"
#include "formats/UserError.h"

namespace airlight
{

namespace
{
using Maker = LightSource (*)(const std::string&, const std::string&);
using Changer = void (*)(const std::string&, const std::string&, LightSource&);

const std::map<std::string, Maker> Makers = { { "--point", ParsePoint }, { "--spot", ParseSpot },
  { "--sun", ParseSun } };

const std::map<std::string, Changer> LampChangers = { { "--ies", ParsePhotometry },
  { "--ies-aim", ParsePhotometryAim }, { "--ies-up", ParsePhotometryUp },
  { "--lamp-radius", ParseLampRadius }, { "--lamp-size", ParseLampSize } };

const std::map<std::string, Changer> SunChangers = { { "--sun-diameter", ParseSunDiameter } };

const std::string Visible = "--lamp-visible";

// The lamp before --lamp-visible.
LightSource& GetLast(std::vector<LightSource>& lights)
{
  if (lights.empty())
  {
    throw UserError(Visible + ": expected behind the --point, --spot or --sun it is for");
  }
  return lights.back();
}

// When all lamps have the size that options give them.
void CheckVisible(const std::vector<LightSource>& lights)
{
  for (const LightSource& light : lights)
  {
    if (light.Visible && !light.HasExtent())
    {
      throw UserError(Visible +
        ": nothing is seen of a point: give its lamp --lamp-radius or --lamp-size, or its sun "
        "--sun-diameter, above 0");
    }
  }
}

// Change the lamp before the option, or add one.
void Apply(const std::string& option, const std::string& text, std::vector<LightSource>& lights)
{
  const auto maker = Makers.find(option);
  if (maker != Makers.end())
  {
    lights.push_back(maker->second(option, text));
    return;
  }
  const bool forSun = SunChangers.count(option) > 0;
  if (lights.empty() || forSun != (lights.back().Type == LightSource::Kind::Directional))
  {
    throw UserError(option + " '" + text + "': expected behind the " +
      (forSun ? "--sun" : "--point or --spot") + " it is for");
  }
  (forSun ? SunChangers : LampChangers).at(option)(option, text, lights.back());
}
}

//------------------------------------------------------------------------------
CLI::Option* LightOptions::Add(const char* name, const char* help)
{
  return this->Command->add_option(name, this->Texts[name], help)
    ->take_all()
    ->allow_extra_args(false);
}

//------------------------------------------------------------------------------
void LightOptions::AddTo(CLI::App* command)
{
  this->Command = command;
  this->Add("--point",
    "x,y,z:I: a point lamp, in place of the scene's lamps; I is its radiant intensity in W/sr, a "
    "number or r,g,b. Repeat it for more lamps");
  this->Add("--spot",
    "x,y,z:tx,ty,tz:ANGLE:I[:EXPONENT]: a spot at x,y,z that aims at tx,ty,tz, in place of the "
    "scene's lamps. ANGLE is the half angle of its cone in degrees, above 0 and below 90; I is the "
    "radiant intensity on its axis in W/sr, a number or r,g,b; off the axis it falls with the "
    "cosine to the power of EXPONENT, 0 to 128 (default 0: even up to a hard edge). Repeat it for "
    "more");
  this->Add("--sun",
    "dx,dy,dz:E: a sun that stands in the direction dx,dy,dz, in place of the scene's lamps; E is "
    "the irradiance in W/m^2 of a surface that faces it, a number or r,g,b. Repeat it for more");
  this->PassOptions = {
    this->Add("--ies",
      "FILE: the --point or --spot before it shines as this photometric file (IES LM-63) says, I "
      "in "
      "its brightest direction"),
    this->Add("--ies-aim",
      "tx,ty,tz: the point at which the axis of the --point with --ies or --lamp-size before it "
      "aims (default: below the lamp, along 0,-1,0)"),
    this->Add("--ies-up",
      "ux,uy,uz: the direction of the file's horizontal angle 0 (type C) or vertical angle 90 "
      "(types A and B), or that of the height of --lamp-size, for the lamp before it (default "
      "0,1,0, or 0,0,1 where that lies along the axis)"),
    this->Add("--lamp-radius",
      "R: the --point before it is a ball of this radius in world units, the --spot or the lamp "
      "with --ies a disc: soft shadows, in means of frames (--antialiasing)"),
    this->Add("--lamp-size",
      "W,H: the --point or --spot before it is a rectangle of this width and height in world "
      "units, across its axis; it shines as evenly as before, with soft shadows"),
    this->Add("--sun-diameter",
      "DEG: the --sun before it is a disc of this many degrees in the sky (the sun: 0.53)"),
    this->Command
      ->add_flag(Visible,
        "The lamp before it is seen, as a bright shape of its --lamp-radius or --lamp-size, or as "
        "a disc of its --sun-diameter in the sky, behind all of the medium")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll),
  };
}

//------------------------------------------------------------------------------
std::vector<LightSource> LightOptions::Read() const
{
  std::vector<LightSource> lights;
  std::map<std::string, std::size_t> used;
  for (const CLI::Option* option : this->Command->parse_order())
  {
    if (option->get_name() == Visible)
    {
      GetLast(lights).Visible = true;
    }
    const auto texts = this->Texts.find(option->get_name());
    if (texts != this->Texts.end())
    {
      Apply(texts->first, texts->second.at(used[texts->first]++), lights);
    }
  }
  CheckVisible(lights);
  return lights;
}

}
