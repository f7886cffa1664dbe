// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ModelColours_h
#define ModelColours_h

#include "formats/Vector3.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace airlight
{

/**
 * Models are coloured on screens, in sRGB; light is computed with reflectances.
 */
Vector3 DecodeSRGB(const double colour[3]);

/**
 * Whether a mesh has colours at its points, red, green and blue of 8 bits. Other arrays are
 * measurements, which say nothing about reflection.
 */
bool HasColours(vtkPolyData* mesh);

/**
 * The mesh with these colours decoded, or as it is if it has none.
 */
vtkSmartPointer<vtkPolyData> DecodeColours(vtkPolyData* mesh);

}

#endif
