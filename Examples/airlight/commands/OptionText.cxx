// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/OptionText.h"

#include "commands/OptionNumbers.h"

#include <vtkMath.h>

#include <algorithm>
#include <limits>
#include <sstream>
#include <vector>

namespace airlight
{

namespace
{
constexpr int MaximumImageSize = 16384; // what graphics cards take
constexpr double Unlimited = std::numeric_limits<double>::infinity();

// A whole number from 1 to 16384, in digits alone.
bool IsWhole(const std::string& text)
{
  return !text.empty() && text.size() <= 5 &&
    std::all_of(text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; }) &&
    std::stoi(text) >= 1 && std::stoi(text) <= MaximumImageSize;
}

// Any direction will do as "up" that does not run along the view.
Vector3 ChooseViewUp(const Vector3& position, const Vector3& focalPoint, const Vector3& wanted)
{
  Vector3 forward;
  vtkMath::Subtract(focalPoint.data(), position.data(), forward.data());
  for (const Vector3& up : { wanted, Vector3{ 0.0, 1.0, 0.0 }, Vector3{ 0.0, 0.0, -1.0 } })
  {
    Vector3 right;
    vtkMath::Cross(forward.data(), up.data(), right.data());
    if (vtkMath::Norm(right.data()) >
      1e-6 * vtkMath::Norm(forward.data()) * vtkMath::Norm(up.data()))
    {
      return up;
    }
  }
  return wanted;
}
}

//------------------------------------------------------------------------------
double ParseNumber(const std::string& option, const std::string& text, double low, double high)
{
  double number = 0.0;
  if (!GetNumber(text, number) || number < low || number > high)
  {
    std::ostringstream expected;
    expected << "a number of at least " << low;
    if (high < std::numeric_limits<double>::max())
    {
      expected << " and at most " << high;
    }
    FailOption(option, text, expected.str());
  }
  return number;
}

//------------------------------------------------------------------------------
Vector3 ParseColor(const std::string& option, const std::string& text)
{
  const std::vector<double> numbers = GetNumbers(text);
  if (numbers.size() != 3 || !IsInRange(numbers, 0.0, Unlimited))
  {
    FailOption(option, text, "r,g,b with numbers of at least 0");
  }
  return MakeVector(numbers);
}

//------------------------------------------------------------------------------
std::pair<int, int> ParseSize(const std::string& option, const std::string& text)
{
  const std::vector<std::string> parts = SplitText(text, 'x');
  if (parts.size() == 2 && IsWhole(parts[0]) && IsWhole(parts[1]))
  {
    return { std::stoi(parts[0]), std::stoi(parts[1]) };
  }
  FailOption(option, text, "WxH with whole numbers from 1 to 16384");
}

//------------------------------------------------------------------------------
CameraSettings ParseCamera(
  const std::string& option, const std::string& text, const CameraSettings& camera)
{
  const std::vector<std::string> parts = SplitText(text, ':');
  const std::vector<double> position = GetNumbers(parts[0]);
  const std::vector<double> focalPoint =
    parts.size() > 1 ? GetNumbers(parts[1]) : std::vector<double>();
  double angle = camera.ViewAngle;
  const bool angleFits =
    parts.size() < 3 || (GetNumber(parts[2], angle) && angle >= 0.001 && angle <= 179.0);
  if (parts.size() > 3 || position.size() != 3 || focalPoint.size() != 3 || !angleFits ||
    position == focalPoint)
  {
    FailOption(option, text,
      "px,py,pz:fx,fy,fz or px,py,pz:fx,fy,fz:angle with two different points and an angle of at "
      "most 179 degrees");
  }
  CameraSettings changed = camera;
  changed.Position = MakeVector(position);
  changed.FocalPoint = MakeVector(focalPoint);
  changed.ViewUp =
    ChooseViewUp(changed.Position, changed.FocalPoint, camera.Vertical.value_or(camera.ViewUp));
  changed.ViewAngle = angle;
  return changed;
}

//------------------------------------------------------------------------------
std::string NumberFile(const std::string& option, const std::string& fileName, int number)
{
  // Not left to printf, which would do whatever else the name says.
  const std::size_t begin = fileName.find('%');
  std::size_t end = begin == std::string::npos ? begin : begin + 1;
  std::size_t width = 0;
  if (end != std::string::npos && fileName[end] == '0' && fileName[end + 1] >= '1' &&
    fileName[end + 1] <= '9')
  {
    width = static_cast<std::size_t>(fileName[end + 1] - '0');
    end += 2;
  }
  if (end == std::string::npos || fileName[end] != 'd' || fileName.rfind('%') != begin)
  {
    FailOption(option, fileName, "a name with one %d or %04d for the number of the frame");
  }
  std::string digits = std::to_string(number);
  digits.insert(0, digits.size() < width ? width - digits.size() : 0, '0');
  return fileName.substr(0, begin) + digits + fileName.substr(end + 1);
}

}
