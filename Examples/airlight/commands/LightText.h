// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Lamps as values of command-line options. Each function throws UserError, which names the option,
 * the text and the form that was expected, unless the whole text fits. Where a form has I or E,
 * the three channels r,g,b will do as well.
 */

#ifndef LightText_h
#define LightText_h

#include "scene/Scene.h"

#include <string>

namespace airlight
{

/// "x,y,z:I": position, radiant intensity.
LightSource ParsePoint(const std::string& option, const std::string& text);

/// "x,y,z:tx,ty,tz:ANGLE:I[:EXPONENT]": position, the point it aims at, half angle of the cone in
/// degrees, radiant intensity on the axis, exponent of the cosine (0).
LightSource ParseSpot(const std::string& option, const std::string& text);

/// "dx,dy,dz:E": direction towards the sun, irradiance of a plane that faces it.
LightSource ParseSun(const std::string& option, const std::string& text);

///@{
/// What goes with a point or spot: the photometric file, the point that a point lamp with such a
/// file or with a size aims at, and the direction "ux,uy,uz" by which file or size is turned.
void ParsePhotometry(const std::string& option, const std::string& text, LightSource& light);
void ParsePhotometryAim(const std::string& option, const std::string& text, LightSource& light);
void ParsePhotometryUp(const std::string& option, const std::string& text, LightSource& light);
///@}

///@{
/// The extent of a lamp: the radius "R" or the size "W,H" of a point or spot, and the angular
/// diameter "DEG" of a sun in degrees.
void ParseLampRadius(const std::string& option, const std::string& text, LightSource& light);
void ParseLampSize(const std::string& option, const std::string& text, LightSource& light);
void ParseSunDiameter(const std::string& option, const std::string& text, LightSource& light);
///@}

}

#endif
