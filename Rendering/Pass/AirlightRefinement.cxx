// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Pass/AirlightRefinement.h"

#include "vtkRenderState.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

#include <algorithm>

namespace airlight
{
namespace
{
// A scene that changes so many times in a row though nobody touches it will do so again.
constexpr int MostChanges = 3;
}

//------------------------------------------------------------------------------
bool Refinement::MayRefine(const vtkRenderState* s)
{
  vtkRenderWindow* window = s->GetRenderer()->GetRenderWindow();
  const int* tiles = window->GetTileScale();
  return !s->GetFrameBuffer() && !window->GetStereoRender() && tiles[0] == 1 && tiles[1] == 1;
}

//------------------------------------------------------------------------------
Refinement::Frames Refinement::Begin(const Picture& picture)
{
  const bool same = this->Done > 0 && this->Renderer == picture.State->GetRenderer() &&
    this->Viewport == picture.Viewport && this->Count == picture.Count &&
    this->Stamp == SceneStamp(picture.State, picture.Pass, picture.Delegate);
  // Pictures that others ask for, as another pass in the window may, say nothing.
  this->Changes = same ? 0 : this->Changes + (picture.Requested ? 1 : 0);
  const int first = same ? this->Done : 0;
  return { first,
    this->Changes < MostChanges ? std::min(first + 1, picture.Count) : picture.Count };
}

//------------------------------------------------------------------------------
// What the picture itself changed, as the camera that it moved and put back, is no change.
void Refinement::Keep(const Picture& picture, int done)
{
  this->Stamp = SceneStamp(picture.State, picture.Pass, picture.Delegate);
  this->Renderer = picture.State->GetRenderer();
  this->Viewport = picture.Viewport;
  this->Count = picture.Count;
  this->Done = done;
}
}
