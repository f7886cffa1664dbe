// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The light of suns that was scattered more than once in level layers, by Eddington's
 * approximation: the terms that AirlightLayeredScattering.glsl sums. Not installed; exported for
 * the module's own tests.
 */

#ifndef AirlightLayeredSolution_h
#define AirlightLayeredSolution_h

#include "Integration/AirlightMath.h"
#include "vtkAirlightModule.h" // for export macro

namespace airlight
{
// Of an albedo for each channel and the phase function's mean cosine: what all suns share.
void MakeLayers(const glm::dvec3& albedo, double meanCosine, f64::AirlightMultiple& result);

// A sun's terms for unit irradiance: i0 and i1 are fall (1, flux) e^(-rate depth) + climb (1,
// -flux) e^(-rate (end - depth)) - (beam, beamFlux) e^(-depth/cosine).
struct LayerTerms
{
  double Fall = 0.0;
  double Climb = 0.0;
  double Beam = 0.0;
  double BeamFlux = 0.0;
};

// Of layers of the depth `end`, which is infinite for a half-space, above ground of the albedo
// `ground`, whose scattering has this albedo, at most MaximumLayerAlbedo, and mean cosine. The
// cosine is that between the way to the sun and the layers' normal; 1/cosine must differ from
// sqrt(3 (1 - albedo)(1 - albedo meanCosine)).
VTKAIRLIGHT_EXPORT LayerTerms SolveLayers(
  double albedo, double meanCosine, double cosine, double end, double ground = 0.0);

// Layers without absorption have no falling terms.
constexpr double MaximumLayerAlbedo = 1.0 - 1e-5;

// The sun becomes one of the media's; false where their one medium has no layers or there are
// AIRLIGHT_MAX_MULTIPLE_SUNS.
bool AddMultipleSun(f64::AirlightMedia& media, const f64::AirlightLight& light);
}

#endif
