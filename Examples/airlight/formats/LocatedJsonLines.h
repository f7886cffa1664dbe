// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LocatedJsonLines_h
#define LocatedJsonLines_h

#include <map>
#include <string>

namespace airlight
{

/**
 * Parse JSON and return the line of every key and every array item, by JSON pointer ("" is the
 * outermost value). Throws UserError with file and line for malformed text, for a key that is given
 * twice in one object and for numbers beyond double precision.
 */
std::map<std::string, int> FindJsonLines(const std::string& text, const std::string& fileName);

}

#endif
