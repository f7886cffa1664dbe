// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FogAnimation_h
#define FogAnimation_h

#include "scene/Scene.h"
#include "scene/SceneBuilder.h"

#include <vtkTransform.h>

namespace airlight
{

/**
 * Moves lamp, object and medium of a scene at once: the first lamp goes round a level circle, the
 * object turns about its own vertical axis, the medium's density rises and falls and its colour
 * drifts. Each state is a function of the frame's number alone. Frame 0 is the scene as it was
 * read, and after `period` frames everything is back there.
 */
class FogAnimation
{
public:
  /**
   * Animate scene.Surfaces[surface] and scene.Lights[0], which must exist.
   */
  FogAnimation(const Scene& scene, const RenderedScene& rendered, std::size_t surface, int period);

  void SetFrame(int frame);

private:
  void MoveLight(double phase);
  void TurnObject(double phase);
  void ChangeMedium(double phase);

  Scene Start;
  RenderedScene Rendered;
  int Period;
  vtkSmartPointer<vtkActor> Object;
  vtkSmartPointer<vtkTransform> Turn;
  Vector3 ObjectCenter;
  Vector3 Up;         // unit length
  Vector3 CircleSide; // both as long as the lamp's circle is wide from its centre
  Vector3 CircleBack;
  Vector3 Scattering;
  Vector3 Absorption;
};

}

#endif
