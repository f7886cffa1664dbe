// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef CurvedMesh_h
#define CurvedMesh_h

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace airlight
{

/**
 * A coarse mesh with normals of points as the curved surface that the normals tell of. Shadows come
 * from the mesh, shading from the normals; on coarse meshes the border of the shadow on the side
 * away from a lamp shows the triangles otherwise.
 *
 * Each triangle is cut into up to 16, whose points are moved towards the tangent planes of the
 * corners (T. Boubekeur and M. Alexa, "Phong Tessellation", SIGGRAPH Asia 2008). Points of the mesh
 * stay where they are. Corners at sharp edges, where a point has a normal for each side, and those
 * whose normal is more than 30 degrees off a triangle's own move nothing.
 *
 * Meshes without normals, with strips, and of more than 6000 triangles are returned as they are.
 */
vtkSmartPointer<vtkPolyData> MakeCurved(vtkPolyData* mesh);

}

#endif
