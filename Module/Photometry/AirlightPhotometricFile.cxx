// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Photometry/AirlightPhotometricFile.h"

#include "Photometry/AirlightPhotometricScanner.h"

#include <algorithm>
#include <cctype>
#include <cmath>

namespace airlight
{
namespace
{
constexpr long MaximumValues = 1000000;
// Neighbouring angles closer than this, in degrees, are one angle in single precision.
constexpr double LeastStep = 1e-4;

std::string_view Trim(std::string_view text)
{
  const size_t first = text.find_first_not_of(" \t\f");
  return first == std::string_view::npos
    ? std::string_view()
    : text.substr(first, text.find_last_not_of(" \t\f") - first + 1);
}

std::string UpperCase(std::string_view text)
{
  std::string result(text);
  std::transform(result.begin(), result.end(), result.begin(),
    [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return result;
}

// Reads a file from its first line to its last.
class Parser
{
public:
  explicit Parser(std::string_view text)
    : Scanner(text)
  {
  }

  PhotometricTable Parse()
  {
    this->SkipLabels();
    this->ReadNumbers();
    this->ReadVertical();
    this->ReadHorizontal();
    this->ReadCandela();
    const std::string_view rest = this->Scanner.Token();
    if (!rest.empty())
    {
      this->Scanner.Fail(Quote(rest) +
        " after the last candela value; expected the end of a file of " +
        std::to_string(this->Table.Vertical.size()) + " vertical and " +
        std::to_string(this->Table.Horizontal.size()) + " horizontal angles");
    }
    return std::move(this->Table);
  }

private:
  // A whole number from 1 on.
  long ReadCount(const char* name, long most)
  {
    const double value = this->Scanner.Number({ name });
    if (!(value >= 1.0 && value <= static_cast<double>(most) && value == std::floor(value)))
    {
      this->Scanner.FailNumber({ name }, value, "a whole number from 1 to " + std::to_string(most));
    }
    return static_cast<long>(value);
  }

  double ReadPositive(const char* name)
  {
    const double value = this->Scanner.Number({ name });
    this->Scanner.Require(value > 0.0, { name }, value, "a number above 0");
    return value;
  }

  // The header and the labels or keywords up to the line of TILT and what belongs to that.
  void SkipLabels()
  {
    while (this->Scanner.NextLine())
    {
      const std::string_view line = Trim(this->Scanner.Rest);
      if (this->Scanner.Line == 1)
      {
        const std::string header = UpperCase(line);
        this->HasLampFactor =
          header.rfind("IESNA:LM-63", 0) != 0 && header.rfind("IES:LM-63", 0) != 0;
      }
      const std::string_view afterTilt =
        UpperCase(line.substr(0, 4)) == "TILT" ? Trim(line.substr(4)) : std::string_view();
      if (!afterTilt.empty() && afterTilt.front() == '=')
      {
        this->Scanner.Rest = {};
        this->SkipTilt(Trim(afterTilt.substr(1)));
        return;
      }
    }
    this->Scanner.Fail("the file has no line TILT=; expected TILT=NONE, TILT=INCLUDE or "
                       "TILT=<file> before the numbers");
  }

  void SkipTilt(std::string_view value)
  {
    const std::string tilt = UpperCase(value);
    if (tilt == "INCLUDE")
    {
      this->ReadCount("lamp-to-luminaire geometry", 3);
      const long count = this->ReadCount("number of tilt angles", 10000);
      for (long i = 1; i <= count; ++i)
      {
        this->Scanner.Number({ "tilt angle", i, count });
      }
      for (long i = 1; i <= count; ++i)
      {
        this->Scanner.Number({ "tilt factor", i, count });
      }
    }
    else if (tilt != "NONE" && tilt.find('.') == std::string::npos)
    {
      this->Scanner.Fail("unknown TILT=" + Quote(value) +
        "; expected TILT=NONE, TILT=INCLUDE or TILT=<file> with a file name that has a dot");
    }
  }

  void ReadNumbers()
  {
    this->ReadCount("number of lamps", 1000000);
    const double lumens = this->Scanner.Number({ "lumens per lamp" });
    this->Scanner.Require(lumens >= 0.0 || lumens == -1.0, { "lumens per lamp" }, lumens,
      "0 or more, or -1 for absolute photometry");
    this->Factor = this->ReadPositive("candela multiplier");
    const long vertical = this->ReadCount("number of vertical angles", MaximumValues);
    const long horizontal = this->ReadCount("number of horizontal angles", MaximumValues);
    if (horizontal > MaximumValues / vertical)
    {
      this->Scanner.Fail("the numbers of vertical and horizontal angles are " +
        std::to_string(vertical) + " and " + std::to_string(horizontal) +
        "; expected a product of at most " + std::to_string(MaximumValues));
    }
    this->Table.Type = static_cast<PhotometricType>(this->ReadCount("photometric type", 3));
    this->ReadCount("type of units", 2);
    for (const char* name : { "width", "length", "height" })
    {
      this->Scanner.Number({ name }); // negative ones tell a shape
    }
    this->Factor *= this->ReadPositive("ballast factor");
    if (this->HasLampFactor)
    {
      this->Factor *= this->ReadPositive("ballast-lamp photometric factor");
    }
    else
    {
      this->Scanner.Number({ "number for future use" });
    }
    const double watts = this->Scanner.Number({ "input watts" });
    this->Scanner.Require(watts >= 0.0, { "input watts" }, watts, "0 or more");
    this->Table.Vertical.resize(vertical);
    this->Table.Horizontal.resize(horizontal);
  }

  // Numbers that ascend.
  void ReadAngles(const char* name, std::vector<double>& angles)
  {
    const long count = static_cast<long>(angles.size());
    for (long i = 0; i < count; ++i)
    {
      const Item item{ name, i + 1, count };
      angles[i] = this->Scanner.Number(item);
      if (i > 0 && !(angles[i] >= angles[i - 1] + LeastStep))
      {
        this->Scanner.FailNumber(item, angles[i],
          "at least " + NumberText(LeastStep) + " more than the angle before it, " +
            NumberText(angles[i - 1]));
      }
      this->Scanner.Require(this->Table.Type == PhotometricType::C || std::abs(angles[i]) <= 90.0,
        item, angles[i], "an angle of type A or B, from -90 to 90");
    }
  }

  void RequireTwo(const char* name, size_t count)
  {
    this->Scanner.Require(count >= 2, { name }, static_cast<double>(count), "2 or more");
  }

  void ReadVertical()
  {
    std::vector<double>& angles = this->Table.Vertical;
    this->RequireTwo("number of vertical angles", angles.size());
    this->ReadAngles("vertical angle", angles);
    if (this->Table.Type == PhotometricType::C)
    {
      const bool ok = (angles.front() == 0.0 || angles.front() == 90.0) &&
        (angles.back() == 90.0 || angles.back() == 180.0);
      this->Scanner.RequireEnds(
        ok, "vertical", angles, "those of type C, 0 to 90, 90 to 180 or 0 to 180");
    }
  }

  void ReadHorizontal()
  {
    std::vector<double>& angles = this->Table.Horizontal;
    const bool isC = this->Table.Type == PhotometricType::C;
    if (!isC)
    {
      this->RequireTwo("number of horizontal angles of type A or B", angles.size());
    }
    this->ReadAngles("horizontal angle", angles);
    const double last = angles.back();
    const bool whole =
      angles.front() == 0.0 && (last == 0.0 || last == 90.0 || (last >= 180.0 && last <= 360.0));
    const bool half = angles.front() == 90.0 && last == 270.0;
    this->Scanner.RequireEnds(!isC || whole || half, "horizontal", angles,
      "those of type C, 0 alone or 0 to 90, 0 to 180 or more up to 360, or 90 to 270");
  }

  void ReadCandela()
  {
    const long count =
      static_cast<long>(this->Table.Vertical.size() * this->Table.Horizontal.size());
    this->Table.Candela.resize(count);
    double largest = 0.0;
    for (long i = 0; i < count; ++i)
    {
      const Item item{ "candela value", i + 1, count };
      const double value = this->Scanner.Number(item);
      this->Scanner.Require(value >= 0.0, item, value, "0 or more");
      this->Table.Candela[i] = value * this->Factor;
      this->Scanner.Require(std::isfinite(this->Table.Candela[i]), item, value,
        "a number that stays finite times multiplier and ballast factor");
      largest = std::max(largest, this->Table.Candela[i]);
    }
    if (!std::isnormal(largest))
    {
      this->Scanner.Fail(
        "the largest candela value is " + NumberText(largest) + "; expected one above 0");
    }
  }

  airlight::Scanner Scanner;
  PhotometricTable Table;
  bool HasLampFactor = false;
  double Factor = 1.0;
};
}

//------------------------------------------------------------------------------
bool ParsePhotometricText(
  const std::string& text, const std::string& name, PhotometricTable& table, std::string& error)
{
  try
  {
    if (text.size() > MaximumPhotometricText)
    {
      throw ScanFailure{ 1,
        "the file is longer than " + std::to_string(MaximumPhotometricText) +
          " bytes; expected a photometric file" };
    }
    table = Parser(text).Parse();
    return true;
  }
  catch (const ScanFailure& failure)
  {
    error = name + ":" + std::to_string(failure.Line) + ": " + failure.What;
    return false;
  }
}
}
