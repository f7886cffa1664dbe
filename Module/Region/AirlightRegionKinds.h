// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The kinds of region: one row each, with what shaders need of it. Their mathematics is in
 * glsl/Medium/AirlightRegion.glsl.
 */

#ifndef AirlightRegionKinds_h
#define AirlightRegionKinds_h

#include "Integration/AirlightMath.h"

#include <string>

class vtkParticipatingMedium;

namespace airlight
{
// The name of a vtkParticipatingMedium::RegionType, empty for an unknown one.
std::string GetRegionName(int type);

// "UNBOUNDED, BOX ... or CYLINDER".
std::string ListRegionConstants();

// The region of the medium relative to `origin`; false if it is missing or invalid.
bool ConvertRegion(
  vtkParticipatingMedium* medium, const glm::dvec3& origin, f64::AirlightRegion& region);
}

#endif
