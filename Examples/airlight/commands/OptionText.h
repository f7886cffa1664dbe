// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Values of command-line options. Each function throws UserError, which names the option, the text
 * and the form that was expected, unless the whole text fits.
 */

#ifndef OptionText_h
#define OptionText_h

#include "scene/Scene.h"

#include <string>
#include <utility>

namespace airlight
{

/// A number with low <= number <= high.
double ParseNumber(const std::string& option, const std::string& text, double low, double high);

/// "r,g,b", each at least 0.
Vector3 ParseColor(const std::string& option, const std::string& text);

/// "WxH", each 1..16384.
std::pair<int, int> ParseSize(const std::string& option, const std::string& text);

/// "px,py,pz:fx,fy,fz[:angle]". View up and, if not given, the angle are those of `camera`.
CameraSettings ParseCamera(
  const std::string& option, const std::string& text, const CameraSettings& camera);

/// Where `fileName` has one "%d" or "%04d" and the like, put the number there.
std::string NumberFile(const std::string& option, const std::string& fileName, int number);

}

#endif
