// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * OpenEXR, which compositing programs read: linear single precision, scan lines from the top, not
 * compressed. It is little enough of the format to be written without its library. Source: "OpenEXR
 * File Layout", openexr.com.
 */

#ifndef Exr_h
#define Exr_h

#include <vtkImageData.h>

#include <string>

namespace airlight
{

/**
 * Write a float image of one component (channel Y) or three (R, G, B). Throws UserError on failure.
 */
void WriteExr(vtkImageData* image, const std::string& fileName);

}

#endif
