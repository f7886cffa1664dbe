// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightWiderRange.h"

#include "vtkCamera.h"

#include <algorithm>

namespace airlight
{
//------------------------------------------------------------------------------
WiderRange::WiderRange(vtkCamera* camera, const glm::dvec2& range)
  : Camera(camera)
{
  this->Camera->GetClippingRange(this->Range);
  if (range.x < range.y)
  {
    const double last = std::max(this->Range[1], range.y);
    const double least = camera->GetParallelProjection() ? range.x : 1e-3 * last;
    const double first = std::min(this->Range[0], std::max(range.x, least));
    this->Camera->SetClippingRange(first, last);
  }
}

//------------------------------------------------------------------------------
WiderRange::~WiderRange() { this->Camera->SetClippingRange(this->Range); }
}
