// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Step 2 of a frame: one light's shadows, from planes or from a map, and its airlight.

#include "Frame/AirlightFrame.h"

#include "OpenGL/AirlightOpenGL.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace airlight
{
//------------------------------------------------------------------------------
// Null where nothing casts shadows in this light.
ShadowMap* Frame::GetMap(int index) const
{
  const bool used = this->SceneLights[index].CastsShadows && this->Maps[index];
  return used && this->Maps[index]->HasCasters() ? this->Maps[index].get() : nullptr;
}

//------------------------------------------------------------------------------
bool Frame::ScatterLight(int index)
{
  const bool shadows = this->SceneLights[index].CastsShadows;
  const ShadowMethod method = this->Plan.Shadows;
  if (shadows && method == ShadowMethod::Planes && this->Volumes[index].HasShadows())
  {
    return this->ScatterWithLists(index);
  }
  const bool map = method == ShadowMethod::March ||
    (shadows && method == ShadowMethod::Map && this->GetMap(index));
  return this->Resolve(index, map ? Lists::Map : Lists::None, 0, this->Height);
}

//------------------------------------------------------------------------------
ShadowLists::Source Frame::GetPlanesSource(int index)
{
  const SceneLight& sceneLight = this->SceneLights[index];
  return { index, this->Volumes[index], sceneLight.World, *this->Rays, this->Textures.Distances,
    FindTruncationPlanes(
      *this->FoundCasters, this->Faces, sceneLight.World, this->Rays->GetEye()) };
}

//------------------------------------------------------------------------------
bool Frame::ScatterWithLists(int index)
{
  const ShadowLists::Source source = this->GetPlanesSource(index);
  for (int row = 0; row < this->Height;)
  {
    if (!this->Textures.Bind({}, this->Textures.Depth))
    {
      return this->Fail(this->Textures.GetError());
    }
    const int rows = this->Boundaries.Fill(source, row, this->Height - row);
    if (rows == 0)
    {
      this->OverBudget = this->Boundaries.IsOverBudget();
      return this->Fail(this->Boundaries.GetError());
    }
    if (!this->Resolve(index, Lists::Short, row, rows) || !this->ResolveLong(index, row, rows))
    {
      return false;
    }
    row += rows;
  }
  return true;
}

//------------------------------------------------------------------------------
// The pixels whose lists are long, the closed form in several draws.
bool Frame::ResolveLong(int index, int row, int rows)
{
  const int draws = this->Boundaries.GetLongDraws();
  if (draws > 0 && !this->Boundaries.Sort())
  {
    return this->Fail(this->Boundaries.GetError());
  }
  const bool equiangular = this->ResolvesEquiangular(index, Lists::Long);
  bool ok = draws == 0 || !equiangular || this->DrawResolve(index, Lists::Long, false, row, rows);
  for (int draw = 0; draw < draws && ok && (!equiangular || this->Plan.TranslucentFragments);
       ++draw)
  {
    ok =
      this->DrawResolve(index, draw == 0 ? Lists::Long : Lists::LongRest, equiangular, row, rows);
  }
  return ok;
}

//------------------------------------------------------------------------------
// The records of translucent fragments take the closed form. What is behind them does not, so that
// it is the same to the last bit with and without them.
bool Frame::Resolve(int index, Lists lists, int row, int rows)
{
  return this->DrawResolve(index, lists, false, row, rows) &&
    (!this->Plan.TranslucentFragments || !this->ResolvesEquiangular(index, lists) ||
      this->DrawResolve(index, lists, true, row, rows));
}

//------------------------------------------------------------------------------
bool Frame::DrawResolve(int index, Lists lists, bool fragmentsOnly, int row, int rows)
{
  const size_t own = lists == Lists::Map
    ? 3
    : std::min<size_t>(static_cast<size_t>(lists), static_cast<size_t>(Lists::Long));
  Quad& quad = this->ResolveQuads[fragmentsOnly ? 4 : own];
  vtkShaderProgram* program =
    quad.GetOrCompile(this->Window, this->GetResolveSource(index, lists, fragmentsOnly));
  if (!program)
  {
    return this->Fail(std::string("the airlight shader") + ProgramMaker::GetReason());
  }
  if (!this->Textures.Bind(this->GetScatterTargets(), nullptr))
  {
    return this->Fail(this->Textures.GetError());
  }
  this->SetResolveUniforms(program, index, lists, fragmentsOnly);

  vtkOpenGLState* state = this->Window->GetState();
  vtkOpenGLState::ScopedglColorMask maskSaver(state);
  if (fragmentsOnly)
  {
    state->vtkglColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  }
  state->vtkglDisable(GL_DEPTH_TEST);
  state->vtkglEnable(GL_BLEND);
  state->vtkglBlendFuncSeparate(GL_ONE, GL_ONE, GL_ONE, GL_ONE);
  state->vtkglEnable(GL_SCISSOR_TEST);
  state->vtkglScissor(0, row, this->Width, rows);
  ShadowMap* map = lists == Lists::Map ? this->GetMap(index) : nullptr;
  quad.Draw(
    { { "distances", this->Textures.Distances }, { "airlightData", this->Data.GetTexture() },
      { "shadowMap", map ? map->GetTexture() : this->Textures.Distances.Get() } });
  state->vtkglScissor(0, 0, this->Width, this->Height);
  return true;
}

}
