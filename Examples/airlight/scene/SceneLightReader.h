// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SceneLightReader_h
#define SceneLightReader_h

#include "formats/LocatedJson.h"
#include "scene/Scene.h"

#include <string>

namespace airlight
{

/**
 * One of the `lights` of a scene file, see ReadScene(). Throws UserError.
 */
LightSource ReadSceneLight(const LocatedJson& json, const std::string& sceneFile);

}

#endif
