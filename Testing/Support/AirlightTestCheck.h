// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Single checks, counted for the test's exit status.
 */

#ifndef AirlightTestCheck_h
#define AirlightTestCheck_h

#include <iostream>
#include <string>

namespace airlight_test
{
inline int Failures = 0;

inline bool Check(bool ok, const std::string& what)
{
  if (!ok)
  {
    std::cerr << "FAILED: " << what << "\n";
    ++Failures;
  }
  return ok;
}
}

#endif
