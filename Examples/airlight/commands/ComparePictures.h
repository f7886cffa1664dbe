// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What `airlight compare` draws.
 */

#ifndef ComparePictures_h
#define ComparePictures_h

#include <vtkImageData.h>

#include <array>
#include <string>

namespace airlight
{

/**
 * Write a float image of differences; into a PNG with grey for 0, and black and white for the
 * largest of all values. Throws UserError on failure.
 */
void WriteDifference(vtkImageData* difference, const std::string& fileName);

/**
 * Plot both images' channels along a row as PNG, the first in full lines, the second dashed. Throws
 * UserError if there is no such row.
 */
void WriteProfile(const std::array<vtkImageData*, 2>& images,
  const std::array<std::string, 2>& names, int row, const std::string& fileName);

}

#endif
