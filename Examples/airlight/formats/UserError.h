// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef UserError_h
#define UserError_h

#include <stdexcept>
#include <string>
#include <vector>

namespace airlight
{

/**
 * Something that the user can put right: a bad file, a bad option. The text says what, where and,
 * if it helps, what would be accepted. Programs print it and exit with code 1.
 */
class UserError : public std::runtime_error
{
public:
  using std::runtime_error::runtime_error;
};

/**
 * The names that would be accepted: a, b, c.
 */
inline std::string ListNames(const std::vector<std::string>& names)
{
  std::string list;
  for (const std::string& name : names)
  {
    list += (list.empty() ? "" : ", ") + name;
  }
  return list;
}

}

#endif
