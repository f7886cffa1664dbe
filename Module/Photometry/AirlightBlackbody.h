// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a black body shines in the channels of a picture.
 */

#ifndef AirlightBlackbody_h
#define AirlightBlackbody_h

#include <glm/glm.hpp>

namespace airlight
{
// Planck's law at this temperature, K, seen by the CIE 1931 observer, in linear sRGB, W/(m^2 sr):
// the luminance of (r, g, b) is 683 (0.2126 r + 0.7152 g + 0.0722 b) cd/m^2. Colours outside of
// sRGB lose what is negative.
glm::dvec3 GetBlackbodyRadiance(double temperature);
}

#endif
