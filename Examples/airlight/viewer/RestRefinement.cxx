// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "viewer/RestRefinement.h"

namespace airlight
{

//------------------------------------------------------------------------------
RestRefinement::RestRefinement(vtkAirlightPass* pass, int frames)
  : Pass(pass)
  , Wanted(pass ? frames : 1)
{
}

//------------------------------------------------------------------------------
void RestRefinement::Start()
{
  if (this->Pass)
  {
    this->Frames = this->Wanted;
    this->Pass->SetSubpixelFrames(this->Frames);
    this->Pass->ProgressiveRefinementOn();
  }
}

//------------------------------------------------------------------------------
// Views of counts have one frame whatever was set.
void RestRefinement::Finish(RenderedScene& rendered)
{
  for (int i = 0;
       i < this->Frames && this->Pass && this->Pass->GetAccumulatedFrames() < this->Frames; ++i)
  {
    rendered.Render();
  }
}

//------------------------------------------------------------------------------
std::string RestRefinement::GetText() const
{
  const int frames = this->Pass ? this->Pass->GetAccumulatedFrames() : 1;
  return this->Frames == 1 || frames == 1
    ? ""
    : ", mean of " + std::to_string(frames) + " of " + std::to_string(this->Frames);
}

}
