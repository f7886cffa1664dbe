// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CheckedPLY_h
#define CheckedPLY_h

#include <string>

namespace airlight
{

/**
 * Throws UserError where a .ply file lacks some of the numbers that its header promises, or where
 * one in text has something else in the place of a number. VTK's reader reports only some of that,
 * and since VTK 9.3 next to nothing. Does nothing for headers that it does not understand, which
 * the reader reports.
 */
void CheckPLY(const std::string& fileName);

}

#endif
