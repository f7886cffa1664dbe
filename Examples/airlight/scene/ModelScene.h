// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ModelScene_h
#define ModelScene_h

#include "scene/Scene.h"

#include <string>

namespace airlight
{

/**
 * A model with what it needs to be seen, by the diagonal D of the box around it:
 *  - a camera that looks along -z and sees all of it (view angle 30 degrees);
 *  - a point lamp above, to the left and in front of it, which would light a surface in the middle
 *    of the model that faces it to a radiance of twice its albedo if the air were clear;
 *  - an unbounded, isotropic, purely scattering medium of visibility 10 D.
 *
 * Throws UserError if the model cannot be read or has no extent.
 */
Scene MakeModelScene(const std::string& fileName);

/**
 * ReadScene() for .json, MakeModelScene() for everything else.
 */
Scene ReadSceneOrModel(const std::string& fileName);

}

#endif
