// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Bodies that several tests put into a scene, opaque and translucent, for the picture and
 * for brute force.
 */

#ifndef AirlightTestBodies_h
#define AirlightTestBodies_h

#include "AirlightTestScene.h"

#include "vtkInformationDoubleVectorKey.h"

#include <functional>

namespace airlight_test
{
// A floor of a single rectangle.
void AddFloor(Scene& scene);

// A ball and an open cone above a floor.
void AddOpenBodies(Scene& scene);

// The same, closed.
void AddClosedBodies(Scene& scene);

void SetShadowOpacity(vtkProp* prop, const glm::dvec3& opacity);

// An actor that VTK blends at half its opacity, with a shadow of these opacities.
vtkActor* AddGlass(Scene& scene, vtkPolyData* data, const glm::dvec3& opacity,
  const std::function<void(vtkActor*)>& place = {});

void AddFloorAndBall(Scene& scene);

// The same window with floor, ball and nothing else: shaders are compiled once.
void ResetToFloorAndBall(Scene& scene);
}

#endif
