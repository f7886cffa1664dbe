// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SmoothNormals_h
#define SmoothNormals_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace airlight
{

constexpr double SmoothAngle = 40.0; ///< degrees between faces: sharper edges stay sharp

/**
 * The mesh with normals of points. Points at one place are one, also where texture coordinates and
 * colours have a seam: those stay as they are. Points at sharp edges are there once for each side.
 *
 * Strips become triangles. Meshes with normals, and with strips that have values of their own, are
 * returned as they are.
 */
vtkSmartPointer<vtkPolyData> AddSmoothNormals(vtkPolyData* mesh);

}

#endif
