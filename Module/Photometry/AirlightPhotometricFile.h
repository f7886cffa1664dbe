// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The text of a photometric file, IES LM-63, as a table: nothing is expanded or scaled. What of a
 * file is read and what is ignored stands in AirlightPhotometry.h.
 */

#ifndef AirlightPhotometricFile_h
#define AirlightPhotometricFile_h

#include <string>
#include <vector>

namespace airlight
{
// The coordinates of a file, by their numbers in it.
enum class PhotometricType
{
  C = 1,
  B = 2,
  A = 3
};

struct PhotometricTable
{
  PhotometricType Type = PhotometricType::C;
  std::vector<double> Vertical;   // degrees, ascending
  std::vector<double> Horizontal; // degrees, ascending
  std::vector<double> Candela;    // all vertical angles of the first horizontal one, and so on
};

// Longer files are refused: the largest table needs less.
constexpr size_t MaximumPhotometricText = size_t(32) << 20;

// False and "NAME:LINE: what is wrong; what was expected" where the text is no LM-63 file.
bool ParsePhotometricText(
  const std::string& text, const std::string& name, PhotometricTable& table, std::string& error);
}

#endif
