// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Inscatter/AirlightLightShadow.h"

#include "AirlightNoBoundaries.h"

namespace airlight
{
//------------------------------------------------------------------------------
bool LightShadow::Fail(const std::string& reason)
{
  this->Error = reason;
  return false;
}

//------------------------------------------------------------------------------
bool LightShadow::Update(const FrameScene&, int, const ShadowCasters&, const InscatterTargets&)
{
  return true;
}

//------------------------------------------------------------------------------
bool LightShadow::ForEachDraw(
  const FrameScene& scene, int, const InscatterTargets&, bool, const Draw& draw)
{
  return draw({ BoundaryPixels::All, 0, scene.Height });
}

//------------------------------------------------------------------------------
std::string LightShadow::GetBoundarySource(const InscatterDraw&, bool) const
{
  return AirlightNoBoundaries;
}

//------------------------------------------------------------------------------
void LightShadow::Bind(vtkShaderProgram*, const FrameScene&, const InscatterDraw&) {}
}
