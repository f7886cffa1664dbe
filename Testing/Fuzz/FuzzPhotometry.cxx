// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The text of a photometric file: a table of finite numbers, or one error with file and line.

#include "AirlightFuzz.h"

#include "Photometry/AirlightPhotometry.h"

using namespace airlight_fuzz;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  const std::string text(reinterpret_cast<const char*>(data), size);
  std::string error;
  const auto photometry = airlight::Photometry::Parse(text, "lamp.ies", error);
  Require(static_cast<bool>(photometry) == error.empty(), "either a table or an error");
  if (!photometry)
  {
    Require(error.rfind("lamp.ies:", 0) == 0 && error.find('\n') == std::string::npos,
      "the error is one line with the file's name: " + error);
    return 0;
  }
  const double maximum = photometry->GetMaximum();
  RequirePositive(&maximum, 1, "the maximum");
  const std::vector<glm::dvec4> texels = photometry->Pack();
  for (const glm::dvec4& texel : texels)
  {
    RequireFinite(&texel.x, 4, "a texel");
  }
  // Values come behind the head and the intervals.
  const size_t intervals = static_cast<size_t>(texels[0].x + texels[0].y);
  const size_t end = 1 + intervals + static_cast<size_t>(texels[0].x * texels[0].y);
  Require(texels.size() > end, "the number of texels");
  for (size_t i = 1 + intervals; i < end; ++i)
  {
    RequirePositive(&texels[i].x, 4, "an intensity");
    Require(texels[i].x <= 1.0, "the largest intensity is 1");
  }
  return 0;
}
