// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PhotometryFile_h
#define PhotometryFile_h

#include <string>

namespace airlight
{

/**
 * Throws UserError, naming file, line and culprit, unless this is a photometric file (IES LM-63)
 * that a vtkAirlightPass takes.
 */
void CheckPhotometryFile(const std::string& fileName);

}

#endif
