// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * From VTK's objects to the structures of the mathematics. The only place where a vtkLight's
 * numbers become physical ones. Not installed; exported for the module's own tests.
 */

#ifndef AirlightConvert_h
#define AirlightConvert_h

#include "Integration/AirlightMath.h"
#include "Medium/AirlightSkyHarmonics.h"
#include "vtkAirlightModule.h" // for export macro

#include <string>
#include <vector>

class vtkLight;
class vtkParticipatingMedium;

namespace airlight
{
// Whether all components are finite and their squares, too. False for NaN.
inline bool IsModerate(const glm::dvec3& v)
{
  return glm::all(glm::lessThanEqual(glm::abs(v), glm::dvec3(1e100)));
}

// Media with positions relative to `origin`; those beyond AIRLIGHT_MAX_MEDIA are left out. An
// environment is added to the ambient light of each.
VTKAIRLIGHT_EXPORT f64::AirlightMedia ConvertMedia(
  const std::vector<vtkParticipatingMedium*>& media, const glm::dvec3& origin,
  const SkyHarmonics* environment = nullptr);

// Adds a volume that takes light away on its way from the lights, and is not seen: an image of
// density and its extinction at density 1. False if there are AIRLIGHT_MAX_MEDIA media and volumes.
VTKAIRLIGHT_EXPORT bool AddVolume(
  f64::AirlightMedia& media, const DensityGrid& grid, double sigmaT, const glm::dvec3& origin);

// Whether any of the media scatters light.
VTKAIRLIGHT_EXPORT bool HasScattering(const f64::AirlightMedia& media);

// Whether there is ambient light that they scatter, or they emit.
VTKAIRLIGHT_EXPORT bool Shines(const f64::AirlightMedia& media);

// What the mathematics can do with a light.
enum class LightSupport
{
  Off,      // switched off or without power: contributes nothing
  Scatters, // done
  Invalid   // numbers that are not finite, or attenuation without a positive term
};

// What is said of lights that are LightSupport::Invalid.
constexpr const char* InvalidLightText =
  "A light is left out of the medium: its position, colour and attenuation must be finite, "
  "its attenuation at least 0 with one term above 0, its exponent at least 0, and the focal "
  "point of a spot or a directional light apart from its position.";

// Adds a lamp to the media's multiple scattering, if they have any. False where it is left out: it
// is no point lamp inside, or there are AIRLIGHT_MAX_MULTIPLE_LAMPS already.
VTKAIRLIGHT_EXPORT bool AddMultipleLamp(f64::AirlightMedia& media, const f64::AirlightLight& light);

// Whether lights became lamps where they collide first: none of those is a light itself.
VTKAIRLIGHT_EXPORT bool HasCollisions(const f64::AirlightMedia& media);

// The number of the media's lamp or sun that this light is, -1 where it is none.
VTKAIRLIGHT_EXPORT int FindMultipleLamp(
  const f64::AirlightMedia& media, const f64::AirlightLight& light);

// Whether the light's light is scattered more than once, at its own place or elsewhere.
VTKAIRLIGHT_EXPORT bool IsMultiple(
  const f64::AirlightMedia& media, const f64::AirlightLight& light);

// What is said of so many lights that are left out.
VTKAIRLIGHT_EXPORT std::string GetScatteredOnceText(int lights);

// A point light of this radiant intensity and inverse-square attenuation, relative to `origin`.
f64::AirlightLight ConvertPointLight(const f64::AirlightMedia& media, const glm::dvec3& position,
  const glm::dvec3& radiantIntensity, const glm::dvec3& origin);

// Whether the whole way from a light at a place to every sample is inside one uniform medium, the
// light falls off by the inverse square, and is the same all over its cone: what the closed form
// asks of all but the phase function.
VTKAIRLIGHT_EXPORT bool HasUniformPaths(
  const f64::AirlightMedia& media, const f64::AirlightLight& light);

// Whether a light falls off by the inverse square, the same all over its cone, in one unbounded
// medium whose density falls with height.
VTKAIRLIGHT_EXPORT bool IsInHeightFog(
  const f64::AirlightMedia& media, const f64::AirlightLight& light);

// Any vtkLight, relative to `origin`. The light's radius is left for the caller to set.
VTKAIRLIGHT_EXPORT LightSupport ConvertLight(const f64::AirlightMedia& media, vtkLight* light,
  const glm::dvec3& origin, f64::AirlightLight& result);
}

#endif
