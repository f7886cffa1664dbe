// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/AirlightMeanPicture.h"

#include "AirlightCopyFS.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkShaderProgram.h"

namespace airlight
{
//------------------------------------------------------------------------------
bool MeanPicture::DrawIntoViewport(vtkOpenGLRenderWindow* window, const Mean& mean,
  const glm::ivec4& viewport, const DisplayStage& display, bool blend)
{
  vtkShaderProgram* program = this->Copy.GetOrCompile(window,
    "#version 330\n" + Define("AIRLIGHT_MASKED", false) + Define("AIRLIGHT_MEAN", true) +
      display.GetSource() + AirlightCopyFS);
  if (!program)
  {
    return false;
  }
  const int corner[2] = { mean.Corner.x, mean.Corner.y };
  program->SetUniform2i("airlightViewport", corner);
  display.SetUniforms(program);
  program->SetUniformi("blended", blend ? 1 : 0);
  this->Copy.DrawIntoViewport(window->GetState(),
    { { "radiances", mean.Radiances }, { "sceneDepth", mean.Depths } }, viewport, blend);
  return true;
}

//------------------------------------------------------------------------------
std::string MeanPicture::GetError()
{
  return std::string("the shader of the frames' mean") + ProgramMaker::GetReason();
}
}
