// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapperShaders/AirlightVolumeShader.h"

#include "AirlightVolume.h"
#include "Integration/AirlightMatrix.h"
#include "Scene/AirlightCameraUniforms.h"
#include "Translucency/AirlightTranslucentFragments.h"

#include "vtkLight.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

#include <algorithm>
#include <numeric>
#include <regex>

namespace airlight
{
namespace
{
const std::string DeclarationMark = "//Airlight::Dec\n";
const std::string StartMark = "//Airlight::Start\n";

void Mark(std::string& shader, const std::string& tag, const std::string& mark, bool after)
{
  const size_t position = shader.find(tag);
  if (position != std::string::npos)
  {
    shader.insert(position + (after ? tag.size() : 0), (after ? "\n" : "") + mark);
  }
}

bool Replace(std::string& shader, const std::string& what, const std::string& with)
{
  const size_t position = shader.find(what);
  if (position == std::string::npos)
  {
    return false;
  }
  shader.replace(position, what.size(), with);
  return true;
}

// VTK's scale of colours acts on the blended sum, whose samples it can as well be applied to.
bool MoveScale(std::string& shader)
{
  static const std::regex line(
    "g_fragColor\\.([rgb]) = g_fragColor\\.\\1 \\* in_scale \\+ in_bias \\* g_fragColor\\.a;");
  const auto count =
    std::distance(std::sregex_iterator(shader.begin(), shader.end(), line), std::sregex_iterator());
  shader = std::regex_replace(shader, line, "");
  return count == 3;
}

// Where VTK blends a sample with those before it.
bool AddMedium(std::string& shader)
{
  static const std::regex blend(
    "g_fragColor = \\(1\\.0f - g_fragColor\\.a\\) \\* (g_srcColor|tmp) \\+ g_fragColor;");
  static const std::regex slice("g_fragColor\\.rgb \\*= opacity;");
  const std::string scale = ".rgb = $1.rgb * in_scale + in_bias * $1.a;\n";
  const std::string whole = shader;
  shader = std::regex_replace(
    shader, blend, "$1" + scale + "$1 = airlightApplyMediumToVolume($1);\n" + "$&");
  shader = std::regex_replace(shader, slice,
    "$&\ng_fragColor.rgb = g_fragColor.rgb * in_scale + in_bias * g_fragColor.a;\n"
    "g_fragColor = airlightApplyMediumToVolume(g_fragColor);");
  return shader != whole;
}

// Every mention of a light's colour in VTK's shading; where there are some, in computeLighting().
// VTK 9.1 numbers lights as the renderer has them, 9.2 and later those with a position first.
void AddLights(std::string& shader)
{
  static const std::regex colour("in_light(Diffuse|Specular)Color\\[(lightNum|0)\\]");
  static const std::regex sorted("in_light(Diffuse|Specular)Color\\[(posNum|dirNum)\\]");
  const std::string whole = shader;
  shader = std::regex_replace(shader, colour, "($& * airlightReceivedLight[$2])");
  shader = std::regex_replace(
    shader, sorted, "($& * airlightReceivedLight[airlightSortedSceneLights[$2]])");
  if (shader != whole)
  {
    Replace(shader, "vec4 finalColor = vec4(0.0);",
      "vec4 finalColor = vec4(0.0);\n  airlightReceiveSample();");
  }
}
}

//------------------------------------------------------------------------------
void MarkVolumeShader(std::string& fragmentShader)
{
  // After what VTK declares first, and at the end of what it does once.
  Mark(fragmentShader, "//VTK::Termination::Dec", DeclarationMark, false);
  Mark(fragmentShader, "//VTK::DepthPass::Init", StartMark, true);
}

//------------------------------------------------------------------------------
void InjectVolumeShader(std::string& fragmentShader, const SurfaceShaderOptions& options)
{
  std::string shader = fragmentShader;
  if (!options.Translucent || !AddMedium(shader) || !MoveScale(shader) ||
    !Replace(shader, StartMark, "airlightStartVolume();\n") ||
    !Replace(shader, DeclarationMark, GetVolumeDeclarations(options, AirlightVolume)))
  {
    return;
  }
  AddLights(shader);
  AddExtensions(shader, options);
  fragmentShader = shader;
}

//------------------------------------------------------------------------------
bool IsVolumeProgram(vtkShaderProgram* program)
{
  return program->IsUniformUsed("airlightVolumeToEye");
}

//------------------------------------------------------------------------------
// Shaders that number lights as the renderer has them do not have these.
void SetSortedSceneLights(vtkShaderProgram* program, const std::vector<SceneLight>& sceneLights)
{
  if (!program->IsUniformUsed("airlightSortedSceneLights"))
  {
    return;
  }
  std::vector<int> sorted(sceneLights.size());
  std::iota(sorted.begin(), sorted.end(), 0);
  std::stable_partition(sorted.begin(), sorted.end(),
    [&sceneLights](int k) { return sceneLights[k].Light->GetPositional() != 0; });
  program->SetUniform1iv(
    "airlightSortedSceneLights", static_cast<int>(sorted.size()), sorted.data());
}

//------------------------------------------------------------------------------
void SetVolumeUniforms(vtkShaderProgram* program, vtkVolume* volume, const SurfaceUniforms& values)
{
  glm::dmat4 shift(1.0);
  shift[3] = glm::dvec4(-values.Rays->GetEye(), 1.0);
  glm::mat4 volumeToEye(shift * ToGlm(volume->GetMatrix()));
  const float size[2] = { static_cast<float>(values.Width), static_cast<float>(values.Height) };
  program->SetUniformMatrix4x4("airlightVolumeToEye", &volumeToEye[0][0]);
  program->SetUniform2f("airlightVolumeSize", size);
  program->SetUniformi("airlightNodeCount", values.VolumeNodes);
  SetSortedSceneLights(program, *values.SceneLights);
}

//------------------------------------------------------------------------------
int GetVolumeNodeCount(size_t volumes, int width, int height, std::uint64_t memoryLimit)
{
  const std::uint64_t each =
    TranslucentFragments::RecordSize * std::max<std::uint64_t>(volumes, 1) * width * height;
  return static_cast<int>(std::clamp<std::uint64_t>(memoryLimit / each, 2, MaximumVolumeNodes));
}
}
