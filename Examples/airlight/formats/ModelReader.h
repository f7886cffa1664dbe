// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ModelReader_h
#define ModelReader_h

#include "scene/Scene.h"

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

namespace airlight
{

/**
 * Throws UserError, naming file and reason, unless the file is a model that can be read: gltf, glb,
 * obj, ply, stl, vtp, vtk, vtu, wrl or 3ds. It is read in a child process, which a damaged file may
 * crash. Check all files before the first one is read: afterwards VTK may have started threads.
 *
 * Returns why the materials of an obj file are to be left out, as VTK's reader fails on them or
 * misses some; mostly nothing.
 */
std::string CheckModelFile(const std::string& fileName);

/**
 * The surfaces of a model, matt, in the model's own colours where it has any, and lamps and a
 * camera if the file has them.
 */
struct Model
{
  std::vector<Surface> Surfaces;
  std::vector<LightSource> Lights;
  std::optional<CameraSettings> Camera;
};

/**
 * Coarse meshes without materials are curved as their normals say, see MakeCurved(), or keep their
 * facets; for others see ImportFile(). Without `materials` those of an obj file are left out.
 * Throws UserError.
 */
Model ReadModel(const std::string& fileName, bool keepFacets = false, bool materials = true);

/**
 * All polygons of a model as one mesh in world coordinates. Throws UserError.
 */
vtkSmartPointer<vtkPolyData> ReadMesh(const std::string& fileName);

}

#endif
