// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Meshes, lines, tables and images by random calls, good ones and bad ones.
 */

#ifndef AirlightFuzzData_h
#define AirlightFuzzData_h

#include "AirlightFuzz.h"

#include "vtkSmartPointer.h"

class vtkDataSet;
class vtkImageData;
class vtkPolyData;
class vtkTable;

namespace airlight_fuzz
{
// Triangles, polygons, strips, lines and vertices over a few points, which often coincide; and,
// every fourth time, a closed box.
vtkSmartPointer<vtkPolyData> MakeMesh(Input& input);

// Lines over a few points.
vtkSmartPointer<vtkPolyData> MakeLines(Input& input);

// A table of two columns, more or less: angles and values.
vtkSmartPointer<vtkTable> MakeTable(Input& input);

// A few points of one component, more or less.
vtkSmartPointer<vtkImageData> MakeImage(Input& input);

// That arrays of single and double precision, of points and of cells, hold finite numbers.
void RequireFinite(vtkDataSet* data, const char* name);
}

#endif
