// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef GLTFNodes_h
#define GLTFNodes_h

#include "scene/Scene.h"

#include <vtkGLTFImporter.h>

#include <optional>

class vtkLight;

namespace airlight
{

/**
 * Reads a glTF file and knows what VTK's importer does not tell of its nodes: which cameras stand
 * in the scene (VTK gives those that no node holds a place at the origin), and how spots fade. Of
 * a material's textures it takes that of the colour alone.
 */
class GLTFNodes : public vtkGLTFImporter
{
public:
  static GLTFNodes* New();
  vtkTypeMacro(GLTFNodes, vtkGLTFImporter);

  /**
   * The first perspective camera that a node of the file's scene holds, from parents to children.
   * Its focal point is at any distance. Call it after Read().
   */
  std::optional<CameraSettings> FindCamera() const;

  /**
   * The inner angle of the cone of a spot that Read() has made, degrees, from which to the outer
   * one its intensity falls to 0. Without one 0, the default of KHR_lights_punctual. `before`: how
   * many lights in the same place Read() has made before it.
   */
  double GetInnerConeAngle(vtkLight* light, int before) const;

protected:
  /**
   * VTK writes into the image of metal and roughness, and refuses textures of a measure whose image
   * is that of a colour, too.
   */
  void ImportActors(vtkRenderer* renderer) override;
};

/**
 * Whether both are there and equal.
 */
bool IsSame(vtkMatrix4x4* a, vtkMatrix4x4* b);

}

#endif
