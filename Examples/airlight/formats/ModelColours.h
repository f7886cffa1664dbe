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
 * A mesh whose active scalars are one number a point, in the colours of K. Moreland's map from cool
 * to warm, encoded as sRGB; any other as it is.
 */
vtkSmartPointer<vtkPolyData> ColourByScalars(vtkPolyData* mesh);

/**
 * Whether a mesh has colours at its points, red, green and blue of 8 bits. Other arrays are
 * measurements, see ColourByScalars().
 */
bool HasColours(vtkPolyData* mesh);

/**
 * The mesh with these colours decoded, or as it is if it has none.
 */
vtkSmartPointer<vtkPolyData> DecodeColours(vtkPolyData* mesh);

}

#endif
