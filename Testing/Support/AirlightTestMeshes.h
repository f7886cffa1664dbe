// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Meshes of few triangles, and the triangles of meshes for AirlightTestBruteForce.h.
 */

#ifndef AirlightTestMeshes_h
#define AirlightTestMeshes_h

#include "AirlightTestBruteForce.h"

#include "vtkMatrix4x4.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"

#include <vector>

namespace airlight_test
{
// A copy of what the source makes, changed by nobody else.
vtkSmartPointer<vtkPolyData> Make(vtkPolyDataAlgorithm* source);

vtkSmartPointer<vtkPolyData> MakeSphere(double radius);

// Triangles that share nothing: each has its own three points.
vtkSmartPointer<vtkPolyData> MakeSoup(const std::vector<Triangle>& triangles);

vtkSmartPointer<vtkPolyData> MakeSphere(const glm::dvec3& centre, double radius);

// A horizontal rectangle around a point.
vtkSmartPointer<vtkPolyData> MakePlate(const glm::dvec3& centre, double dx, double dz);

// A rectangle from a corner along two edges.
vtkSmartPointer<vtkPolyData> MakeSheet(
  const glm::dvec3& corner, const glm::dvec3& along, const glm::dvec3& up);

glm::dvec3 TransformPoint(vtkMatrix4x4* matrix, const double p[3]);

// The triangles of convex polygons and of strips, in world coordinates.
std::vector<Triangle> GetTriangles(vtkPolyData* data, vtkMatrix4x4* matrix);
}

#endif
