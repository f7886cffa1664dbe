// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapperShaders/AirlightVolumeShader.h"

#include "AirlightVolume.h"
#include "Integration/AirlightMatrix.h"
#include "MapperShaders/AirlightMapperShader.h"
#include "MapperShaders/AirlightSurfaceDeclarations.h"
#include "Scene/AirlightCameraUniforms.h"
#include "Translucency/AirlightTranslucentFragments.h"

#include "vtkLight.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

#include <algorithm>
#include <numeric>

namespace airlight
{
namespace
{
const std::string DeclarationMark = "//Airlight::Dec\n";
const std::string StartMark = "//Airlight::Start\n";

// VTK scales and shifts the colours of the blended sum; the samples can have it as well.
bool MoveScale(std::string& shader)
{
  const bool complete = CountText(shader, MapperText::VolumeScale) == 3;
  ReplaceText(shader, MapperText::VolumeScale, "");
  return complete;
}

// Where VTK blends a sample with those before it.
bool AddMediumToSamples(std::string& shader)
{
  const bool blends = ReplaceText(shader, MapperText::VolumeBlending,
    "$1.rgb = $1.rgb * in_scale + in_bias * $1.a;\n$1 = airlightApplyMediumToVolume($1);\n$&");
  const bool slices = ReplaceText(shader, MapperText::VolumeSlice,
    "$&\ng_fragColor.rgb = g_fragColor.rgb * in_scale + in_bias * g_fragColor.a;\n"
    "g_fragColor = airlightApplyMediumToVolume(g_fragColor);");
  return blends || slices;
}

// Every mention of a light's colour in VTK's shading; where there are some, in computeLighting().
// Whether there are.
bool AddLights(std::string& shader)
{
  const bool headlight =
    ReplaceText(shader, MapperText::VolumeHeadlightColour, "($& * airlightReceivedLight[0])");
  const bool numbered =
    ReplaceText(shader, MapperText::VolumeLightColour, "($& * airlightReceivedLight[lightNum])");
  const bool sorted = ReplaceText(shader, MapperText::VolumeSortedLightColour,
    "($& * airlightReceivedLight[airlightSortedSceneLights[$2]])");
  const bool lights = headlight || numbered || sorted;
  if (lights)
  {
    InsertAfter(shader, MapperText::VolumeLighting, "\n  airlightReceiveSample();");
  }
  return lights;
}
}

//------------------------------------------------------------------------------
void MarkVolumeShader(std::string& fragmentShader)
{
  // After what VTK declares first, and at the end of what it does once.
  InsertBefore(fragmentShader, MapperText::VolumeDeclarations, DeclarationMark);
  InsertAfter(fragmentShader, MapperText::VolumeStart, "\n" + StartMark);
}

//------------------------------------------------------------------------------
void InjectVolumeShader(std::string& fragmentShader, const SurfaceShaderOptions& options)
{
  std::string shader = fragmentShader;
  const std::string shaded =
    "#define AIRLIGHT_SHADED_VOLUME " + std::to_string(AddLights(shader) ? 1 : 0) + "\n";
  if (!options.Translucent || !AddMediumToSamples(shader) || !MoveScale(shader) ||
    !ReplaceFirst(shader, StartMark, "airlightStartVolume();\n") ||
    !ReplaceFirst(shader, DeclarationMark, GetVolumeDeclarations(options, shaded + AirlightVolume)))
  {
    return;
  }
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
// A volume shades its samples as VTK does, without its own shadow: its region is made empty, so
// that no sample's way goes through its cells.
void LeaveOutOwnShadow(
  vtkShaderProgram* program, const vtkVolume* volume, const SurfaceUniforms& values)
{
  const float none[3] = { 0.0f, 0.0f, 0.0f };
  for (int i = 0; i < values.Media->volumes; ++i)
  {
    if ((*values.CastingVolumes)[i] == volume)
    {
      const std::string item = "airlightMedia.item[" + std::to_string(values.Media->count + i);
      program->SetUniform3f((item + "].sigmaT").c_str(), none);
      program->SetUniform3f((item + "].region.boxMin").c_str(), none);
      program->SetUniform3f((item + "].region.boxMax").c_str(), none);
    }
  }
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
  LeaveOutOwnShadow(program, volume, values);
}

//------------------------------------------------------------------------------
int GetVolumeNodeCount(size_t volumes, int width, int height, std::uint64_t memoryLimit)
{
  if (volumes == 0)
  {
    return MinimumVolumeNodes;
  }
  const std::uint64_t each = TranslucentFragments::RecordSize * volumes * width * height;
  return static_cast<int>(
    std::clamp<std::uint64_t>(memoryLimit / each, MinimumVolumeNodes, MaximumVolumeNodes));
}
}
