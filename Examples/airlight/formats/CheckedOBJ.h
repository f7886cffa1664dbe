// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CheckedOBJ_h
#define CheckedOBJ_h

#include <string>

namespace airlight
{

/**
 * Throw UserError with file and line if a vertex of a Wavefront file does not have three finite
 * numbers: VTK's readers take those of the vertex before for what is none.
 */
void CheckOBJ(const std::string& fileName);

}

#endif
