// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Mood_h
#define Mood_h

#include "formats/Vector3.h"

#include <string>
#include <vector>

class vtkParticipatingMedium;

namespace airlight
{

/**
 * The air and the colours of a model's scene, by a name that people use. Lengths are in diagonals
 * of the box around the model.
 */
struct Mood
{
  const char* Name;
  double Visibility;  ///< diagonals
  double Anisotropy;  ///< Henyey-Greenstein
  Vector3 Albedo;     ///< scattering by extinction
  Vector3 Extinction; ///< relative, scaled to Visibility
  Vector3 Ambient;    ///< radiance, which is the colour of the distance
  Vector3 LampColour;
  double LampRadiance; ///< of a white surface in the middle that faces the lamp, in clear air
  Vector3 FillColour;
  double FillRadiance; ///< the same for the light that falls on surfaces alone
  double Brightness;   ///< factor of the automatic exposure
};

/**
 * Throws UserError that lists the names if there is no such mood.
 */
const Mood& GetMood(const std::string& name);

std::vector<std::string> GetMoodNames();

/**
 * Fill all space with the mood's air, and its ambient radiance times a factor.
 */
void SetMood(vtkParticipatingMedium* medium, const Mood& mood, double diagonal, double ambient);

}

#endif
