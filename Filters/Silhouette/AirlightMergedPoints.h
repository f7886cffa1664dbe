// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Points that are at the very same position.
 */

#ifndef AirlightMergedPoints_h
#define AirlightMergedPoints_h

#include "vtkType.h"

#include <glm/glm.hpp>

#include <vector>

class vtkPoints;

namespace airlight
{
struct MergedPoints
{
  std::vector<glm::dvec3> Positions;
  // For each point the first one at the same position; -1 for points that are not finite.
  std::vector<vtkIdType> First;
};

MergedPoints MergeByPosition(vtkPoints* points);
}

#endif
