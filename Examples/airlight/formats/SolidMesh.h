// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SolidMesh_h
#define SolidMesh_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace airlight
{

/**
 * Lines and points as surfaces, which are shaded and cast shadows as all others: tubes of 3/1000 of
 * the diagonal of the box around all points, and beads somewhat larger than the points are apart if
 * they lie on a surface. Beads keep the points' own normals, so that a scan is shaded as its
 * surface; colours and other scalars of points stay.
 *
 * Meshes with polygons or strips are returned as they are. Without any cell, points are points.
 */
vtkSmartPointer<vtkPolyData> MakeSolid(vtkPolyData* mesh);

}

#endif
