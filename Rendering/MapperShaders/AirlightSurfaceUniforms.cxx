// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MapperShaders/AirlightSurfaceUniforms.h"

#include "Medium/AirlightConvert.h"
#include "OpenGL/AirlightOpenGL.h"
#include "OpenGL/AirlightShaderLibrary.h"
#include "Scene/AirlightCameraUniforms.h"
#include "Translucency/AirlightFroxelNodes.h"
#include "Translucency/AirlightShadowTransmittance.h"
#include "Translucency/AirlightTranslucentFragments.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLState.h"
#include "vtkRenderer.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace airlight
{
namespace
{
void SetScatteringLights(vtkShaderProgram* program, const SurfaceUniforms& values)
{
  int count = 0;
  for (const SceneLight& sceneLight : *values.SceneLights)
  {
    const bool several = IsMultiple(*values.Media, sceneLight.Values);
    if (sceneLight.HasPower() && !several && count < MaximumScatteringLights)
    {
      SetLightUniforms(
        program, "airlightScatteringLights[" + std::to_string(count) + "]", sceneLight.Values);
      ++count;
    }
  }
  program->SetUniformi("airlightScatteringLightCount", count);
}
}

//------------------------------------------------------------------------------
// Shaders without photometry do not have these uniforms.
void SetPhotometries(vtkShaderProgram* program, const std::vector<SceneLight>& sceneLights)
{
  if (!program->IsUniformUsed("airlightGoniometric"))
  {
    return;
  }
  std::vector<int> goniometric;
  for (size_t k = 0; k < sceneLights.size(); ++k)
  {
    goniometric.push_back(sceneLights[k].Values.goniometric);
    if (sceneLights[k].Values.goniometric != 0)
    {
      SetPhotometryUniforms(program, "airlightPhotometries[" + std::to_string(k) + "]",
        sceneLights[k].Values.photometry);
    }
  }
  program->SetUniform1iv(
    "airlightGoniometric", static_cast<int>(goniometric.size()), goniometric.data());
}

//------------------------------------------------------------------------------
std::vector<vtkTextureObject*> SurfaceUniforms::GetTextures() const
{
  std::vector<vtkTextureObject*> textures;
  for (vtkTextureObject* texture :
    { this->Lit, this->MoreLit != this->Lit ? this->MoreLit : nullptr, this->LightWays, this->Data,
      this->Samples, this->Froxels ? this->Froxels->GetTexture() : nullptr })
  {
    if (texture)
    {
      textures.push_back(texture);
    }
  }
  return textures;
}

//------------------------------------------------------------------------------
void SetSurfaceUniforms(vtkShaderProgram* program, const SurfaceUniforms& values)
{
  if (values.Lit)
  {
    program->SetUniformi("airlightStage", static_cast<int>(values.Stage));
    // A sampler left at unit 0 would clash with the mapper's own.
    program->SetUniformi("airlightLit", values.Lit->GetTextureUnit());
    program->SetUniformi("airlightMoreLit", values.MoreLit->GetTextureUnit());
    program->SetUniformi(
      "airlightLightWays", (values.LightWays ? values.LightWays : values.Lit)->GetTextureUnit());
    program->SetUniformi("airlightUseLit", values.UseLit ? 1 : 0);
  }
  values.Rays->SetUniforms(program, values.ViewportX, values.ViewportY, values.Pixels);
  if (values.Data)
  {
    program->SetUniformi("airlightData", values.Data->GetTextureUnit());
  }
  if (values.Samples)
  {
    program->SetUniformi("airlightSamples", values.Samples->GetTextureUnit());
  }
  if (values.Records)
  {
    values.Records->Use(program);
  }
  if (values.Froxels)
  {
    values.Froxels->UseTexture(program);
  }
  if (values.Hides)
  {
    program->SetUniformi("airlightHidden", values.Hidden ? 1 : 0);
  }
  if (values.Stage == SurfaceStage::Distance || values.Stage == SurfaceStage::Collect)
  {
    return;
  }
  SetMediaUniforms(program, "airlightMedia", *values.Media);
  std::vector<glm::vec4> sceneLights;
  for (const SceneLight& sceneLight : *values.SceneLights)
  {
    const float kind = !sceneLight.Scatters()         ? -1.0f
      : f64::airlightIsDirectional(sceneLight.Values) ? 0.0f
                                                      : 1.0f;
    sceneLights.emplace_back(glm::vec3(sceneLight.Values.position), kind);
  }
  if (!sceneLights.empty())
  {
    program->SetUniform4fv(
      "airlightSceneLights", static_cast<int>(sceneLights.size()), &sceneLights[0].x);
  }
  program->SetUniformi("airlightSceneLightCount", static_cast<int>(sceneLights.size()));
  SetPhotometries(program, *values.SceneLights);
  if (!values.LightLayers.empty())
  {
    program->SetUniformi("airlightLayerRows", values.Height);
    program->SetUniform1iv("airlightLightLayers", static_cast<int>(values.LightLayers.size()),
      values.LightLayers.data());
  }
  if (values.Transmittances)
  {
    values.Transmittances->UseInMapper(program);
  }
  if (values.ScatteredIrradiance || values.Media->multiple.count > 0)
  {
    glm::mat3 normals = values.Rays->GetNormalMatrix();
    program->SetUniformMatrix3x3("airlightNormalToWorld", &normals[0].x);
  }
  if (values.ScatteredIrradiance)
  {
    SetScatteringLights(program, values);
  }
  program->SetUniformi("airlightAdditive", values.Additive ? 1 : 0);
  const bool lights = values.Stage == SurfaceStage::Translucent && !values.Records;
  for (size_t k = 0; k < values.SceneLights->size() && lights; ++k)
  {
    SetLightUniforms(
      program, "airlightLights[" + std::to_string(k) + "]", (*values.SceneLights)[k].Values);
  }
}

//------------------------------------------------------------------------------
void FitToTarget(SurfaceUniforms& values, vtkRenderer* renderer)
{
  for (vtkTextureObject* texture : values.GetTextures())
  {
    texture->Activate();
  }
  const CameraUniforms& rays = *values.Rays;
  int viewport[4];
  vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow())
    ->GetState()
    ->vtkglGetIntegerv(GL_VIEWPORT, viewport);
  if (viewport[0] == 0 && viewport[1] == 0 && viewport[2] == rays.GetWidth() &&
    viewport[3] == rays.GetHeight())
  {
    return;
  }
  const CameraUniforms target(renderer, viewport[2], viewport[3]);
  if (target.IsValid())
  {
    values.ViewportX = viewport[0];
    values.ViewportY = viewport[1];
    values.Pixels = rays.GetPixelsFrom(target);
  }
}
}
