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
 * units (candela, lux); a spot of 90 degrees shines all around. A spot's fall from innerConeAngle
 * to outerConeAngle becomes the power of the cosine that sends out as much light, up to 128, with
 * the same intensity on the axis: it begins at the axis and ends in a step at the border, the lower
 * the narrower the inner cone is. `range` is ignored: it is where engines may stop computing, and
 * light that ended there would show as a sphere in fog. VRML has directional lights; 3DS has points
 * and spots, whose power is what arrives at `center`, since the format knows no distance.
 */
std::vector<LightSource> GetImportedLights(vtkImporter* importer, vtkRenderer* renderer,
  const std::string& extension, const Vector3& center);

/**
 * The power of the cosine to the axis by which a spot sends out as much light as one that fades
 * from the inner to the outer angle as KHR_lights_punctual says. Degrees; 0 for equal ones.
 */
double FindSpotExponent(double innerAngle, double outerAngle);

/**
 * GLTFNodes::FindCamera() of a glTF file and the last camera of a 3DS file, if there is one
 * that shows perspective. It looks at the point of its axis that is beside `center`, but not nearer
 * than a tenth of the model's diagonal.
 */
std::optional<CameraSettings> GetImportedCamera(
  vtkImporter* importer, vtkRenderer* renderer, const Vector3& center, double diagonal);

}

#endif
