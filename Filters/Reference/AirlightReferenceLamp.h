// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A lamp with an extent as many small lamps: quadrature over its points.
 */

#ifndef AirlightReferenceLamp_h
#define AirlightReferenceLamp_h

#include "vtkSmartPointer.h"

#include <glm/glm.hpp>

#include <vector>

class vtkLight;

namespace airlight
{
// The light itself if it is a point or fixed to the camera, or for one point, its middle; else so
// many copies, each with its part of the intensity. Their places come from Fibonacci's lattices,
// unlike those of the pass.
std::vector<vtkSmartPointer<vtkLight>> SplitLamp(vtkLight* light, int count);

// The unit vector across an axis that is next to `up`.
glm::dvec3 GetUpAcross(const glm::dvec3& axis, const glm::dvec3& up);
}

#endif
