// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef LambertActor_h
#define LambertActor_h

#include "formats/Vector3.h"

#include <vtkActor.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

namespace airlight
{

enum class Shading
{
  Flat,   ///< the normals of polygons
  Smooth, ///< the mesh's own normals, or those of points but for sharp edges
  Curved  ///< the same, and coarse meshes are curved accordingly, see MakeCurved()
};

/**
 * A mesh as an opaque, two-sided, perfectly matt surface of the given albedo: it sends the radiance
 * albedo/pi times its irradiance in all directions, with normals turned to the viewer. No ambient
 * light, no highlight.
 */
vtkSmartPointer<vtkActor> MakeLambertActor(
  vtkPolyData* mesh, const Vector3& albedo, Shading shading);

}

#endif
