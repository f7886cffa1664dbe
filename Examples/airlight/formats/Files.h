// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Files_h
#define Files_h

#include <string>

namespace airlight
{

/**
 * The bytes of a file. Throws UserError if it is missing, a folder, empty or unreadable.
 */
std::string ReadTextFile(const std::string& fileName);

/**
 * The part of ReadTextFile() that needs no reading: throws UserError if the file is missing, a
 * folder, empty or cannot be opened.
 */
void CheckInputFile(const std::string& fileName);

/**
 * Throws UserError if a file of this name could not be created because its folder is missing.
 */
void CheckOutputFile(const std::string& fileName);

/**
 * The part of the name behind its last dot, in lower case.
 */
std::string GetExtension(const std::string& fileName);

}

#endif
