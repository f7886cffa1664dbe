// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Files that a scene file names.
 */

#ifndef SceneFile_h
#define SceneFile_h

#include "formats/LocatedJson.h"

#include <functional>
#include <string>

namespace airlight
{

/**
 * The file that a value names, beside the scene file or in the folder above it. Throws UserError if
 * there is none.
 */
std::string FindSceneFile(const LocatedJson& json, const std::string& sceneFile);

/**
 * Run a task with that file; to a UserError of the task, add where the scene file names it.
 */
void UseSceneFile(const LocatedJson& json, const std::function<void()>& task);

}

#endif
