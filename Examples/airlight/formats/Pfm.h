// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * PFM, the portable float map: linear single precision pixels, bottom row first like vtkImageData.
 * "PF" holds three channels, "Pf" one.
 */

#ifndef Pfm_h
#define Pfm_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace airlight
{

/**
 * Read a PFM file of either byte order as a float image. Throws UserError if it is missing,
 * malformed or ends early.
 */
vtkSmartPointer<vtkImageData> ReadPfm(const std::string& fileName);

/**
 * Write a float image of one or three components, little endian. Throws UserError on failure.
 */
void WritePfm(vtkImageData* image, const std::string& fileName);

}

#endif
