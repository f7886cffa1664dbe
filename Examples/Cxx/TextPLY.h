// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef TextPLY_h
#define TextPLY_h

#include <string>

namespace airlight
{

/**
 * Throws UserError, which names the line, where a .ply file in text lacks some of the numbers that
 * its header promises or has something else in the place of one. VTK's reader reports only some of
 * that, and since VTK 9.3 nothing. Does nothing for binary files, which the reader does check.
 */
void CheckTextPLY(const std::string& fileName);

}

#endif
