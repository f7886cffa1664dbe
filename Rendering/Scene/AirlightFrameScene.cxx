// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Scene/AirlightFrameScene.h"

namespace airlight
{
//------------------------------------------------------------------------------
std::vector<int> FindScattering(const std::vector<SceneLight>& lights)
{
  std::vector<int> found;
  for (size_t k = 0; k < lights.size(); ++k)
  {
    if (lights[k].HasPower())
    {
      found.push_back(static_cast<int>(k));
    }
  }
  return found;
}
}
