// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * What a medium's phase function makes of light from a sky, made when it is first needed and again
 * after a change of the phase function.
 */

#ifndef AirlightMediumSky_h
#define AirlightMediumSky_h

#include "Phase/AirlightHemisphereFit.h"
#include "vtkType.h"

#include <functional>
#include <optional>
#include <vector>

namespace airlight
{
class MediumSky
{
public:
  // `phaseTime` grows with every change of the phase function.
  void Update(vtkMTimeType phaseTime, const std::function<double(double)>& phaseFunction,
    bool needsHemisphere);

  // The Legendre moment of order 0, 1 or 2.
  double GetMoment(int order) const { return this->Moments[order]; }

  // Of an update that needed it.
  const HemisphereFit& GetHemisphere() const { return *this->Hemisphere; }

private:
  std::vector<double> Moments;
  std::optional<HemisphereFit> Hemisphere;
  vtkMTimeType PhaseTime = 0;
};
}

#endif
