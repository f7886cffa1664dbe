// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The members of the structures that shaders and C++ share, each listed once: VisitMedium(visit,
 * medium) calls visit(member, value) for each number, vector and array in a medium, those of nested
 * structures included. With several structures it visits them side by side, in either precision:
 * visit(member, a, b). So uniforms, comparisons and conversions cannot miss a member, and
 * TestAirlightShaderLibrary finds one that is missing here.
 *
 * What only C++ has, pointers to data and images of density, is not among them. Not installed.
 */

#ifndef AirlightMembers_h
#define AirlightMembers_h

#include "Integration/AirlightMath.h"

#include <algorithm>
#include <string>

namespace airlight
{
struct Member
{
  std::string Name;        // as in GLSL, with those of the structures that hold it: "region.kind"
  bool IsPosition = false; // relative to the origin of coordinates
};

// A visitor of the structure `owner`, for the structure that holds it.
template <typename Visitor>
auto VisitIn(const std::string& owner, Visitor& visit)
{
  return [owner, &visit](const Member& member, auto&... values) {
    visit(Member{ owner + "." + member.Name, member.IsPosition }, values...);
  };
}

template <typename Visitor, typename... Phase>
void VisitPhase(Visitor&& visit, Phase&... phase)
{
  visit(Member{ "pole" }, phase.pole...);
  visit(Member{ "poleCount" }, phase.poleCount...);
  visit(Member{ "order" }, phase.order...);
  visit(Member{ "power" }, phase.power...);
  visit(Member{ "first" }, phase.first...);
  visit(Member{ "rows" }, phase.rows...);
}

template <typename Visitor, typename... Region>
void VisitRegion(Visitor&& visit, Region&... region)
{
  visit(Member{ "kind" }, region.kind...);
  visit(Member{ "boxMin", true }, region.boxMin...);
  visit(Member{ "boxMax", true }, region.boxMax...);
  visit(Member{ "centre", true }, region.centre...);
  visit(Member{ "radius" }, region.radius...);
  visit(Member{ "axis" }, region.axis...);
  visit(Member{ "halfHeight" }, region.halfHeight...);
  visit(Member{ "first" }, region.first...);
  visit(Member{ "nodes" }, region.nodes...);
}

template <typename Visitor, typename... Sky>
void VisitSky(Visitor&& visit, Sky&... sky)
{
  visit(Member{ "on" }, sky.on...);
  visit(Member{ "linear" }, sky.linear...);
  visit(Member{ "quadratic" }, sky.quadratic...);
  visit(Member{ "contrast" }, sky.contrast...);
  visit(Member{ "up" }, sky.up...);
  visit(Member{ "angle" }, sky.angle...);
  visit(Member{ "odd" }, sky.odd...);
}

// Without the sky, which in shaders is there where any medium has one.
template <typename Visitor, typename... Medium>
void VisitMedium(Visitor&& visit, Medium&... medium)
{
  visit(Member{ "sigmaS" }, medium.sigmaS...);
  visit(Member{ "sigmaT" }, medium.sigmaT...);
  visit(Member{ "ambient" }, medium.ambient...);
  visit(Member{ "emission" }, medium.emission...);
  VisitPhase(VisitIn("phase", visit), medium.phase...);
  VisitRegion(VisitIn("region", visit), medium.region...);
  visit(Member{ "density" }, medium.density...);
  visit(Member{ "up" }, medium.up...);
  visit(Member{ "inverseScaleHeight" }, medium.inverseScaleHeight...);
  visit(Member{ "originHeight" }, medium.originHeight...);
}

template <typename Visitor, typename... Photometry>
void VisitPhotometry(Visitor&& visit, Photometry&... photometry)
{
  visit(Member{ "first" }, photometry.first...);
  visit(Member{ "axis" }, photometry.axis...);
  visit(Member{ "up" }, photometry.up...);
}

template <typename Visitor, typename... Light>
void VisitLight(Visitor&& visit, Light&... light)
{
  visit(Member{ "kind" }, light.kind...);
  visit(Member{ "position", true }, light.position...);
  visit(Member{ "intensity" }, light.intensity...);
  visit(Member{ "attenuation" }, light.attenuation...);
  visit(Member{ "radius" }, light.radius...);
  visit(Member{ "axis" }, light.axis...);
  visit(Member{ "cosCone" }, light.cosCone...);
  visit(Member{ "exponent" }, light.exponent...);
  visit(Member{ "goniometric" }, light.goniometric...);
  VisitPhotometry(VisitIn("photometry", visit), light.photometry...);
  visit(Member{ "gridFirst" }, light.gridFirst...);
  visit(Member{ "gridSize" }, light.gridSize...);
  visit(Member{ "gridCells" }, light.gridCells...);
}

template <typename Visitor, typename... Multiple>
void VisitMultiple(Visitor&& visit, Multiple&... multiple)
{
  visit(Member{ "on" }, multiple.on...);
  visit(Member{ "count" }, multiple.count...);
  visit(Member{ "suns" }, multiple.suns...);
  visit(Member{ "kappa" }, multiple.kappa...);
  visit(Member{ "loss" }, multiple.loss...);
  visit(Member{ "lobe" }, multiple.lobe...);
  visit(Member{ "source" }, multiple.source...);
  visit(Member{ "moment" }, multiple.moment...);
  visit(Member{ "lamp" }, multiple.lamp...);
  visit(Member{ "power" }, multiple.power...);
  visit(Member{ "layerCosine" }, multiple.layerCosine...);
  visit(Member{ "layerAlbedo" }, multiple.layerAlbedo...);
  visit(Member{ "layerScale" }, multiple.layerScale...);
  visit(Member{ "layerRate" }, multiple.layerRate...);
  visit(Member{ "layerFlux" }, multiple.layerFlux...);
  visit(Member{ "sun" }, multiple.sun...);
}

// Whether any medium has a sky. Then all have the members in shaders.
inline bool HasSky(const f64::AirlightMedia& media)
{
  return std::any_of(media.item, media.item + media.count,
    [](const f64::AirlightMedium& medium) { return medium.sky.on != 0; });
}

// Without `multiple`, which in shaders is a uniform of its own.
template <typename Visitor, typename... Media>
void VisitMedia(Visitor&& visit, Media&... media)
{
  visit(Member{ "count" }, media.count...);
  visit(Member{ "volumes" }, media.volumes...);
  const int count = std::min({ (media.count + media.volumes)... });
  for (int i = 0; i < count; ++i)
  {
    VisitMedium(VisitIn("item[" + std::to_string(i) + "]", visit), media.item[i]...);
  }
}
}

#endif
