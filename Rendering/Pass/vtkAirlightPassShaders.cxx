// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// What vtkAirlightPass does when VTK's mappers build and use their shaders.

#include "Pass/vtkAirlightPassInternals.h"

#include "MapperShaders/AirlightVolumeShader.h"

#include "vtkProp.h"
#include "vtkShaderProgram.h"
#include "vtkVolume.h"

using namespace airlight;

//------------------------------------------------------------------------------
bool vtkAirlightPass::PreReplaceShaderValues(
  std::string&, std::string&, std::string& fragmentShader, vtkAbstractMapper*, vtkProp* prop)
{
  if (vtkVolume::SafeDownCast(prop))
  {
    MarkVolumeShader(fragmentShader);
  }
  return true;
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::PostReplaceShaderValues(std::string& vertexShader,
  std::string& geometryShader, std::string& fragmentShader, vtkAbstractMapper* mapper,
  vtkProp* prop)
{
  const SurfaceShaderOptions& options = this->Impl->ShaderOptions;
  this->Impl->AddToShader(
    vertexShader, geometryShader, fragmentShader, mapper, prop, [&](std::string& shader) {
      if (vtkVolume::SafeDownCast(prop))
      {
        InjectVolumeShader(shader, options);
      }
      else
      {
        this->Impl->Materials.Specialize(shader, prop);
        this->Impl->ChangeSurfaceShader(shader, AirlightScenePass::IsPointGaussians(prop));
      }
    });
  return true;
}

//------------------------------------------------------------------------------
void vtkAirlightPass::Internals::ChangeSurfaceShader(std::string& shader, bool pointGaussians)
{
  const vtkMTimeType time = this->ShaderTime;
  const bool records = this->ShaderOptions.TranslucentFragments;
  auto& last = this->LastChange;
  if (last.Time != time || last.PointGaussians != pointGaussians || last.Records != records ||
    last.Before != shader)
  {
    last = { shader, shader, pointGaussians, records, time };
    InjectSurfaceShader(last.After, this->ShaderOptions, pointGaussians);
  }
  shader = last.After;
}

//------------------------------------------------------------------------------
bool vtkAirlightPass::SetShaderParameters(
  vtkShaderProgram* program, vtkAbstractMapper* mapper, vtkProp* prop, vtkOpenGLVertexArrayObject*)
{
  SurfaceUniforms values = this->Impl->CurrentFrame.GetSurfaceUniforms(this->Impl->Stage);
  if (auto* volume = vtkVolume::SafeDownCast(prop))
  {
    const bool through = IsVolumeProgram(program);
    this->Impl->NoteVolume(volume, through);
    if (through)
    {
      SetSurfaceUniforms(program, values);
      SetVolumeUniforms(program, volume, values);
    }
    return true;
  }
  if (this->DelegatePass && this->Impl->Stage == SurfaceStage::Colour)
  {
    this->Impl->CurrentFrame.FitToTarget(values);
  }
  // A delegate may draw translucent surfaces with the opaque ones, whose bits are not theirs.
  values.UseLit = values.UseLit &&
    !(this->Impl->Stage == SurfaceStage::Colour && prop->IsRenderingTranslucentPolygonalGeometry());
  values.Hides = program->IsUniformUsed("airlightHidden");
  values.Hidden = values.Hides && this->Impl->IsDrawnLater(prop);
  values.Additive = AirlightScenePass::IsEmissive(prop);
  SetSurfaceUniforms(program, values);
  // VTK leaves the lights of another renderer in a program that both use and that is newer than they.
  program->SetUniformGroupUpdateTime(vtkShaderProgram::LightingGroup, 0);
  if (this->Impl->DrawsMap)
  {
    this->Impl->MapPrograms.insert(program);
  }
  if (this->Impl->Stage == SurfaceStage::Distance)
  {
    this->Impl->DepthPrePass.Observe(this->Impl->CurrentFrame.GetWindow(), mapper);
  }
  return true;
}

//------------------------------------------------------------------------------
vtkMTimeType vtkAirlightPass::GetShaderStageMTime() { return this->Impl->ShaderTime; }
