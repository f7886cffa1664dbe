// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What the mappers' shaders know of lamps when they are made, where these are few: what a software
 * renderer would otherwise run for each kind of light there could be.
 */

#ifndef AirlightKnownLamps_h
#define AirlightKnownLamps_h

#include "Scene/AirlightLamps.h"

#include <cstddef>
#include <string>
#include <vector>

namespace airlight
{
// So many lamps have lines of their own in the shaders; more share a loop.
constexpr size_t MaximumOwnLines = 4;

// Of so many the shaders know the types. Of sixteen, Mesa's compiler takes twice as long for what is then
// shorter.
constexpr size_t MaximumKnownLamps = 8;

struct KnownLamp
{
  bool Scatters = true;     // else as VTK shades it: without power, or refused
  bool Sun = false;         // at infinity, for the medium
  bool Goniometric = false; // shines by a photometric file
  // As VTK's shading has it.
  bool Positional = false;
  bool Spot = false;
  bool InverseSquare = false; // fades with the distance's square and nothing else
};
bool operator==(const KnownLamp& a, const KnownLamp& b);

// Each lamp; none where there are too many.
std::vector<KnownLamp> FindKnownLamps(const std::vector<Lamp>& lamps);

// The macro with a line for each lamp, for AirlightSurface.glsl; empty where there is none. `apart`:
// SurfaceText::Apart.
std::string DefineLamps(const std::vector<KnownLamp>& known, int apart);

// VTK's lines in which uniforms are asked for lights' types, with what is known in their place.
std::string TellTypes(const std::string& body, const std::vector<KnownLamp>& known);
}

#endif
