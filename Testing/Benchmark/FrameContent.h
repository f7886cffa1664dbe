// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Content as people draw it, one kind in each scene, beside a ball on a floor under the same
 * lights. Each scene is that ball and floor and something else; its frames and those of the ball
 * and floor alone are timed in turn.
 */

#ifndef FrameContent_h
#define FrameContent_h

#include "FrameScene.h"

#include <string>
#include <vector>

namespace benchmarks
{
// How the frames of the ball and floor are named in the rows of a scene.
const char* const BallAndFloor = "ball and floor, ";

void FillBallAndFloor(FrameScene& scene, int lights);

// What a scene has beside the ball and floor.
struct Content
{
  std::string Name;
  void (*Add)(FrameScene& scene);
};

// Meshes and swarms of small things, and everything else.
std::vector<Content> GetMeshContent();
std::vector<Content> GetPropContent();

// All of them: content/NAME with one light, content-4-lights/NAME and content-16-lights/NAME.
std::vector<SceneRecipe> MakeContentRecipes();
}

#endif
