// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef PlacedCameras_h
#define PlacedCameras_h

#include "scene/Scene.h"

#include <vtkGLTFImporter.h>

#include <optional>

namespace airlight
{

/**
 * Reads a glTF file and knows which of its cameras stand in the scene: VTK's importer gives those
 * that no node holds a place at the origin.
 */
class PlacedCameras : public vtkGLTFImporter
{
public:
  static PlacedCameras* New();
  vtkTypeMacro(PlacedCameras, vtkGLTFImporter);

  /**
   * The first perspective camera that a node of the file's scene holds, from parents to children.
   * Its focal point is at any distance. Call it after Read().
   */
  std::optional<CameraSettings> FindCamera() const;
};

}

#endif
