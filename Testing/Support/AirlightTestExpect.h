// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Single checks that show their numbers when they fail.
 */

#ifndef AirlightTestExpect_h
#define AirlightTestExpect_h

#include "AirlightTestCheck.h"

#include <sstream>
#include <string>

namespace airlight_test
{
template <typename... Numbers>
void Expect(bool ok, const std::string& what, const Numbers&... numbers)
{
  std::ostringstream text;
  text << what;
  ((text << ", " << numbers), ...);
  Check(ok, text.str());
}
}

#endif
