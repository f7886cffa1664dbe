// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ModelLights_h
#define ModelLights_h

#include "scene/ModelView.h"
#include "scene/Mood.h"
#include "scene/Scene.h"

#include <string>
#include <vector>

namespace airlight
{

/**
 * The names of places for a model's lamp.
 */
std::vector<std::string> GetLampPlaces();

/**
 * A lamp at a place around a model, whose shafts come through the air, and a light that falls on
 * surfaces alone, so that the side that is seen is readable. What the place changes in the mood are
 * the factors `Ambient` and `Brightness`: the beams of some stand before the dark.
 */
struct ModelLights
{
  std::vector<LightSource> Lights;
  double Ambient = 1.0;
  double Brightness = 1.0;
};

/**
 * Places are in multiples of `reach` from the middle, which is that of a diagonal of the box around
 * the model or less. Throws UserError for an unknown place.
 */
ModelLights MakeModelLights(
  const std::string& name, const Mood& mood, const Vector3& center, double reach);

/**
 * The lamps of a file, in proportion: a white surface in the middle that faces all of them would
 * have the mood's radiance in clear air, whatever the file's units. Lamps near the middle count as
 * if they were farther away, or there would be nothing left for the others. Empty if none of them
 * reaches the middle.
 */
std::vector<LightSource> ScaleLights(
  const std::vector<LightSource>& lights, const Mood& mood, const Vector3& center, double diagonal);

/**
 * Turn what was placed for a model with y up and its front towards z about the middle to another.
 */
void TurnLights(std::vector<LightSource>& lights, const Vector3& center, const ModelAxes& axes);

}

#endif
