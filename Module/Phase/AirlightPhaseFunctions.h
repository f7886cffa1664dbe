// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Phase functions, in 1/sr, normalised to 1 over the sphere. They take s = tan(theta/2), in which
 * narrow forward and backward peaks keep all their digits, which cosTheta near 1 or -1 does not.
 */

#ifndef AirlightPhaseFunctions_h
#define AirlightPhaseFunctions_h

#include <glm/glm.hpp>

#include <functional>
#include <string>
#include <vector>

class vtkTable;

namespace airlight
{
using PhaseFunction = std::function<double(double)>; // of s

// Henyey and Greenstein 1941: (1 - g^2)/(4 pi (1 + g^2 - 2 g cos)^(3/2)).
double HenyeyGreenstein(double g, double s);

// Scattering by particles much smaller than the wavelength: 3/(16 pi) (1 + cos^2).
double Rayleigh(double s);

// Blasi, Le Saec and Schlick 1993: (1 - k^2)/(4 pi (1 - k cos)^2).
double Schlick(double k, double s);

// Cornette and Shanks 1992: 3/(8 pi) (1 - g^2)/(2 + g^2) (1 + cos^2)/(1 + g^2 - 2 g cos)^(3/2).
double CornetteShanks(double g, double s);

// Nishita, Miyawaki and Nakamae 1987: (1/2 + (n + 1)/2 ((1 + cos)/2)^n)/(4 pi); n is 8 in hazy and
// 32 in murky air.
double Mie(int n, double s);

// A measured function. Between the rows of its table the logarithm of the value is a cubic in the
// angle without overshoot (Fritsch and Carlson's 1980, with Brodlie's slopes): measured functions
// span decades, and corners would be the table's, not the particles'.
class PhaseTable
{
public:
  // From the first two columns: scattering angle in degrees, value in any unit. Scales the values
  // so that the function is normalised. Empty with a reason in `error` where the table is no good.
  static PhaseTable Read(vtkTable* table, std::string& error);

  bool IsEmpty() const { return this->Rows.empty(); }
  double Evaluate(double s) const;

  // (angle in radians, logarithm of the value, its slope, 0), as airlightPhaseTable() of
  // glsl/AirlightPhase.glsl reads them.
  const std::vector<glm::dvec4>& GetRows() const { return this->Rows; }

private:
  void FindSlopes();
  double EvaluateAt(double cosTheta) const;
  double Integrate() const;

  std::vector<glm::dvec4> Rows;
};
}

#endif
