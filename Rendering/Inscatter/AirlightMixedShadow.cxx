// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Inscatter/AirlightMixedShadow.h"

#include "AirlightMixedBoundaries.h"

namespace airlight
{
namespace
{
// A reader's text, with what it defines named after it.
std::string Rename(const std::string& source, const std::string& name)
{
  const char* const names[] = { "airlightOpenBoundaries", "airlightBeginBoundaries",
    "airlightNextBoundary", "airlightCloseBoundaries", "airlightBoundaryCount",
    "airlightBoundaryWeights" };
  std::string before;
  std::string after;
  for (const std::string word : names)
  {
    before += "#define " + word + " " + word + name + "\n";
    after += "#undef " + word + "\n";
  }
  return before + source + after;
}
}

//------------------------------------------------------------------------------
// Planes that count need no draw that goes on where another has paused.
bool MixedShadow::ForEachDraw(
  const FrameScene& scene, int light, const InscatterTargets& targets, bool, const Draw& draw)
{
  return this->Planes.ForEachDraw(scene, light, targets, this->CountsBoundaries(), draw) ||
    this->Fail(this->Planes.GetError());
}

//------------------------------------------------------------------------------
std::string MixedShadow::GetBoundarySource(const InscatterDraw& draw, bool) const
{
  const bool counted = this->CountsBoundaries();
  return Rename(this->Planes.GetBoundarySource(draw, counted), "OfPlanes") +
    Rename(this->Map.GetBoundarySource(draw, counted), "OfMap") +
    "#define AIRLIGHT_MIXED_COUNTED " + (counted ? "1\n" : "0\n") + AirlightMixedBoundaries;
}

//------------------------------------------------------------------------------
void MixedShadow::Bind(
  vtkShaderProgram* program, const FrameScene& scene, const InscatterDraw& draw)
{
  this->Planes.Bind(program, scene, draw);
  this->Map.Bind(program, scene, draw);
}
}
