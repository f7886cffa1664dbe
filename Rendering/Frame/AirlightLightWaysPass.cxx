// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Frame/AirlightLightWaysPass.h"

#include "AirlightCameraShader.h"
#include "AirlightLightWaysFS.h"
#include "Medium/AirlightConvert.h"
#include "OpenGL/AirlightOpenGL.h"
#include "OpenGL/AirlightShaderLibrary.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace airlight
{
namespace
{
// The numbers of the first lights that the media dim, whether or not those scatter them.
std::vector<int> FindDimmed(const std::vector<SceneLight>& lights, int count)
{
  std::vector<int> dimmed;
  for (int k = 0; k < static_cast<int>(lights.size()); ++k)
  {
    if (lights[k].Scatters() && static_cast<int>(dimmed.size()) < count)
    {
      dimmed.push_back(k);
    }
  }
  return dimmed;
}

// As the shader takes them: w is 0 for the sun's direction.
std::vector<glm::vec4> GetLights(const FrameScene& scene, int count)
{
  std::vector<glm::vec4> lights;
  for (const int k : FindDimmed(scene.Lights, count))
  {
    const f64::AirlightLight& light = scene.Lights[k].Values;
    lights.emplace_back(glm::vec3(light.position), f64::airlightIsDirectional(light) ? 0.0f : 1.0f);
  }
  return lights;
}
}

//------------------------------------------------------------------------------
std::vector<int> LightWaysPass::GetLayers(const FrameScene& scene, int count)
{
  std::vector<int> layers(scene.Lights.size(), -1);
  int layer = 0;
  for (const int k : FindDimmed(scene.Lights, count))
  {
    layers[k] = layer++;
  }
  return layers;
}

//------------------------------------------------------------------------------
bool LightWaysPass::Draw(const FrameScene& scene, int layers, Targets& targets)
{
  const std::vector<glm::vec4> lights = GetLights(scene, layers);
  const auto isSun = [](const glm::vec4& light) { return light.w == 0.0f; };
  const std::string source = GetShaderVersion(false) + Define("AIRLIGHT_LAYERS", layers) +
    Define("AIRLIGHT_HAS_SUNS", std::any_of(lights.begin(), lights.end(), isSun)) +
    Define("AIRLIGHT_HAS_LAMPS", !std::all_of(lights.begin(), lights.end(), isSun)) +
    Define("AIRLIGHT_PARALLEL", scene.Rays.IsParallel()) + "#define AIRLIGHT_FULL_SCREEN\n" +
    GetScatteringSource(scene.Media, AIRLIGHT_POINT_CLOSED, false) + AirlightCameraShader +
    AirlightLightWaysFS;
  vtkShaderProgram* program = this->Ways.GetOrCompile(scene.Window, source);
  if (!program)
  {
    this->Error = std::string("the shader of the lights' ways") + ProgramMaker::GetReason();
    return false;
  }
  if (!targets.Bind({ targets.LightWays }, nullptr))
  {
    this->Error = targets.GetError();
    return false;
  }
  SetMediaUniforms(program, "airlightMedia", scene.Media, false);
  scene.Rays.SetUniforms(program, 0, 0);
  program->SetUniform4fv("lights", static_cast<int>(lights.size()), &lights[0].x);
  vtkOpenGLState* state = scene.Window->GetState();
  state->vtkglColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  state->vtkglDisable(GL_BLEND);
  state->vtkglDisable(GL_DEPTH_TEST);
  this->Ways.Draw({ { "distances", targets.Distances }, { "airlightData", scene.Data },
    { "airlightSamples", scene.Samples } });
  return true;
}
}
