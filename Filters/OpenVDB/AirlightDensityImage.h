// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The values of the regular image that a sparse grid becomes.
 */

#ifndef AirlightDensityImage_h
#define AirlightDensityImage_h

#include "OpenVDB/AirlightDensityImagePlan.h"

#include <cstddef>

namespace airlight
{
// The values of all points, x fastest. Values that are not finite count as background; returns how
// many of them there were.
std::size_t FillDensityImage(const OpenVDBGrid& grid, const DensityImagePlan& plan, float* values);
}

#endif
