// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the functions that read the values of command-line options share: splitting text, and
 * numbers in it. A value has to fit as a whole; blanks, inf and nan never do.
 */

#ifndef OptionNumbers_h
#define OptionNumbers_h

#include "formats/Vector3.h"

#include <string>
#include <vector>

namespace airlight
{

/// Throw UserError: "<option> '<text>': expected <expected>".
[[noreturn]] void FailOption(
  const std::string& option, const std::string& text, const std::string& expected);

std::vector<std::string> SplitText(const std::string& text, char separator);

/// A number with a decimal point, whatever the locale.
bool GetNumber(const std::string& text, double& number);

/// Comma-separated numbers; empty if one is none.
std::vector<double> GetNumbers(const std::string& text);

bool IsInRange(const std::vector<double>& numbers, double low, double high);

/// "x,y,z" as in a scene file: each at most LargestNumber from 0.
bool GetVector(const std::string& text, Vector3& vector);

/// The same, and not 0,0,0.
bool GetDirection(const std::string& text, Vector3& direction);

Vector3 MakeVector(const std::vector<double>& numbers);

}

#endif
