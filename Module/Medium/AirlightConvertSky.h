// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A medium's ambient light, from all directions alike and by direction, as its phase function
 * scatters it.
 */

#ifndef AirlightConvertSky_h
#define AirlightConvertSky_h

#include "Integration/AirlightMath.h"
#include "Medium/AirlightSkyHarmonics.h"

class vtkParticipatingMedium;

namespace airlight
{
// Sets `ambient` and `sky`. An environment, which may be null, is added to the medium's own.
void ConvertAmbient(
  vtkParticipatingMedium* medium, const SkyHarmonics* environment, f64::AirlightMedium& result);

// Where multiply scattered light takes its place.
inline void RemoveAmbient(f64::AirlightMedium& medium)
{
  medium.ambient = glm::dvec3(0.0);
  medium.sky.on = 0;
}
}

#endif
