// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * VTK's matrices, stored by rows, as GLM's, stored by columns.
 */

#ifndef AirlightMatrix_h
#define AirlightMatrix_h

#include "vtkMatrix4x4.h"

#include <glm/glm.hpp>

namespace airlight
{
// The identity for null.
inline glm::dmat4 ToGlm(vtkMatrix4x4* matrix)
{
  glm::dmat4 result(1.0);
  for (int row = 0; matrix && row < 4; ++row)
  {
    for (int column = 0; column < 4; ++column)
    {
      result[column][row] = matrix->GetElement(row, column);
    }
  }
  return result;
}
}

#endif
