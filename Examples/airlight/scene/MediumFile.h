// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#ifndef MediumFile_h
#define MediumFile_h

#include <string>

class vtkParticipatingMedium;

namespace airlight
{

/**
 * Let a medium scatter by a measured phase function: a text file of lines "angle,value", the
 * scattering angle in degrees, ascending from 0 (forward) to 180, and a value above 0 in any unit.
 * Its first line may be a heading, empty lines are skipped. Throws UserError with file and reason.
 */
void ReadPhaseTable(const std::string& fileName, vtkParticipatingMedium* medium);

/**
 * Let a medium fill a closed mesh, of any file that ReadMesh() reads. Throws UserError with file
 * and reason. Guard the first reading of a file with CheckModelFile().
 */
void ReadMediumSurface(const std::string& fileName, vtkParticipatingMedium* medium);

}

#endif
