// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef ModelScene_h
#define ModelScene_h

#include "scene/Scene.h"

#include <string>

namespace airlight
{

/**
 * What a person chooses for a model on its own.
 */
struct ModelChoices
{
  /// One of GetLampPlaces(); empty: the lamps of the file, or else behind.
  std::string LightFrom;

  std::string Mood = "mist"; ///< one of GetMoodNames()
  bool KeepFacets = false;   ///< see ReadModel()
  std::string Up;            ///< see GetModelAxes()
  double Aspect = 4.0 / 3.0; ///< of the picture, width over height
};

/**
 * A model with what it needs to be seen, unless its file has a camera and lamps: a camera in front
 * of it, see SeeModel(), a lamp and a light on surfaces alone, see MakeModelLights(), and an
 * unbounded medium, see Mood.
 *
 * Throws UserError if the model cannot be read or has no extent.
 */
Scene MakeModelScene(const std::string& fileName, const ModelChoices& choices = {});

/**
 * ReadScene() for .json, MakeModelScene() for everything else.
 */
Scene ReadSceneOrModel(const std::string& fileName, const ModelChoices& choices = {});

}

#endif
