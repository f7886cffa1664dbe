// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lamps and cameras as VTK's importers leave them: each importer has its own idea of where a light
 * is and where it goes.
 */

#ifndef ImportedLights_h
#define ImportedLights_h

#include "scene/Scene.h"

#include <optional>
#include <string>
#include <vector>

class vtkImporter;
class vtkRenderer;

namespace airlight
{

/**
 * The lamps that a file's importer has put into a renderer. glTF has KHR_lights_punctual in its
 * units (candela, lux), without range and with hard borders: innerConeAngle is not read, and a spot
 * of 90 degrees shines all around; VRML has directional lights; 3DS has
 * points and spots, whose power is what arrives at `center`, since the format knows no distance.
 */
std::vector<LightSource> GetImportedLights(
  vtkRenderer* renderer, const std::string& extension, const Vector3& center);

/**
 * PlacedCameras::FindCamera() of a glTF file and the last camera of a 3DS file, if there is one
 * that shows perspective. It looks at the point of its axis that is beside `center`, but not nearer
 * than a tenth of the model's diagonal.
 */
std::optional<CameraSettings> GetImportedCamera(
  vtkImporter* importer, vtkRenderer* renderer, const Vector3& center, double diagonal);

}

#endif
