// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "commands/OptionNumbers.h"

#include "formats/UserError.h"
#include "scene/Scene.h"

#include <vtkMath.h>

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

namespace airlight
{

//------------------------------------------------------------------------------
void FailOption(const std::string& option, const std::string& text, const std::string& expected)
{
  throw UserError(option + " '" + text + "': expected " + expected);
}

//------------------------------------------------------------------------------
std::vector<std::string> SplitText(const std::string& text, char separator)
{
  std::vector<std::string> parts(1);
  for (char c : text)
  {
    if (c == separator)
    {
      parts.emplace_back();
    }
    else
    {
      parts.back() += c;
    }
  }
  return parts;
}

//------------------------------------------------------------------------------
bool GetNumber(const std::string& text, double& number)
{
  std::istringstream stream(text);
  stream.imbue(std::locale::classic());
  stream >> std::noskipws >> number;
  return !stream.fail() && stream.peek() == std::istringstream::traits_type::eof() &&
    std::isfinite(number);
}

//------------------------------------------------------------------------------
std::vector<double> GetNumbers(const std::string& text)
{
  std::vector<double> numbers;
  for (const std::string& part : SplitText(text, ','))
  {
    double number = 0.0;
    if (!GetNumber(part, number))
    {
      return {};
    }
    numbers.push_back(number);
  }
  return numbers;
}

//------------------------------------------------------------------------------
bool IsInRange(const std::vector<double>& numbers, double low, double high)
{
  return std::all_of(numbers.begin(), numbers.end(),
    [low, high](double number) { return number >= low && number <= high; });
}

//------------------------------------------------------------------------------
bool GetVector(const std::string& text, Vector3& vector)
{
  const std::vector<double> numbers = GetNumbers(text);
  if (numbers.size() != 3 || !IsInRange(numbers, -LargestNumber, LargestNumber))
  {
    return false;
  }
  vector = MakeVector(numbers);
  return true;
}

//------------------------------------------------------------------------------
bool GetDirection(const std::string& text, Vector3& direction)
{
  return GetVector(text, direction) && vtkMath::Norm(direction.data()) > 0.0;
}

//------------------------------------------------------------------------------
Vector3 MakeVector(const std::vector<double>& numbers)
{
  return { numbers[0], numbers[1], numbers[2] };
}

}
