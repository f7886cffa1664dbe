// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ImageFile_h
#define ImageFile_h

#include <vtkImageData.h>
#include <vtkSmartPointer.h>

#include <string>

namespace airlight
{

enum class ImageFormat
{
  Png,  ///< 8 bits per channel, values clamped to 0..1
  Pfm,  ///< linear single precision, bottom row first
  Tiff, ///< linear single precision, top row first, not compressed
  Exr   ///< the same in the format of compositing programs
};

/**
 * The format that a file's name stands for: png, pfm, tif, tiff or exr. Throws UserError for
 * others and if the file's folder does not exist, so that programs can complain before they render.
 */
ImageFormat CheckImageFile(const std::string& fileName);

/**
 * Write a linear float image of one or three components; in PNG without gamma, clamped to 0..1.
 * Throws UserError on failure.
 */
void WriteFloatImage(vtkImageData* image, const std::string& fileName);

/**
 * Write an 8-bit image as PNG. Throws UserError on failure.
 */
void WritePng(vtkImageData* image, const std::string& fileName);

/**
 * Throws UserError unless the file is an 8-bit PNG that can be read. It is read in a child process,
 * which a damaged file may crash. Check all files before the first one is read: see ChildProcess.h.
 */
void CheckPngFile(const std::string& fileName);

/**
 * Read an 8-bit PNG as RGB; grey is spread, alpha dropped. Throws UserError if it is damaged.
 */
vtkSmartPointer<vtkImageData> ReadPng(const std::string& fileName);

}

#endif
