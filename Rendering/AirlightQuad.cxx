// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightQuad.h"

#include "AirlightExponentialIntegral.h"
#include "AirlightFullScreenVS.h"
#include "AirlightGauss.h"
#include "AirlightMath.h"
#include "AirlightMedium.h"
#include "AirlightOpenGL.h"
#include "AirlightPhase.h"
#include "AirlightPointLight.h"
#include "AirlightPrelude.h"
#include "AirlightRegion.h"
#include "AirlightScattering.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

namespace airlight
{
//------------------------------------------------------------------------------
std::string GetScatteringSource(int poleCount)
{
  return std::string(AirlightPrelude) + "#define AIRLIGHT_MAX_POLES " +
    std::to_string(AIRLIGHT_MAX_POLES) + "\n#define AIRLIGHT_POLE_COUNT " +
    std::to_string(poleCount) + "\n" + AirlightExponentialIntegral + AirlightGauss + AirlightPhase +
    AirlightPointLight + AirlightRegion + AirlightMedium + AirlightScattering;
}

//------------------------------------------------------------------------------
void SetMediumUniforms(vtkShaderProgram* program, const f64::AirlightMedium& medium)
{
  program->SetUniform3f("medium.sigmaS", &medium.sigmaS.x);
  program->SetUniform3f("medium.sigmaT", &medium.sigmaT.x);
  program->SetUniform3f("medium.ambient", &medium.ambient.x);
  program->SetUniformi("medium.region.kind", medium.region.kind);
  program->SetUniform3f("medium.region.boxMin", &medium.region.boxMin.x);
  program->SetUniform3f("medium.region.boxMax", &medium.region.boxMax.x);
  glm::vec2 poles[AIRLIGHT_MAX_POLES];
  for (int k = 0; k < medium.phase.poleCount; ++k)
  {
    poles[k] = glm::vec2(medium.phase.pole[k]);
  }
  program->SetUniform2fv("medium.phase.pole", medium.phase.poleCount, &poles[0].x);
}

//------------------------------------------------------------------------------
void SetLightUniforms(vtkShaderProgram* program, const f64::AirlightLight& light)
{
  program->SetUniformi("light.kind", light.kind);
  program->SetUniform3f("light.position", &light.position.x);
  program->SetUniform3f("light.intensity", &light.intensity.x);
  program->SetUniform3f("light.attenuation", &light.attenuation.x);
  program->SetUniformf("light.radius", static_cast<float>(light.radius));
}

//------------------------------------------------------------------------------
vtkShaderProgram* Quad::Ready(vtkOpenGLRenderWindow* window, const std::string& fragmentSource)
{
  vtkOpenGLShaderCache* cache = window->GetShaderCache();
  if (!this->Program || this->Source != fragmentSource)
  {
    this->Source = fragmentSource;
    this->Program = cache->ReadyShaderProgram(AirlightFullScreenVS, this->Source.c_str(), "");
  }
  else
  {
    cache->ReadyShaderProgram(this->Program);
  }
  if (!this->Program || !this->Program->GetCompiled())
  {
    this->Error =
      this->Program ? this->Program->GetError() : "the shader cache returned no program";
    this->Program = nullptr;
  }
  return this->Program;
}

//------------------------------------------------------------------------------
void Quad::Draw(const std::vector<std::pair<const char*, vtkTextureObject*>>& textures)
{
  for (const auto& texture : textures)
  {
    texture.second->Activate();
    this->Program->SetUniformi(texture.first, texture.second->GetTextureUnit());
  }
  if (this->VertexArray == 0)
  {
    glGenVertexArrays(1, &this->VertexArray);
  }
  glBindVertexArray(this->VertexArray);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindVertexArray(0);
  for (const auto& texture : textures)
  {
    texture.second->Deactivate();
  }
}

//------------------------------------------------------------------------------
void Quad::Release()
{
  if (this->VertexArray != 0)
  {
    glDeleteVertexArrays(1, &this->VertexArray);
    this->VertexArray = 0;
  }
  this->Program = nullptr;
}
}
