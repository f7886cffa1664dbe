// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The lights of a renderer as the shaders take them.
 */

#ifndef AirlightLamps_h
#define AirlightLamps_h

#include "AirlightConvert.h"

#include <glm/glm.hpp>

#include <vector>

class vtkLight;
class vtkRenderer;

namespace airlight
{
class View;

struct Lamp
{
  vtkLight* Light;
  LightSupport Support;
  f64::AirlightLight Values; // relative to the eye
  glm::dvec4 World{ 0.0 };   // homogeneous position
  bool CastsShadows = false;

  bool Scatters() const { return this->Support == LightSupport::Scatters; }
  bool Glows() const { return this->Scatters() && this->Values.intensity != glm::dvec3(0.0); }
};

// The switched-on lights, in the order in which VTK's mappers number them. `radius` is the light
// radius asked for, 0 for the smallest that single precision resolves.
std::vector<Lamp> CollectLamps(
  vtkRenderer* renderer, const f64::AirlightMedia& media, const View& view, double radius);
}

#endif
