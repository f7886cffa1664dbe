// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ImportedFile_h
#define ImportedFile_h

#include "scene/Scene.h"

#include <vtkActor.h>
#include <vtkSmartPointer.h>

#include <optional>
#include <string>
#include <vector>

namespace airlight
{

/**
 * Whether ImportFile() reads this file: gltf, glb, wrl, 3ds, and obj that has its materials beside
 * it.
 */
bool IsImportedFile(const std::string& fileName);

/**
 * What a scene file holds.
 */
struct ImportedScene
{
  std::vector<vtkSmartPointer<vtkActor>> Actors;
  std::vector<LightSource> Lights;      ///< see GetImportedLights()
  std::optional<CameraSettings> Camera; ///< see GetImportedCamera()
};

/**
 * Read a scene file with its colours and textures, lamps and camera. Throws UserError with file and
 * reason if the file is damaged. Guard the first reading of a file with TryInChildProcess().
 *
 * Colours and textures become those of matt surfaces: diffuse, without ambient light, highlights or
 * physically based shading, which are not in the airlight equation. Those of unlit materials
 * (KHR_materials_unlit) are radiances, which need no lamp.
 *
 * Meshes without normals get smooth ones but for sharp edges, see AddSmoothNormals(), unless their
 * facets are to be kept, as the glTF specification has it. VRML's facets are always kept.
 */
ImportedScene ImportFile(const std::string& fileName, bool keepFacets);

}

#endif
