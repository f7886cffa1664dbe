// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Where a medium is and how its density varies, as values of command-line options. Each function
 * changes the medium, or throws UserError, which names the option, the text and the form that was
 * expected.
 */

#ifndef MediumText_h
#define MediumText_h

#include <string>

class vtkParticipatingMedium;

namespace airlight
{

/// "NAME" or, with the function's parameters, "NAME:G" or "NAME:G:ALPHA": the phase function.
void ParsePhase(const std::string& option, const std::string& text, vtkParticipatingMedium* medium);

/// "xmin,xmax,ymin,ymax,zmin,zmax": the region, each minimum at most its maximum.
void ParseBox(const std::string& option, const std::string& text, vtkParticipatingMedium* medium);

/// "x,y,z:R": the region, of centre and radius.
void ParseSphere(
  const std::string& option, const std::string& text, vtkParticipatingMedium* medium);

/// "x,y,z:R:H[:ax,ay,az]": the region, a cylinder of centre, radius, height and axis (0,1,0).
void ParseCylinder(
  const std::string& option, const std::string& text, vtkParticipatingMedium* medium);

/// "REFERENCE:SCALE[:ux,uy,uz]": exponential density of reference height, scale height and
/// direction up (0,1,0).
void ParseHeightFog(
  const std::string& option, const std::string& text, vtkParticipatingMedium* medium);

}

#endif
