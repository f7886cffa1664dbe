// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A medium's fitted phase function as the mathematics takes it, and evaluated in double precision;
 * and the phase functions themselves, from the formulas that vtkParticipatingMedium documents.
 */

#ifndef AirlightTestPhase_h
#define AirlightTestPhase_h

#include "AirlightTestPhaseTable.h"
#include "AirlightTestTools.h"

#include "vtkDrainePhaseFunction.h"
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

// The function that a medium has, as it was when this was made.
class ReferencePhase
{
public:
  explicit ReferencePhase(vtkParticipatingMedium* medium)
    : Type(medium->GetPhaseFunction())
    , Anisotropy(medium->GetAnisotropy())
  {
    if (this->Type == vtkParticipatingMedium::TABULATED)
    {
      this->Table = ReferenceTable(medium->GetPhaseTable());
    }
    if (auto* draine = vtkDrainePhaseFunction::SafeDownCast(medium->GetPhaseFunctionObject()))
    {
      this->Anisotropy = draine->GetAnisotropy();
      this->Alpha = draine->GetAlpha();
    }
  }

  // From 1 - cosTheta and 1 + cosTheta.
  double operator()(double oneMinusCos, double onePlusCos) const
  {
    return this->Evaluate(oneMinusCos, onePlusCos);
  }

  template <typename T>
  T Evaluate(T oneMinusCos, T onePlusCos) const
  {
    const T pi = std::acos(T(-1));
    const T g = static_cast<T>(this->Anisotropy);
    const T mu = oneMinusCos < 1 ? 1 - oneMinusCos : onePlusCos - 1;
    // 1 - g mu, and 1 + g^2 - 2 g mu.
    const T schlick = g > 0 ? 1 - g + g * oneMinusCos : 1 + g - g * onePlusCos;
    const T henyey =
      g > 0 ? (1 - g) * (1 - g) + 2 * g * oneMinusCos : (1 + g) * (1 + g) - 2 * g * onePlusCos;
    switch (this->Type)
    {
      case vtkParticipatingMedium::HENYEY_GREENSTEIN:
        return (1 - g * g) / (4 * pi * henyey * std::sqrt(henyey));
      case vtkParticipatingMedium::RAYLEIGH:
        return 3 / (16 * pi) * (1 + mu * mu);
      case vtkParticipatingMedium::SCHLICK:
        return (1 - g * g) / (4 * pi * schlick * schlick);
      case vtkParticipatingMedium::CORNETTE_SHANKS:
        return 3 / (8 * pi) * (1 - g * g) / (2 + g * g) * (1 + mu * mu) /
          (henyey * std::sqrt(henyey));
      case vtkParticipatingMedium::OBJECT: // Draine's
      {
        const T a = static_cast<T>(this->Alpha);
        return (1 - g * g) * (1 + a * mu * mu) /
          (4 * pi * henyey * std::sqrt(henyey) * (1 + a * (1 + 2 * g * g) / 3));
      }
      case vtkParticipatingMedium::MIE_HAZY:
        return (1 + 9 * std::pow(onePlusCos / 2, T(8))) / (8 * pi);
      case vtkParticipatingMedium::MIE_MURKY:
        return (1 + 33 * std::pow(onePlusCos / 2, T(32))) / (8 * pi);
      case vtkParticipatingMedium::TABULATED:
        return this->Table.Evaluate(2 * std::atan2(std::sqrt(oneMinusCos), std::sqrt(onePlusCos)));
      default:
        return 1 / (4 * pi);
    }
  }

  // The angles of a table's rows, where the second derivative jumps: quadrature is cut there.
  const std::vector<long double>& GetKinks() const { return this->Table.GetAngles(); }

private:
  int Type;
  double Anisotropy;
  double Alpha = 0.0;
  ReferenceTable Table;
};

inline std::string DescribePhase(vtkParticipatingMedium* medium)
{
  static const char* const names[] = { "isotropic", "Henyey-Greenstein", "Rayleigh", "Schlick",
    "Cornette-Shanks", "Mie hazy", "Mie murky", "table", "object" };
  return Text(names[medium->GetPhaseFunction()], " ", medium->GetAnisotropy(), ", tolerance ",
    medium->GetPhaseTolerance(), ", poles ", medium->GetNumberOfPhasePoles());
}
}

#endif
