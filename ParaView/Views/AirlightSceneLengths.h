// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The lengths of a medium's region and density, each of which follows the bounds of a scene while
 * it is 0.
 */

#ifndef AirlightSceneLengths_h
#define AirlightSceneLengths_h

#include "vtkBoundingBox.h"

class vtkParticipatingMedium;

namespace airlight
{
class SceneLengths
{
public:
  vtkBoundingBox Scene; // not valid: unknown

  double Bounds[6] = {};
  double Center[3] = {}; // also follows the scene while the radius does
  double Radius = 0.0;
  double Height = 0.0;
  double ScaleHeight = 0.0;
  double ReferenceHeight = 0.0; // also follows the scene while the scale height does

  // Sets them. The medium's axis and direction up are those that heights are measured along.
  void Apply(vtkParticipatingMedium* medium) const;

private:
  bool IsKnown() const;
  void ApplyBox(vtkParticipatingMedium* medium) const;
  void ApplyRound(vtkParticipatingMedium* medium) const;
  void ApplyHeights(vtkParticipatingMedium* medium) const;
};
}

#endif
