// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ImportedFile_h
#define ImportedFile_h

#include <vtkActor.h>
#include <vtkSmartPointer.h>

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
 * The actors of a scene file, with their colours and textures; cameras and lamps of the file are
 * left out. Throws UserError with file and reason if the file is damaged. Guard the first reading
 * of a file with TryInChildProcess().
 *
 * Colours and textures become those of matt surfaces: diffuse, without ambient light, highlights or
 * physically based shading, which are not in the airlight equation.
 */
std::vector<vtkSmartPointer<vtkActor>> ImportFile(const std::string& fileName);

}

#endif
