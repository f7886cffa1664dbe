// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Polygons and strips as triangles.
 */

#ifndef AirlightTriangulate_h
#define AirlightTriangulate_h

#include "vtkSmartPointer.h"

class vtkDataArray;
class vtkPolyData;

namespace airlight
{
// The triangles of the mesh, whatever its cells, without its lines and vertices. The mesh is left
// as it is. `cells`, if given, becomes cell data: a value for each cell of the mesh, handed on to
// its triangles.
vtkSmartPointer<vtkPolyData> Triangulate(vtkPolyData* mesh, vtkDataArray* cells = nullptr);
}

#endif
