// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A medium's fitted phase function as the mathematics takes it, and evaluated in double precision.
 */

#ifndef AirlightTestPhase_h
#define AirlightTestPhase_h

#include "vtkParticipatingMedium.h"

#include <algorithm>
#include <cmath>

namespace airlight_test
{
// AirlightPhase of one of the precisions.
template <typename Phase>
Phase GetPhase(vtkParticipatingMedium* medium)
{
  Phase phase{};
  phase.poleCount = medium->GetNumberOfPhasePoles();
  phase.order = 1;
  for (int k = 0; k < phase.poleCount; ++k)
  {
    double pole[4];
    medium->GetPhasePole(k, pole);
    for (int i = 0; i < 4; ++i)
    {
      phase.pole[k][i] = pole[i];
    }
    phase.order = std::max(phase.order, pole[3] != 0.0 ? 3 : pole[2] != 0.0 ? 2 : 1);
  }
  double power[2];
  medium->GetPhasePower(power);
  phase.power.x = power[0];
  phase.power.y = power[1];
  return phase;
}

// sum_k c1/q + c2/q^2 + c3/q^3, q = s^2 + b^2, times 1 + s^2, from 1 - cosTheta and 1 + cosTheta:
// s^2 = (1 - cos)/(1 + cos); and factor ((1 + cos)/2)^exponent.
template <typename Phase>
double FittedPhase(const Phase& fit, double oneMinusCos, double onePlusCos)
{
  double p = static_cast<double>(fit.power.x) * std::pow(0.5 * onePlusCos, fit.power.y);
  for (int k = 0; k < fit.poleCount; ++k)
  {
    const double b = fit.pole[k].x;
    const double r = onePlusCos / (oneMinusCos + b * b * onePlusCos); // 1/q
    const double share = 1.0 / (oneMinusCos + b * b * onePlusCos);
    p += 2.0 * share * (fit.pole[k].y + r * (fit.pole[k].z + r * fit.pole[k].w));
  }
  return p;
}
}

#endif
