// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/AirlightExposureMeter.h"

#include "AirlightLuminanceFS.h"
#include "OpenGL/AirlightOpenGL.h"

#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"
#include "vtkTimerLog.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace airlight
{
namespace
{
constexpr int Blocks = 64; // along each side of the picture
constexpr double MiddleGrey = 0.18;
constexpr double Darkest = 0.4; // the share of the pixels that are too dark to count
constexpr double Brightest = 0.05;
constexpr double Residue = 1e-5; // of the brightest block: shadows may hold roundings of light
constexpr double AdaptationTime = 0.3;        // s
constexpr double InteractiveUpdateRate = 1.0; // Hz, at least
}

//------------------------------------------------------------------------------
bool IsMoving(vtkRenderWindow* window)
{
  return window->GetDesiredUpdateRate() >= InteractiveUpdateRate;
}

//------------------------------------------------------------------------------
double ChooseExposure(std::vector<LuminanceBlock> blocks)
{
  const auto end = std::remove_if(
    blocks.begin(), blocks.end(), [](const LuminanceBlock& block) { return !(block.Count > 0.0); });
  blocks.erase(end, blocks.end());
  if (blocks.empty())
  {
    return 0.0;
  }
  std::sort(blocks.begin(), blocks.end(),
    [](const LuminanceBlock& a, const LuminanceBlock& b) { return a.Logarithm < b.Logarithm; });
  const double least = blocks.back().Logarithm + std::log2(Residue);
  blocks.erase(blocks.begin(),
    std::find_if(blocks.begin(), blocks.end(),
      [least](const LuminanceBlock& block) { return block.Logarithm >= least; }));
  const double total = std::accumulate(blocks.begin(), blocks.end(), 0.0,
    [](double sum, const LuminanceBlock& block) { return sum + block.Count; });
  double sum = 0.0;
  double weight = 0.0;
  double before = 0.0;
  for (const LuminanceBlock& block : blocks)
  {
    // The part of this block between the two limits.
    const double first = std::max(before, Darkest * total);
    const double last = std::min(before + block.Count, (1.0 - Brightest) * total);
    const double share = std::max(last - first, 0.0);
    sum += share * block.Logarithm;
    weight += share;
    before += block.Count;
  }
  return MiddleGrey / std::exp2(sum / weight);
}

//------------------------------------------------------------------------------
bool ExposureMeter::IsPart(vtkRenderer* renderer) const
{
  vtkRenderWindow* window = renderer->GetRenderWindow();
  const int* tiles = window->GetTileScale();
  vtkCamera* camera = renderer->GetActiveCamera();
  const bool tile = tiles[0] * tiles[1] > 1;
  const bool right =
    camera->GetStereo() && !camera->GetLeftEye() && window->GetStereoType() != VTK_STEREO_RIGHT;
  return this->Measured == renderer && (tile || right);
}

//------------------------------------------------------------------------------
bool ExposureMeter::Measure(
  vtkRenderer* renderer, vtkTextureObject* radiances, const glm::ivec4& picture)
{
  if (this->IsPart(renderer))
  {
    return true;
  }
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
  if (this->Measured != renderer)
  {
    this->Measured = renderer;
    this->Exposure = 1.0;
    this->Time = 0.0;
  }
  vtkShaderProgram* program =
    this->LuminanceQuad.GetOrCompile(window, std::string("#version 330\n") + AirlightLuminanceFS);
  if (!program)
  {
    this->Error = std::string("the shader that measures luminance") + ProgramMaker::GetReason();
    return false;
  }
  if (!this->Textures.Prepare(window, Blocks, Blocks, {}) ||
    !this->Textures.Bind({ this->Textures.Scattered }, nullptr))
  {
    this->Error = this->Textures.GetError();
    return false;
  }
  vtkOpenGLState* state = window->GetState();
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  program->SetUniform2i("corner", &picture.x);
  program->SetUniform2i("size", &picture.z);
  const int block[2] = { (picture.z + Blocks - 1) / Blocks, (picture.w + Blocks - 1) / Blocks };
  program->SetUniform2i("blockSize", block);
  this->LuminanceQuad.Draw({ { "radiances", radiances } });
  const vtkSmartPointer<vtkImageData> image = this->Textures.Read(0, 0, 2);
  const auto* values = static_cast<const float*>(image->GetScalarPointer());
  std::vector<LuminanceBlock> blocks(static_cast<size_t>(Blocks) * Blocks);
  for (size_t i = 0; i < blocks.size(); ++i)
  {
    blocks[i] = { values[2 * i], values[2 * i + 1] };
  }
  this->Follow(window, ChooseExposure(blocks));
  return true;
}

//------------------------------------------------------------------------------
void ExposureMeter::Follow(vtkOpenGLRenderWindow* window, double measured)
{
  const double now = vtkTimerLog::GetUniversalTime();
  const double passed = std::max(now - this->Time, 0.0);
  this->Time = now;
  if (!(measured > 0.0))
  {
    return;
  }
  const double share = IsMoving(window) ? 1.0 - std::exp(-passed / AdaptationTime) : 1.0;
  this->Exposure *= std::pow(measured / this->Exposure, share);
}

//------------------------------------------------------------------------------
void ExposureMeter::Release(vtkWindow* window)
{
  this->LuminanceQuad.Release();
  this->Textures.Release(window);
}
}
