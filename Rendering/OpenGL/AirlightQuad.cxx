// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/AirlightQuad.h"

#include "AirlightAmbient.h"
#include "AirlightClosedSurface.h"
#include "AirlightExponentialIntegral.h"
#include "AirlightFullScreenVS.h"
#include "AirlightGauss.h"
#include "AirlightGoniometric.h"
#include "AirlightGoniometricRay.h"
#include "AirlightGrid.h"
#include "AirlightGridRay.h"
#include "AirlightHeightFog.h"
#include "AirlightIrradianceRay.h"
#include "AirlightKinks.h"
#include "AirlightLight.h"
#include "AirlightMedia.h"
#include "AirlightMedium.h"
#include "AirlightPath.h"
#include "AirlightPhase.h"
#include "AirlightPieces.h"
#include "AirlightPointLight.h"
#include "AirlightPrelude.h"
#include "AirlightQuadrature.h"
#include "AirlightRegion.h"
#include "AirlightScatteredIrradiance.h"
#include "AirlightScattering.h"
#include "Integration/AirlightIntegrate.h"
#include "Integration/AirlightMath.h"
#include "OpenGL/AirlightOpenGL.h"
#include "Region/AirlightRegionKinds.h"

#include "vtkOpenGLRenderWindow.h"
#include "vtkOpenGLShaderCache.h"
#include "vtkShaderProgram.h"
#include "vtkTextureObject.h"

#include <algorithm>

namespace airlight
{
namespace
{
std::string Define(const std::string& name, int value)
{
  return "#define " + name + " " + std::to_string(value) + "\n";
}

void SetRegionUniforms(
  vtkShaderProgram* program, const std::string& name, const f64::AirlightRegion& region)
{
  program->SetUniformi((name + ".kind").c_str(), region.kind);
  for (const RegionVector& vector : RegionVectors)
  {
    program->SetUniform3f((name + "." + vector.Name).c_str(), &(region.*vector.Field).x);
  }
  for (const RegionNumber& number : RegionNumbers)
  {
    program->SetUniformf(
      (name + "." + number.Name).c_str(), static_cast<float>(region.*number.Field));
  }
  program->SetUniformi((name + ".first").c_str(), region.first);
  program->SetUniformi((name + ".nodes").c_str(), region.nodes);
}

void SetGridUniforms(
  vtkShaderProgram* program, const std::string& name, const f64::AirlightMedium& medium)
{
  glm::mat3 axes(medium.grid->GetAxes());
  program->SetUniformMatrix3x3((name + ".axes").c_str(), &axes[0].x);
  program->SetUniform3f(
    (name + ".start").c_str(), &glm::vec3(medium.grid->ToSamples(medium.gridOrigin))[0]);
  program->SetUniform3f((name + ".last").c_str(), &glm::vec3(medium.grid->GetLast())[0]);
  program->SetUniformi((name + ".first").c_str(), medium.gridFirst);
}

void SetMediumUniforms(
  vtkShaderProgram* program, const std::string& name, const f64::AirlightMedium& medium)
{
  program->SetUniform3f((name + ".sigmaS").c_str(), &medium.sigmaS.x);
  program->SetUniform3f((name + ".sigmaT").c_str(), &medium.sigmaT.x);
  program->SetUniform3f((name + ".ambient").c_str(), &medium.ambient.x);
  program->SetUniformi((name + ".density").c_str(), medium.density);
  program->SetUniform3f((name + ".up").c_str(), &medium.up.x);
  program->SetUniformf(
    (name + ".inverseScaleHeight").c_str(), static_cast<float>(medium.inverseScaleHeight));
  program->SetUniformf((name + ".originHeight").c_str(), static_cast<float>(medium.originHeight));
  SetRegionUniforms(program, name + ".region", medium.region);
  if (medium.density == AIRLIGHT_DENSITY_GRID)
  {
    SetGridUniforms(program, name + ".grid", medium);
  }
  glm::vec4 poles[AIRLIGHT_MAX_POLES];
  for (int k = 0; k < medium.phase.poleCount; ++k)
  {
    poles[k] = glm::vec4(medium.phase.pole[k]);
  }
  program->SetUniform4fv((name + ".phase.pole").c_str(), medium.phase.poleCount, &poles[0].x);
  program->SetUniformi((name + ".phase.poleCount").c_str(), medium.phase.poleCount);
  program->SetUniformi((name + ".phase.order").c_str(), medium.phase.order);
  program->SetUniformi((name + ".phase.first").c_str(), medium.phase.first);
  program->SetUniformi((name + ".phase.rows").c_str(), medium.phase.rows);
  program->SetUniform2f((name + ".phase.power").c_str(), &glm::vec2(medium.phase.power)[0]);
}
}

//------------------------------------------------------------------------------
// What all media have in common, said when shaders are compiled.
std::string DefineCommon(const f64::AirlightMedia& media)
{
  const auto* first = media.item;
  const auto* end = media.item + media.count;
  const bool sameRegion = std::all_of(
    first, end, [first](const auto& medium) { return medium.region.kind == first->region.kind; });
  const bool sameDensity = std::all_of(
    first, end, [first](const auto& medium) { return medium.density == first->density; });
  const bool power =
    std::any_of(first, end, [](const auto& medium) { return medium.phase.power.x > 0.0; });
  const bool grey =
    std::all_of(first, end, [](const auto& medium) { return f64::airlightIsGrey(medium); });
  const bool isotropic = std::all_of(first, end, [](const auto& medium) {
    const f64::AirlightPhase& phase = medium.phase;
    return phase.rows == 0 && phase.power.x <= 0.0 && phase.poleCount == 1 && phase.order == 1 &&
      phase.pole[0].x == 1.0;
  });
  int kinds = 0; // bit i: a region is of kind i
  for (const auto* medium = first; medium != end; ++medium)
  {
    kinds |= 1 << medium->region.kind;
  }
  return (sameRegion ? Define("AIRLIGHT_REGION_KIND(region)", first->region.kind) : "") +
    Define("AIRLIGHT_REGION_KINDS", kinds) +
    (sameDensity ? Define("AIRLIGHT_DENSITY_KIND(medium)", first->density) : "") +
    Define("AIRLIGHT_HAS_POWER", power) + Define("AIRLIGHT_GREY", grey) +
    (isotropic ? Define("AIRLIGHT_ISOTROPIC", 1) : "");
}

//------------------------------------------------------------------------------
std::string GetScatteringSource(const f64::AirlightMedia& media, int lightKind, bool photometry)
{
  const auto* end = media.item + media.count;
  const bool surface = std::any_of(media.item, end,
    [](const auto& medium) { return medium.region.kind == AIRLIGHT_REGION_SURFACE; });
  const bool table =
    std::any_of(media.item, end, [](const auto& medium) { return medium.phase.rows > 0; });
  const bool grid = HasGrid(media);
  return Define("AIRLIGHT_HAS_SURFACE", surface) + Define("AIRLIGHT_HAS_GRID", grid) +
    Define("AIRLIGHT_HAS_TABLE", table) + Define("AIRLIGHT_HAS_PHOTOMETRY", photometry) +
    Define("AIRLIGHT_HAS_DATA", surface || table || photometry || grid) + AirlightPrelude +
    Define("AIRLIGHT_MAX_POLES", AIRLIGHT_MAX_POLES) + Define("AIRLIGHT_MAX_MEDIA", media.count) +
    Define("AIRLIGHT_MEDIUM_COUNT", media.count) +
    (media.count == 1 ? Define("AIRLIGHT_POLE_COUNT", media.item[0].phase.poleCount) +
          Define("AIRLIGHT_POLE_ORDER", media.item[0].phase.order)
                      : "") +
    DefineCommon(media) + (lightKind >= 0 ? Define("AIRLIGHT_LIGHT_KIND", lightKind) : "") +
    AirlightExponentialIntegral + AirlightGauss + AirlightGoniometric + AirlightPhase +
    AirlightPointLight + AirlightRegion + (grid ? AirlightGrid : "") + AirlightMedium +
    AirlightClosedSurface + AirlightPath + AirlightHeightFog + AirlightMedia + AirlightAmbient +
    AirlightLight + AirlightKinks + AirlightQuadrature + AirlightGoniometricRay + AirlightPieces +
    (grid ? AirlightGridRay : "") + AirlightScattering;
}

//------------------------------------------------------------------------------
std::string GetScatteredIrradianceSource()
{
  return std::string(AirlightIrradianceRay) + AirlightScatteredIrradiance;
}

//------------------------------------------------------------------------------
void SetMediaUniforms(
  vtkShaderProgram* program, const std::string& name, const f64::AirlightMedia& media)
{
  for (int i = 0; i < media.count; ++i)
  {
    SetMediumUniforms(program, name + ".item[" + std::to_string(i) + "]", media.item[i]);
  }
}

//------------------------------------------------------------------------------
void SetPhotometryUniforms(
  vtkShaderProgram* program, const std::string& name, const f64::AirlightPhotometry& photometry)
{
  program->SetUniformi((name + ".first").c_str(), photometry.first);
  program->SetUniform3f((name + ".axis").c_str(), &photometry.axis.x);
  program->SetUniform3f((name + ".up").c_str(), &photometry.up.x);
}

//------------------------------------------------------------------------------
void SetLightUniforms(
  vtkShaderProgram* program, const std::string& name, const f64::AirlightLight& light)
{
  program->SetUniformi((name + ".kind").c_str(), light.kind);
  program->SetUniform3f((name + ".position").c_str(), &light.position.x);
  program->SetUniform3f((name + ".intensity").c_str(), &light.intensity.x);
  program->SetUniform3f((name + ".attenuation").c_str(), &light.attenuation.x);
  program->SetUniformf((name + ".radius").c_str(), static_cast<float>(light.radius));
  program->SetUniform3f((name + ".axis").c_str(), &light.axis.x);
  program->SetUniformf((name + ".cosCone").c_str(), static_cast<float>(light.cosCone));
  program->SetUniformf((name + ".exponent").c_str(), static_cast<float>(light.exponent));
  program->SetUniformi((name + ".goniometric").c_str(), light.goniometric);
  SetPhotometryUniforms(program, name + ".photometry", light.photometry);
  program->SetUniformi((name + ".gridFirst").c_str(), light.gridFirst);
  program->SetUniform3f((name + ".gridSize").c_str(), &light.gridSize.x);
}

//------------------------------------------------------------------------------
vtkShaderProgram* Quad::GetOrCompile(
  vtkOpenGLRenderWindow* window, const std::string& fragmentSource)
{
  if (this->Program && this->Source == fragmentSource)
  {
    this->Program = window->GetShaderCache()->ReadyShaderProgram(this->Program);
  }
  else
  {
    this->Source = fragmentSource;
    std::string text = fragmentSource;
    this->Program = this->Programs.GetOrCompile(window, AirlightFullScreenVS, text);
  }
  return this->Program;
}

//------------------------------------------------------------------------------
void Quad::Draw(const std::vector<std::pair<const char*, vtkTextureObject*>>& textures)
{
  for (const auto& texture : textures)
  {
    if (!texture.second)
    {
      continue;
    }
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
    if (texture.second)
    {
      texture.second->Deactivate();
    }
  }
}

//------------------------------------------------------------------------------
void Quad::Release()
{
  DeleteVertexArray(this->VertexArray);
  this->Program = nullptr;
}
}
