// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "OpenGL/AirlightShaderLibrary.h"

#include "AirlightAmbient.h"
#include "AirlightBeside.h"
#include "AirlightClosedSurface.h"
#include "AirlightDiffuseLight.h"
#include "AirlightDirectionalLight.h"
#include "AirlightEquiangular.h"
#include "AirlightEquiangularPanel.h"
#include "AirlightExponentialIntegral.h"
#include "AirlightGauss.h"
#include "AirlightGoniometric.h"
#include "AirlightGoniometricRay.h"
#include "AirlightGrid.h"
#include "AirlightGridRay.h"
#include "AirlightGridSteps.h"
#include "AirlightGridWay.h"
#include "AirlightHeightFog.h"
#include "AirlightIrradianceRay.h"
#include "AirlightKinks.h"
#include "AirlightLayeredScattering.h"
#include "AirlightLight.h"
#include "AirlightMedia.h"
#include "AirlightMedium.h"
#include "AirlightMultipleScattering.h"
#include "AirlightPath.h"
#include "AirlightPhase.h"
#include "AirlightPieces.h"
#include "AirlightPointLight.h"
#include "AirlightPrelude.h"
#include "AirlightQuadrature.h"
#include "AirlightRegion.h"
#include "AirlightScatteredIrradiance.h"
#include "AirlightScattering.h"
#include "AirlightSky.h"
#include "AirlightSourceFunction.h"
#include "Integration/AirlightIntegrate.h"
#include "Medium/AirlightConvert.h"
#include "OpenGL/AirlightProgram.h"

#include "vtkShaderProgram.h"

#include <algorithm>
#include <cstddef>

namespace airlight
{
namespace
{
// What all media have in common, said when shaders are compiled.
std::string DefineCommon(const f64::AirlightMedia& media)
{
  const auto* first = media.item;
  const auto* end = media.item + media.count;
  const auto* last = end + media.volumes;
  const bool sameRegion = std::all_of(
    first, last, [first](const auto& medium) { return medium.region.kind == first->region.kind; });
  const bool sameDensity = std::all_of(
    first, last, [first](const auto& medium) { return medium.density == first->density; });
  const bool power =
    std::any_of(first, end, [](const auto& medium) { return medium.phase.power.x > 0.0; });
  const bool grey =
    std::all_of(first, end, [](const auto& medium) { return f64::airlightIsGrey(medium); });
  const bool isotropic = std::all_of(first, end, [](const auto& medium) {
    const f64::AirlightPhase& phase = medium.phase;
    return phase.rows == 0 && phase.power.x <= 0.0 && phase.poleCount == 1 && phase.order == 1 &&
      phase.pole[0].x == 1.0;
  });
  const bool samePoles = std::all_of(first, end, [first](const auto& medium) {
    return medium.phase.poleCount == first->phase.poleCount &&
      medium.phase.order == first->phase.order;
  });
  int kinds = 0; // bit i: a region is of kind i
  for (const auto* medium = first; medium != last; ++medium)
  {
    kinds |= 1 << medium->region.kind;
  }
  return (sameRegion ? Define("AIRLIGHT_REGION_KIND(region)", first->region.kind) : "") +
    Define("AIRLIGHT_REGION_KINDS", kinds) +
    (sameDensity ? Define("AIRLIGHT_DENSITY_KIND(medium)", first->density) : "") +
    Define("AIRLIGHT_HAS_POWER", power) + Define("AIRLIGHT_GREY", grey) +
    (isotropic ? Define("AIRLIGHT_ISOTROPIC", 1) : "") +
    (samePoles ? Define("AIRLIGHT_POLE_COUNT", first->phase.poleCount) +
          Define("AIRLIGHT_POLE_ORDER", first->phase.order)
               : "");
}

// Whether one channel's multiply scattered light is that of all.
bool IsMultipleGrey(const f64::AirlightMedium& medium)
{
  const glm::dvec3& scattering = medium.sigmaS;
  return f64::airlightIsGrey(medium) && scattering == glm::dvec3(scattering.x);
}

// The number of the only medium that is not bounded, if it is uniform and has a closed form beside
// bounded media; else -1. Tables of phase functions have none.
int FindEverywhere(const f64::AirlightMedia& media)
{
  int found = -1;
  const int dimming = media.count + media.volumes;
  for (int i = 0; i < dimming; ++i)
  {
    const f64::AirlightMedium& medium = media.item[i];
    if (medium.region.kind == AIRLIGHT_REGION_UNBOUNDED && medium.density != AIRLIGHT_DENSITY_GRID)
    {
      if (found >= 0 || medium.density != AIRLIGHT_DENSITY_UNIFORM || medium.phase.rows > 0)
      {
        return -1;
      }
      found = i;
    }
  }
  return dimming > 1 ? found : -1;
}

// Replaces each loop over so many media by as many copies of its block, which must not leave or
// restart it. Compilers do not unroll blocks that hold loops themselves, and then keep each
// medium's walk through its image in memory: frames took four times as long. Nor would they know
// which medium is inside a closed surface, and walk through a tree for each.
std::string UnrollMedia(const std::string& text, const std::string& bound, int count)
{
  const std::string head = "for (int i = 0; i < " + bound + "; i++)";
  const std::size_t found = text.find(head);
  if (found == std::string::npos)
  {
    return text;
  }
  const std::size_t begin = text.find('{', found);
  std::size_t end = begin + 1;
  for (int depth = 1; end < text.size() && depth > 0; ++end)
  {
    depth += text[end] == '{' ? 1 : text[end] == '}' ? -1 : 0;
  }
  const std::string block = text.substr(begin, end - begin);
  std::string unrolled = text.substr(0, found);
  for (int i = 0; i < count; ++i)
  {
    unrolled += "{ const int i = " + std::to_string(i) + ";" + block + "}";
  }
  return unrolled + UnrollMedia(text.substr(end), bound, count);
}

// The same for media, and for media and volumes.
std::string UnrollForEach(const f64::AirlightMedia& media, const std::string& text)
{
  return UnrollMedia(UnrollMedia(text, "AIRLIGHT_MEDIUM_COUNT", media.count),
    "AIRLIGHT_DIMMING_COUNT", media.count + media.volumes);
}

// Sets the members of a uniform of this name.
class UniformSetter
{
public:
  UniformSetter(vtkShaderProgram* program, const std::string& name)
    : Program(program)
    , Name(name)
  {
  }

  void operator()(const Member& member, int value) const
  {
    this->Program->SetUniformi(this->GetName(member).c_str(), value);
  }
  void operator()(const Member& member, double value) const
  {
    this->Program->SetUniformf(this->GetName(member).c_str(), static_cast<float>(value));
  }
  void operator()(const Member& member, const glm::dvec2& value) const
  {
    this->Program->SetUniform2f(this->GetName(member).c_str(), &glm::vec2(value)[0]);
  }
  void operator()(const Member& member, const glm::dvec3& value) const
  {
    this->Program->SetUniform3f(this->GetName(member).c_str(), &glm::vec3(value)[0]);
  }
  void operator()(const Member& member, const glm::dmat3& value) const
  {
    glm::mat3 single(value);
    this->Program->SetUniformMatrix3x3(this->GetName(member).c_str(), &single[0].x);
  }
  template <std::size_t Count>
  void operator()(const Member& member, const int (&values)[Count]) const
  {
    this->Program->SetUniform1iv(this->GetName(member).c_str(), static_cast<int>(Count), values);
  }
  template <std::size_t Count>
  void operator()(const Member& member, const glm::dvec3 (&values)[Count]) const
  {
    float single[Count][3];
    for (std::size_t i = 0; i < Count; ++i)
    {
      std::copy_n(&values[i].x, 3, single[i]);
    }
    this->Program->SetUniform3fv(this->GetName(member).c_str(), static_cast<int>(Count), single);
  }
  template <std::size_t Count>
  void operator()(const Member& member, const glm::dvec4 (&values)[Count]) const
  {
    glm::vec4 single[Count];
    std::copy(values, values + Count, single);
    this->Program->SetUniform4fv(
      this->GetName(member).c_str(), static_cast<int>(Count), &single[0].x);
  }
  template <std::size_t Count>
  void operator()(const Member& member, const glm::dmat4 (&values)[Count]) const
  {
    glm::mat4 single[Count];
    std::copy(values, values + Count, single);
    this->Program->SetUniformMatrix4x4v(
      this->GetName(member).c_str(), static_cast<int>(Count), &single[0][0].x);
  }

private:
  std::string GetName(const Member& member) const { return this->Name + "." + member.Name; }

  vtkShaderProgram* Program;
  const std::string& Name;
};
}

//------------------------------------------------------------------------------
std::string GetScatteringSource(const f64::AirlightMedia& media, int lightKind, bool photometry)
{
  const auto* end = media.item + media.count;
  const bool table =
    std::any_of(media.item, end, [](const auto& medium) { return medium.phase.rows > 0; });
  int surfaces = 0; // bit i: medium i is inside a closed surface
  int grids = 0;    // has an image
  int albedos = 0;  // and arrays of colours there
  int glows = 0;
  const int dimming = media.count + media.volumes;
  for (int i = 0; i < dimming; ++i)
  {
    surfaces |= media.item[i].region.kind == AIRLIGHT_REGION_SURFACE ? 1 << i : 0;
    grids |= media.item[i].density == AIRLIGHT_DENSITY_GRID ? 1 << i : 0;
    albedos |= media.item[i].albedo ? 1 << i : 0;
    glows |= media.item[i].glow ? 1 << i : 0;
  }
  const bool surface = surfaces != 0;
  const bool allSurfaces = surfaces == (1 << dimming) - 1;
  const bool grid = grids != 0;
  const bool sky = HasSky(media);
  const bool multiple = media.multiple.count > 0;
  const int everywhere = FindEverywhere(media);
  const std::string beside = everywhere < 0
    ? ""
    : std::string(AirlightEquiangular) + AirlightEquiangularPanel + AirlightBeside;
  return Define("AIRLIGHT_HAS_SURFACE", surface) + Define("AIRLIGHT_SURFACE_MEDIA", surfaces) +
    Define("AIRLIGHT_ALL_SURFACES", allSurfaces) + Define("AIRLIGHT_HAS_GRID", grid) +
    Define("AIRLIGHT_GRID_MEDIA", grids) + Define("AIRLIGHT_SAMPLE_BITS", GetSampleBits(media)) +
    Define("AIRLIGHT_ALBEDO_MEDIA", albedos) + Define("AIRLIGHT_GLOW_MEDIA", glows) +
    Define("AIRLIGHT_HAS_TABLE", table) + Define("AIRLIGHT_HAS_PHOTOMETRY", photometry) +
    (sky ? Define("AIRLIGHT_HAS_SKY", 1) : "") +
    Define("AIRLIGHT_HAS_DATA", surface || table || photometry || grid) + AirlightPrelude +
    Define("AIRLIGHT_MAX_POLES", AIRLIGHT_MAX_POLES) + Define("AIRLIGHT_MAX_MEDIA", dimming) +
    Define("AIRLIGHT_MEDIUM_COUNT", media.count) +
    (media.volumes > 0
        ? Define("AIRLIGHT_HAS_VOLUMES", 1) + Define("AIRLIGHT_DIMMING_COUNT", dimming)
        : "") +
    Define("AIRLIGHT_MULTIPLE", multiple) +
    Define("AIRLIGHT_MULTIPLE_GREY", multiple && IsMultipleGrey(media.item[0])) +
    Define("AIRLIGHT_MULTIPLE_LIGHTS", media.multiple.count) +
    Define("AIRLIGHT_MULTIPLE_SUNS", media.multiple.suns) +
    "#define AIRLIGHT_MULTIPLE_COLLISIONS " + (HasCollisions(media) ? "true\n" : "false\n") +
    Define("AIRLIGHT_MULTIPLE_NODES", AIRLIGHT_MULTIPLE_NODES) +
    (everywhere >= 0 ? Define("AIRLIGHT_EVERYWHERE", everywhere) : "") + DefineCommon(media) +
    (lightKind >= 0 ? Define("AIRLIGHT_LIGHT_KIND", lightKind) : "") + AirlightExponentialIntegral +
    AirlightGauss + AirlightGoniometric + AirlightPhase + AirlightPointLight + AirlightRegion +
    (grid ? AirlightGrid : "") + (sky ? AirlightSky : "") + AirlightMedium + AirlightClosedSurface +
    AirlightPath + AirlightHeightFog + (multiple ? AirlightSourceFunction : "") +
    (surface && !allSurfaces ? UnrollForEach(media, AirlightMedia) : AirlightMedia) +
    AirlightAmbient + AirlightLight + AirlightKinks + AirlightQuadrature +
    (multiple ? std::string(AirlightLayeredScattering) + AirlightMultipleScattering : "") +
    AirlightGoniometricRay + AirlightPieces + AirlightDirectionalLight +
    (grid ? UnrollForEach(
              media, std::string(AirlightGridWay) + AirlightGridSteps + AirlightGridRay + beside)
          : beside) +
    AirlightScattering + AirlightDiffuseLight;
}

//------------------------------------------------------------------------------
std::string GetScatteredIrradianceSource()
{
  return std::string(AirlightIrradianceRay) + AirlightScatteredIrradiance;
}

//------------------------------------------------------------------------------
int GetSampleBits(const f64::AirlightMedia& media)
{
  int bits = 0;
  for (int i = 0; i < media.count + media.volumes; ++i)
  {
    if (media.item[i].density == AIRLIGHT_DENSITY_GRID)
    {
      const int own = media.item[i].grid->GetSamples().GetBits();
      bits = bits == 0 || bits == own ? own : FloatBits;
    }
  }
  return bits == 0 ? FloatBits : bits;
}

//------------------------------------------------------------------------------
GridUniforms GetGridUniforms(const f64::AirlightMedium& medium)
{
  return { medium.grid->GetAxes(), medium.grid->ToSamples(medium.gridOrigin),
    medium.grid->GetLast(), medium.gridFirst };
}

//------------------------------------------------------------------------------
void SetMediaUniforms(vtkShaderProgram* program, const std::string& name,
  const f64::AirlightMedia& media, bool multiple)
{
  VisitMediaUniforms(UniformSetter(program, name), media);
  if (multiple && media.multiple.count > 0)
  {
    VisitMultiple(UniformSetter(program, "airlightMultiple"), media.multiple);
  }
}

//------------------------------------------------------------------------------
void SetPhotometryUniforms(
  vtkShaderProgram* program, const std::string& name, const f64::AirlightPhotometry& photometry)
{
  VisitPhotometry(UniformSetter(program, name), photometry);
}

//------------------------------------------------------------------------------
void SetLightUniforms(
  vtkShaderProgram* program, const std::string& name, const f64::AirlightLight& light)
{
  VisitLight(UniformSetter(program, name), light);
}
}
