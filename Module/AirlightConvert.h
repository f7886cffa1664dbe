// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * From VTK's objects to the structures of the mathematics. The only place where a vtkLight's
 * numbers become physical ones.
 */

#ifndef AirlightConvert_h
#define AirlightConvert_h

#include "AirlightMath.h"

class vtkLight;
class vtkParticipatingMedium;

namespace airlight
{
// The medium with positions relative to `origin`.
f64::AirlightMedium ConvertMedium(vtkParticipatingMedium* medium, const glm::dvec3& origin);

// What the mathematics can do with a light.
enum class LightSupport
{
  Dark,        // switched off or without power: contributes nothing
  Scatters,    // done
  Unsupported, // spots; directional lights in a bounded medium
  Invalid      // numbers that are not finite, or attenuation without a positive term
};

// A point light of this radiant intensity and inverse-square attenuation, relative to `origin`.
f64::AirlightLight ConvertPointLight(const f64::AirlightMedium& medium, const glm::dvec3& position,
  const glm::dvec3& radiantIntensity, const glm::dvec3& origin);

// Any vtkLight, relative to `origin`. The light's radius is left for the caller to set.
LightSupport ConvertLight(const f64::AirlightMedium& medium, vtkLight* light,
  const glm::dvec3& origin, f64::AirlightLight& result);
}

#endif
