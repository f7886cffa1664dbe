// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "MultipleScattering/AirlightLayeredSolution.h"

#include "Medium/AirlightConvertSky.h"
#include "vtkMath.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace airlight
{
namespace
{
// How far beyond a free side light that is scattered often would be 0, in transport mean free
// paths: Milne's problem. A side takes what diffusion brings it as if that were the way from it to
// there.
constexpr double Extrapolation = 0.7104;

// The axis along which the sun's way through a box is shortest.
int FindThinnest(const glm::dvec3& extent, const glm::dvec3& towards)
{
  int thinnest = 0;
  for (int axis = 1; axis < 3; ++axis)
  {
    if (extent[axis] * std::abs(towards[thinnest]) < extent[thinnest] * std::abs(towards[axis]))
    {
      thinnest = axis;
    }
  }
  return thinnest;
}

// Layers end nowhere; of what a box would scatter without its other sides this is left. By
// diffusion in a box whose sides are `extent` optical lengths apart: the light's form falls to 0
// beyond them.
double GetSideShare(double albedo, double meanCosine, const glm::dvec3& extent, int axis)
{
  const double transport = 1.0 - albedo * meanCosine;
  glm::dvec3 curvature;
  for (int i = 0; i < 3; ++i)
  {
    const double wave = vtkMath::Pi() / (extent[i] + 2.0 * Extrapolation / transport);
    curvature[i] = wave * wave;
  }
  const double layers = 3.0 * (1.0 - albedo) * transport + curvature[axis];
  return layers / (layers + curvature[(axis + 1) % 3] + curvature[(axis + 2) % 3]);
}

// A cosine nearby at which no channel's terms are the difference of two infinite ones.
double AvoidResonance(double cosine, const glm::dvec3& rate)
{
  constexpr double apart = 1e-3;
  for (int i = 0; i < 3; ++i)
  {
    for (int channel = 0; channel < 3; ++channel)
    {
      if (std::abs(rate[channel] * cosine - 1.0) < apart)
      {
        cosine = (1.0 - 1.01 * apart) / rate[channel];
      }
    }
  }
  return cosine;
}
}

//------------------------------------------------------------------------------
void MakeLayers(const glm::dvec3& albedo, double meanCosine, f64::AirlightMultiple& result)
{
  const double peak = meanCosine > 0.0 ? meanCosine * meanCosine : 0.0;
  const double cosine = (meanCosine - peak) / (1.0 - peak);
  result.meanCosine = meanCosine;
  result.layerCosine = cosine;
  for (int channel = 0; channel < 3; ++channel)
  {
    const double scale = 1.0 - albedo[channel] * peak;
    const double scattered = std::min((1.0 - peak) * albedo[channel] / scale, MaximumLayerAlbedo);
    result.layerScale[channel] = scale;
    result.layerAlbedo[channel] = scattered;
    result.layerRate[channel] = std::sqrt(3.0 * (1.0 - scattered) * (1.0 - scattered * cosine));
    result.layerFlux[channel] = std::sqrt(3.0 * (1.0 - scattered) / (1.0 - scattered * cosine));
  }
}

//------------------------------------------------------------------------------
LayerTerms SolveLayers(double albedo, double meanCosine, double cosine, double end, double ground)
{
  // i1' = -3 (1 - albedo) i0 + even e^(-depth/cosine), i0' = -(1 - albedo meanCosine) i1 + ahead
  // e^(-depth/cosine), for unit irradiance.
  const double even = 3.0 * albedo / (4.0 * vtkMath::Pi());
  const double ahead = even * meanCosine * cosine;
  const double transport = 1.0 - albedo * meanCosine;
  const double rate = std::sqrt(3.0 * (1.0 - albedo) * transport);
  const double flux = std::sqrt(3.0 * (1.0 - albedo) / transport);
  LayerTerms terms;
  terms.Beam = cosine * (cosine * transport * even + ahead) / (1.0 - rate * rate * cosine * cosine);
  terms.BeamFlux = cosine * (3.0 * (1.0 - albedo) * terms.Beam + even);
  // No diffuse light enters: i0 + Extrapolation i1 = 0 at the lit side; at the other i0 -
  // Extrapolation i1 is what the ground reflects.
  const double with = 1.0 + Extrapolation * flux;
  const double against = 1.0 - Extrapolation * flux;
  const double lit = terms.Beam + Extrapolation * terms.BeamFlux;
  if (end == std::numeric_limits<double>::infinity())
  {
    terms.Fall = lit / with;
    return terms;
  }
  const double across = std::exp(-rate * end);
  const double arrives = std::exp(-end / cosine);
  const double unlit = arrives *
    (terms.Beam - Extrapolation * terms.BeamFlux + ground * (cosine / vtkMath::Pi() - lit));
  const double falls = across * (against - ground * with);
  const double climbs = with - ground * against;
  const double determinant = with * climbs - across * against * falls;
  terms.Fall = (lit * climbs - unlit * across * against) / determinant;
  terms.Climb = (unlit * with - lit * falls) / determinant;
  return terms;
}

//------------------------------------------------------------------------------
bool AddMultipleSun(f64::AirlightMedia& media, const f64::AirlightLight& light)
{
  f64::AirlightMultiple& multiple = media.multiple;
  const f64::AirlightMedium& medium = media.item[0];
  const bool box = medium.region.kind == AIRLIGHT_REGION_BOX;
  const bool height =
    medium.region.kind == AIRLIGHT_REGION_UNBOUNDED && medium.density == AIRLIGHT_DENSITY_HEIGHT;
  if (multiple.suns == AIRLIGHT_MAX_MULTIPLE_SUNS || !(box || height))
  {
    return false;
  }
  const glm::dvec3 extent = medium.region.boxMax - medium.region.boxMin;
  const int axis = FindThinnest(extent, light.position);
  glm::dvec4 layers(medium.up, 0.0);
  if (box)
  {
    const double side = light.position[axis] < 0.0 ? -1.0 : 1.0;
    layers = glm::dvec4(0.0);
    layers[axis] = side;
    layers.w = side > 0.0 ? medium.region.boxMax[axis] : -medium.region.boxMin[axis];
  }
  const double cosine =
    AvoidResonance(glm::dot(glm::dvec3(layers), light.position), multiple.layerRate);
  if (!(cosine > 0.0))
  {
    return true; // the sun has set
  }
  glm::dvec4* rows = multiple.sun + multiple.suns * AIRLIGHT_SUN_ROWS; // for all channels
  rows[AIRLIGHT_SUN_DIRECTION] = glm::dvec4(light.position, cosine);
  rows[AIRLIGHT_SUN_LAYERS] = layers;
  rows[AIRLIGHT_SUN_IRRADIANCE] = glm::dvec4(light.intensity, 0.0);
  for (int channel = 0; channel < 3; ++channel)
  {
    const double sigma = medium.sigmaT[channel];
    const double thickness = box ? extent[axis] : multiple.groundDepth;
    const double end = box || thickness > 0.0 ? sigma * thickness * multiple.layerScale[channel]
                                              : std::numeric_limits<double>::infinity();
    const LayerTerms terms = SolveLayers(multiple.layerAlbedo[channel], multiple.layerCosine,
      cosine, end, box ? 0.0 : multiple.groundAlbedo[channel]);
    rows[AIRLIGHT_SUN_SHARE][channel] = !box
      ? 1.0
      : GetSideShare(sigma > 0.0 ? medium.sigmaS[channel] / sigma : 0.0, multiple.meanCosine,
          sigma * extent, axis);
    constexpr double far = 2e4; // a finite number in shaders
    rows[AIRLIGHT_SUN_END][channel] = std::min(end, far);
    rows[AIRLIGHT_SUN_FALL][channel] = terms.Fall;
    rows[AIRLIGHT_SUN_CLIMB][channel] = terms.Climb;
    rows[AIRLIGHT_SUN_BEAM][channel] = terms.Beam;
    rows[AIRLIGHT_SUN_BEAM_FLUX][channel] = terms.BeamFlux;
  }
  ++multiple.suns;
  ++multiple.count;
  RemoveAmbient(media.item[0]); // which stands for the same light
  return true;
}
}
