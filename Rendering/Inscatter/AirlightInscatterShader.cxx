// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Inscatter/AirlightInscatterShader.h"

#include "AirlightBoundaryReader.h"
#include "AirlightCameraShader.h"
#include "AirlightEquiangularFS.h"
#include "AirlightEquiangularPixel.h"
#include "AirlightEquiangularRay.h"
#include "AirlightGoniometricSteps.h"
#include "AirlightHeightFogSteps.h"
#include "AirlightLightPixel.h"
#include "AirlightResolveFS.h"
#include "AirlightResolveOutputs.h"
#include "AirlightResolveTranslucent.h"
#include "AirlightShadowCounts.h"
#include "AirlightSteppedRay.h"
#include "AirlightTransmittanceBuffer.h"
#include "AirlightUnshadowedFS.h"
#include "Density/AirlightDensityGrid.h"
#include "Inscatter/AirlightLightShadows.h"
#include "Integration/AirlightIntegrate.h"
#include "MapperShaders/AirlightSurfaceShader.h"
#include "Medium/AirlightConvert.h"
#include "OpenGL/AirlightOpenGL.h"
#include "OpenGL/AirlightShaderLibrary.h"
#include "Scene/AirlightEquiangularLights.h"
#include "Scene/AirlightUnshadowedLights.h"
#include "Translucency/AirlightTranslucentFragments.h"

#include "vtkShaderProgram.h"

#include <algorithm>
#include <cmath>

namespace airlight
{
namespace
{
const char* GivenUniforms = "uniform AirlightLight light;\n";

static_assert(MaximumShadowingLights <= translucent_record::LightBits, "a bit for each light");

// What a lit surface adds in the channels of bits.
glm::vec4 GetLitBit(int light)
{
  glm::vec4 bit(0.0f);
  if (light < MaximumShadowingLights)
  {
    bit[light / BitsPerChannel] = std::ldexp(1.0f, light % BitsPerChannel);
  }
  return bit;
}

bool IsQuadrature(const f64::AirlightLight& light)
{
  return light.kind == AIRLIGHT_POINT_QUADRATURE || light.kind == AIRLIGHT_DIRECTIONAL_QUADRATURE;
}

// A box that holds the image has shrunk to the image's own bounds, and cuts nothing. A region that
// is outside of its image has left no extinction.
bool IsCutImage(const f64::AirlightMedium& medium)
{
  return medium.density == AIRLIGHT_DENSITY_GRID && medium.sigmaT != glm::dvec3(0.0) &&
    (medium.region.kind != AIRLIGHT_REGION_BOX ||
      medium.region.boxMin != medium.grid->GetLeast() - medium.gridOrigin ||
      medium.region.boxMax != medium.grid->GetGreatest() - medium.gridOrigin);
}
}

//------------------------------------------------------------------------------
InscatterShader::InscatterShader(const FrameScene& scene, const InscatterOptions& options,
  const LightShadows& shadows, LightShadow& shadow, int light)
  : Scene(scene)
  , Options(options)
  , Shadows(shadows)
  , Shadow(shadow)
  , Light(light)
  , Equiangular(airlight::IsEquiangular(scene, light) && !shadows.TransmitsLight() &&
      shadow.CountsBoundaries())
{
}

//------------------------------------------------------------------------------
std::string InscatterShader::GetRaySource(
  const FrameScene& scene, int kind, bool photometry, bool cones)
{
  return "#define AIRLIGHT_MORE_LIT " + std::to_string(scene.Lights.size() > BitsPerChannel) +
    "\n#define AIRLIGHT_FULL_SCREEN\n#define AIRLIGHT_FRAGMENT_IS_PIXEL\n"
    "#define AIRLIGHT_PARALLEL " +
    std::to_string(scene.Rays.IsParallel()) + "\n" + (cones ? "" : "#define AIRLIGHT_NO_CONE\n") +
    GetScatteringSource(scene.Media, kind, photometry) + AirlightCameraShader + AirlightLightPixel;
}

//------------------------------------------------------------------------------
// The beginning of all sources.
std::string InscatterShader::GetHead(bool storage, int kind, bool ownMedia) const
{
  const f64::AirlightLight& light = this->Scene.Lights[this->Light].Values;
  // Pixels that a mask leaves out are not to be shaded, though shaders write to storage.
  return GetShaderVersion(storage) + (storage ? "layout(early_fragment_tests) in;\n" : "") +
    BoundaryBuffer::DefineNodes(this->Shadows.TransmitsLight()) +
    (this->Options.Record ? "#define AIRLIGHT_RECORD\n" : "") +
    (ownMedia ? "#define AIRLIGHT_OWN_MEDIA\n" : "") +
    Define("AIRLIGHT_MULTIPLE_LAMP", FindMultipleLamp(this->Scene.Media, light)) +
    GetRaySource(this->Scene, kind, light.goniometric != 0, light.cosCone > 0.0);
}

//------------------------------------------------------------------------------
std::string InscatterShader::GetEquiangularRaySource() const
{
  if (IsHeightFog(this->Scene))
  {
    return std::string(AirlightHeightFogSteps) + AirlightSteppedRay;
  }
  return this->Scene.Lights[this->Light].Values.goniometric != 0
    ? std::string(AirlightGoniometricSteps) + AirlightSteppedRay
    : AirlightEquiangularRay;
}

//------------------------------------------------------------------------------
std::string InscatterShader::GetEquiangularSource(const InscatterDraw& draw) const
{
  // AirlightConstants.glsl sets a part of the light.
  return this->GetHead(this->Shadow.UsesStorage(), AIRLIGHT_POINT_CLOSED, true) +
    "uniform AirlightLight givenLight;\nAirlightLight light;\n" +
    airlight::GetEquiangularSource(this->Scene) + AirlightShadowCounts + AirlightBoundaryReader +
    this->Shadow.GetBoundarySource(draw, true) + AirlightEquiangularPixel +
    this->GetEquiangularRaySource() + AirlightResolveOutputs + AirlightEquiangularFS;
}

//------------------------------------------------------------------------------
std::string InscatterShader::GetSource(const InscatterDraw& draw, RayPart part) const
{
  if (this->Equiangular && part == RayPart::Surface)
  {
    return this->GetEquiangularSource(draw);
  }
  const bool records = part != RayPart::Surface;
  const bool transmits = this->Shadows.TransmitsLight();
  return this->GetHead(this->Shadow.UsesStorage() || records || transmits,
           this->Scene.Lights[this->Light].Values.kind, false) +
    (records ? "#define AIRLIGHT_TRANSLUCENT_FRAGMENTS\n" : "") + GivenUniforms +
    (transmits ? AirlightTransmittanceBuffer : "") + AirlightShadowCounts + AirlightBoundaryReader +
    this->Shadow.GetBoundarySource(draw, false) +
    (records ? TranslucentFragments::GetSource() + AirlightResolveTranslucent : "") +
    AirlightResolveOutputs + AirlightResolveFS;
}

//------------------------------------------------------------------------------
// Of a light's airlight, relative to that without shadows.
double InscatterShader::GetIntegralError() const
{
  const SceneLight& light = this->Scene.Lights[this->Light];
  const f64::AirlightMedia& media = this->Scene.Media;
  const bool cut =
    media.volumes > 0 || std::any_of(media.item, media.item + media.count, IsCutImage);
  // Where a photometric table is dim, rounding counts more: it is as of a lamp that is even.
  const bool quadrature = IsQuadrature(light.Values) &&
    (!this->Equiangular || light.Values.goniometric != 0 || IsHeightFog(this->Scene));
  const double integral = cut ? CutImageError : (quadrature ? QuadratureError : ClosedFormError);
  return light.GridError + integral +
    (this->Shadows.TransmitsLight() ? this->Shadow.GetThicknessError() : 0.0);
}

//------------------------------------------------------------------------------
void InscatterShader::SetLight(vtkShaderProgram* program, bool equiangular) const
{
  const f64::AirlightLight& light = this->Scene.Lights[this->Light].Values;
  SetMediaUniforms(program, equiangular ? "givenMedia" : "airlightMedia", this->Scene.Media,
    FindMultipleLamp(this->Scene.Media, light) >= 0);
  SetLightUniforms(program, equiangular ? "givenLight" : "light", light);
  if (equiangular)
  {
    SetEquiangularConstants(program, this->Scene, { this->Light });
  }
  SetLightPixelUniforms(program, "lightPixel", this->Scene.Rays, light);
}

//------------------------------------------------------------------------------
void InscatterShader::SetUniforms(
  vtkShaderProgram* program, const InscatterDraw& draw, RayPart part) const
{
  const bool equiangular = this->Equiangular && part == RayPart::Surface;
  this->Scene.Rays.SetUniforms(program, 0, 0);
  this->SetLight(program, equiangular);
  this->Shadows.SetStartUniforms(program, this->Shadow, this->Light);
  const glm::vec4 bit = GetLitBit(this->Light);
  program->SetUniform4f("litBit", &bit.x);
  if (this->Options.Record)
  {
    program->SetUniformf("phaseError", static_cast<float>(this->Options.PhaseErrorBound));
    program->SetUniformf("error", static_cast<float>(this->GetIntegralError()));
    program->SetUniformf("multipleError", static_cast<float>(this->Options.MultipleErrorBound));
  }
  if (part != RayPart::Surface)
  {
    this->Options.Records->Use(program);
    program->SetUniformi("lightBit", this->Light < MaximumShadowingLights ? this->Light : -1);
    // No test fails without it, see AirlightOpenGL.h.
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT);
  }
  this->Shadow.Bind(program, this->Scene, draw);
}

//------------------------------------------------------------------------------
std::string InscatterShader::GetUnshadowedSource(
  const FrameScene& scene, const std::vector<int>& lights)
{
  const bool cones = std::any_of(
    lights.begin(), lights.end(), [&](int k) { return scene.Lights[k].Values.cosCone > 0.0; });
  return GetShaderVersion(false) + "#define AIRLIGHT_EQUIANGULAR 1\n#define AIRLIGHT_OWN_MEDIA\n" +
    GetRaySource(scene, AIRLIGHT_POINT_CLOSED, false, cones) +
    airlight::GetEquiangularSource(scene) + airlight::GetUnshadowedSource(scene, lights) +
    AirlightResolveOutputs + AirlightUnshadowedFS;
}

//------------------------------------------------------------------------------
void InscatterShader::SetUnshadowedUniforms(
  vtkShaderProgram* program, const FrameScene& scene, const std::vector<int>& lights)
{
  scene.Rays.SetUniforms(program, 0, 0);
  SetMediaUniforms(program, "givenMedia", scene.Media);
  SetEquiangularConstants(program, scene, lights);
  airlight::SetUnshadowedUniforms(program, scene, lights);
  glm::vec4 bits(0.0f);
  for (int light : lights)
  {
    bits += GetLitBit(light);
  }
  program->SetUniform4f("litBit", &bits.x);
}
}
