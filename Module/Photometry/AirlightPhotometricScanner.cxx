// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Photometry/AirlightPhotometricScanner.h"

#include <algorithm>
#include <cmath>
#include <locale>

namespace airlight
{
namespace
{
// LM-63 allows 256 characters at most, but programs write whole tables into one line.
constexpr size_t MaximumLine = 1000000;

std::string ItemText(const Item& item)
{
  const std::string name = item.Name;
  return item.Count == 0
    ? name
    : name + " " + std::to_string(item.Index) + " of " + std::to_string(item.Count);
}

bool IsText(unsigned char byte)
{
  return (byte >= 0x20 && byte != 0x7f) || (byte >= '\t' && byte <= '\r');
}
}

//------------------------------------------------------------------------------
std::string NumberText(double value)
{
  std::ostringstream out;
  out.imbue(std::locale::classic());
  out.precision(10);
  out << value;
  return out.str();
}

//------------------------------------------------------------------------------
std::string Quote(std::string_view text)
{
  constexpr size_t Most = 40;
  std::string result = "'";
  for (const unsigned char byte : text.substr(0, Most))
  {
    result += byte >= 0x20 && byte < 0x7f ? static_cast<char>(byte) : '?';
  }
  return result + (text.size() > Most ? "...'" : "'");
}

//------------------------------------------------------------------------------
Scanner::Scanner(std::string_view text)
  : Text(text)
{
  // A byte order mark before and the end-of-file character of DOS behind the text are no text.
  constexpr std::string_view Mark = "\xef\xbb\xbf";
  if (this->Text.substr(0, Mark.size()) == Mark)
  {
    this->Text.remove_prefix(Mark.size());
  }
  while (!this->Text.empty() && this->Text.back() == '\x1a')
  {
    this->Text.remove_suffix(1);
  }
  this->Converter.imbue(std::locale::classic());
}

//------------------------------------------------------------------------------
bool Scanner::NextLine()
{
  this->Rest = {};
  if (this->Text.empty())
  {
    return false;
  }
  ++this->Line;
  const size_t length = std::min(this->Text.find_first_of("\r\n"), this->Text.size());
  const std::string_view line = this->Text.substr(0, length);
  const auto bad = std::find_if_not(line.begin(), line.end(), IsText);
  if (bad != line.end())
  {
    this->Fail("a byte of value " + std::to_string(static_cast<unsigned char>(*bad)) +
      " is in the line; expected text");
  }
  if (length > MaximumLine)
  {
    this->Fail("the line has " + std::to_string(length) + " characters; expected at most " +
      std::to_string(MaximumLine));
  }
  this->Rest = line;
  this->Text.remove_prefix(length);
  const size_t end = this->Text.substr(0, 2) == "\r\n" ? 2 : 1;
  this->Text.remove_prefix(std::min(end, this->Text.size()));
  return true;
}

//------------------------------------------------------------------------------
std::string_view Scanner::Token()
{
  constexpr std::string_view Separators = " \t\v\f,";
  size_t start = this->Rest.find_first_not_of(Separators);
  while (start == std::string_view::npos)
  {
    if (!this->NextLine())
    {
      return {};
    }
    start = this->Rest.find_first_not_of(Separators);
  }
  this->Rest.remove_prefix(start);
  const size_t length = std::min(this->Rest.find_first_of(Separators), this->Rest.size());
  const std::string_view token = this->Rest.substr(0, length);
  this->Rest.remove_prefix(length);
  return token;
}

//------------------------------------------------------------------------------
double Scanner::Number(const Item& item)
{
  const std::string_view token = this->Token();
  if (token.empty())
  {
    this->Fail("the file ends where the " + ItemText(item) + " was expected");
  }
  // The stream's own locale keeps the point a point whatever the program's locale is.
  double value = 0.0;
  this->Converter.clear();
  this->Converter.str(std::string(token));
  this->Converter >> value;
  if (this->Converter.fail() || !std::isfinite(value) ||
    this->Converter.peek() != std::istringstream::traits_type::eof())
  {
    this->Fail(Quote(token) + " is no finite number; expected the " + ItemText(item));
  }
  return value;
}

//------------------------------------------------------------------------------
void Scanner::Fail(const std::string& what) const
{
  throw ScanFailure{ std::max<size_t>(this->Line, 1), what };
}

//------------------------------------------------------------------------------
void Scanner::FailNumber(const Item& item, double value, const std::string& expected) const
{
  this->Fail("the " + ItemText(item) + " is " + NumberText(value) + "; expected " + expected);
}

//------------------------------------------------------------------------------
void Scanner::RequireEnds(
  bool ok, const char* name, const std::vector<double>& angles, const char* expected) const
{
  if (!ok)
  {
    this->Fail(std::string("the ") + name + " angles go from " + NumberText(angles.front()) +
      " to " + NumberText(angles.back()) + "; expected " + expected);
  }
}
}
