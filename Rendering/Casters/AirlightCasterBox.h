// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where casters are, as a whole.
 */

#ifndef AirlightCasterBox_h
#define AirlightCasterBox_h

#include "Casters/AirlightCasters.h"

#include <glm/glm.hpp>

#include <array>
#include <vector>

namespace airlight
{
// Of the box around the caster's mesh, in the world: bit by bit of a corner's number, 1 is the
// lower end of an axis of the mesh.
std::array<glm::dvec3, 8> GetCorners(const Caster& caster);

// A place among the casters, the same in whichever order they come, and seldom another one when
// they move: on a grid whose cells are from an eighth to a quarter as long as half of them reach.
// Medians, so that a terrain or a far mountain does not cost the other casters their digits.
glm::dvec3 FindAnchor(const std::vector<Caster>& casters);
}

#endif
