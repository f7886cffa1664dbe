// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/LightText.h"

#include "commands/OptionNumbers.h"
#include "formats/PhotometryFile.h"
#include "formats/UserError.h"

#include <vtkMath.h>

#include <sstream>
#include <vector>

namespace airlight
{

namespace
{
// One number for all channels, or three.
bool GetPower(const std::string& text, Vector3& power)
{
  const std::vector<double> numbers = GetNumbers(text);
  if ((numbers.size() != 1 && numbers.size() != 3) || !IsInRange(numbers, 0.0, LargestNumber))
  {
    return false;
  }
  power.fill(numbers.front());
  if (numbers.size() == 3)
  {
    power = MakeVector(numbers);
  }
  return true;
}

bool GetNumberInRange(const std::string& text, double low, double high, double& number)
{
  return GetNumber(text, number) && number >= low && number <= high;
}

// The way from one point to another, if it is long enough to have a direction.
bool IsApart(const Vector3& target, const Vector3& position, Vector3& direction)
{
  vtkMath::Subtract(target.data(), position.data(), direction.data());
  return vtkMath::Norm(direction.data()) > 0.0;
}

// Photometric files and rectangles have an axis.
void RequireAxis(const std::string& option, const std::string& text, const LightSource& light)
{
  if (light.PhotometryFile.empty() && !light.IsRectangle())
  {
    throw UserError(
      option + " '" + text + "': expected behind the --ies FILE or --lamp-size of its lamp");
  }
}

std::string DescribeSpot()
{
  std::ostringstream text;
  text << "x,y,z:tx,ty,tz:ANGLE:I or x,y,z:tx,ty,tz:ANGLE:I:EXPONENT with two different points, a "
          "half angle of "
       << SmallestConeAngle << " to " << LargestConeAngle
       << " degrees, an intensity of 0 to 1e30 (a number or r,g,b) and an exponent of 0 to "
       << LargestExponent;
  return text.str();
}
}

//------------------------------------------------------------------------------
LightSource ParsePoint(const std::string& option, const std::string& text)
{
  const std::vector<std::string> parts = SplitText(text, ':');
  LightSource light;
  if (parts.size() != 2 || !GetVector(parts[0], light.Position) || !GetPower(parts[1], light.Power))
  {
    FailOption(option, text, "x,y,z:I or x,y,z:r,g,b with intensities of 0 to 1e30");
  }
  return light;
}

//------------------------------------------------------------------------------
LightSource ParseSpot(const std::string& option, const std::string& text)
{
  const std::vector<std::string> parts = SplitText(text, ':');
  LightSource light;
  light.Type = LightSource::Kind::Spot;
  Vector3 target;
  if (parts.size() < 4 || parts.size() > 5 || !GetVector(parts[0], light.Position) ||
    !GetVector(parts[1], target) || !IsApart(target, light.Position, light.Direction) ||
    !GetNumberInRange(parts[2], SmallestConeAngle, LargestConeAngle, light.ConeHalfAngle) ||
    !GetPower(parts[3], light.Power) ||
    (parts.size() == 5 && !GetNumberInRange(parts[4], 0.0, LargestExponent, light.Exponent)))
  {
    FailOption(option, text, DescribeSpot());
  }
  return light;
}

//------------------------------------------------------------------------------
LightSource ParseSun(const std::string& option, const std::string& text)
{
  const std::vector<std::string> parts = SplitText(text, ':');
  LightSource light;
  light.Type = LightSource::Kind::Directional;
  if (parts.size() != 2 || !GetDirection(parts[0], light.Direction) ||
    !GetPower(parts[1], light.Power))
  {
    FailOption(option, text,
      "dx,dy,dz:E or dx,dy,dz:r,g,b with a direction other than 0 and irradiances of 0 to 1e30");
  }
  vtkMath::MultiplyScalar(light.Direction.data(), -1.0); // the light's travel
  return light;
}

//------------------------------------------------------------------------------
void ParsePhotometry(const std::string& option, const std::string& text, LightSource& light)
{
  if (!light.PhotometryFile.empty())
  {
    throw UserError(option + " '" + text + "': the lamp before it has the photometric file '" +
      light.PhotometryFile + "' already; expected one for each lamp");
  }
  try
  {
    CheckPhotometryFile(text);
  }
  catch (const UserError& error)
  {
    throw UserError(option + " " + error.what());
  }
  light.PhotometryFile = text;
}

//------------------------------------------------------------------------------
void ParsePhotometryAim(const std::string& option, const std::string& text, LightSource& light)
{
  RequireAxis(option, text, light);
  Vector3 target;
  if (light.Type == LightSource::Kind::Spot)
  {
    throw UserError(option + " '" + text + "': expected behind a --point: a --spot aims itself");
  }
  if (!GetVector(text, target) || !IsApart(target, light.Position, light.Direction))
  {
    FailOption(option, text, "tx,ty,tz, another point than that of the lamp");
  }
}

//------------------------------------------------------------------------------
void ParsePhotometryUp(const std::string& option, const std::string& text, LightSource& light)
{
  RequireAxis(option, text, light);
  if (!GetDirection(text, light.PhotometryUp))
  {
    FailOption(option, text, "ux,uy,uz, a direction other than 0");
  }
}

//------------------------------------------------------------------------------
void ParseLampRadius(const std::string& option, const std::string& text, LightSource& light)
{
  if (light.IsRectangle() || !GetNumberInRange(text, 0.0, LargestNumber, light.Radius))
  {
    FailOption(option, text, "a radius of 0 to 1e30 world units, for a lamp without --lamp-size");
  }
}

//------------------------------------------------------------------------------
void ParseLampSize(const std::string& option, const std::string& text, LightSource& light)
{
  const std::vector<double> numbers = GetNumbers(text);
  if (light.Radius > 0.0 || numbers.size() != 2 || !IsInRange(numbers, 0.0, LargestNumber))
  {
    FailOption(option, text,
      "W,H, width and height of 0 to 1e30 world units, for a lamp without --lamp-radius");
  }
  light.Size = { numbers[0], numbers[1] };
}

//------------------------------------------------------------------------------
void ParseSunDiameter(const std::string& option, const std::string& text, LightSource& light)
{
  if (!GetNumberInRange(text, 0.0, LargestAngularDiameter, light.AngularDiameter))
  {
    FailOption(option, text, "an angle of 0 to 179 degrees");
  }
}

}
