// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FrameChanges_h
#define FrameChanges_h

#include "FrameScene.h"

#include <functional>
#include <vector>

namespace benchmarks
{
class Rows;
class WindowMaker;

// What the names of these rows end with.
constexpr char FirstFrame[] = ", first frame";
constexpr char SecondFrame[] = ", second frame";

/**
 * Scenes in which something changes: what the first and the second frame after that take. Numbers
 * should compile nothing; other kinds of media, lights and surfaces do. `fill`: the scene before.
 */
std::vector<SceneRecipe> MakeChangeRecipes(const std::function<void(FrameScene&)>& fill);

/**
 * Times the frames of such a recipe, each repetition in a window of its own, which has compiled
 * nothing yet. KeepNoShaders() should come first.
 */
void TimeChange(const SceneRecipe& recipe, const WindowMaker& windows, int repetitions, Rows& rows);

// Mesa keeps compiled shaders on disk, which the first frames of a user do not find there.
void KeepNoShaders();
}

#endif
