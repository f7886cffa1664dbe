// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lines and numbers of a photometric file, and errors that know their line.
 */

#ifndef AirlightPhotometricScanner_h
#define AirlightPhotometricScanner_h

#include <sstream>
#include <string>
#include <string_view>
#include <vector>

namespace airlight
{
// Thrown by Scanner, caught by ParsePhotometricText.
struct ScanFailure
{
  size_t Line;
  std::string What;
};

// What a number is, for errors: "vertical angle 3 of 19".
struct Item
{
  const char* Name;
  long Index = 0;
  long Count = 0;
};

// A number or a piece of a file as it stands in errors.
std::string NumberText(double value);
std::string Quote(std::string_view text);

class Scanner
{
public:
  // The text must outlive the scanner.
  explicit Scanner(std::string_view text);

  // Puts the next line into Rest. False at the end. Lines end as on any system; one with bytes that
  // no text has fails.
  bool NextLine();

  // What stands up to the next blank, comma or end of line; empty at the end of the text.
  std::string_view Token();

  // The next token as a finite number.
  double Number(const Item& item);

  // Fails with the present line.
  [[noreturn]] void Fail(const std::string& what) const;
  void Require(bool ok, const Item& item, double value, const char* expected) const
  {
    if (!ok)
    {
      this->FailNumber(item, value, expected);
    }
  }
  void RequireEnds(
    bool ok, const char* name, const std::vector<double>& angles, const char* expected) const;
  [[noreturn]] void FailNumber(const Item& item, double value, const std::string& expected) const;

  std::string_view Rest; // of the present line
  size_t Line = 0;       // from 1 on

private:
  std::string_view Text; // what follows the present line
  std::istringstream Converter;
};
}

#endif
