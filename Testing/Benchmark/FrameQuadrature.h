// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef FrameQuadrature_h
#define FrameQuadrature_h

#include "FrameScene.h"

#include <functional>
#include <vector>

namespace benchmarks
{
// How the frames of the neighbour are named in the rows of a scene.
const char* const Neighbour = "closed form, ";

/**
 * Scenes whose airlight is integrated by quadrature, each beside a neighbour of closed form: a
 * light just outside a region and one inside it, Mie's phase function and one that is fitted.
 * `fill`: what is seen, with one light.
 */
std::vector<SceneRecipe> MakeQuadratureRecipes(const std::function<void(FrameScene&)>& fill);
}

#endif
