// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Phase functions by name, as scene files and command lines have them.
 */

#ifndef PhaseName_h
#define PhaseName_h

#include <string>

class vtkParticipatingMedium;

namespace airlight
{

constexpr double MaximumAnisotropy = 0.99;

struct PhaseName
{
  const char* Name;
  int Type;              ///< vtkParticipatingMedium::PhaseFunctionType
  const char* Parameter; ///< what its anisotropy is called, null if it has none
};

/**
 * Null for an unknown name. The tabulated function is not among them: it needs a file.
 */
const PhaseName* FindPhaseName(const std::string& name);

/**
 * All names, separated by commas.
 */
std::string ListPhaseNames();

/**
 * Let the medium scatter by this function; the anisotropy counts where it has a parameter.
 */
void SetPhase(vtkParticipatingMedium* medium, const PhaseName& phase, double anisotropy);

}

#endif
