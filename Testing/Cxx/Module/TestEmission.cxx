// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Media that emit: layers against their closed form, also where nothing is absorbed, densities that
// fall with height against quadrature, infinite ones with an error; and the radiance of black bodies
// against the luminance of freezing platinum and published chromaticities.

#include "AirlightTestCheck.h"
#include "AirlightTestErrors.h"
#include "AirlightTestQuadrature.h"
#include "AirlightTestTools.h"

#include "vtkAirlight.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"

#include <cmath>
#include <cstdlib>

using namespace airlight_test;

namespace
{
const double Eye[3] = { 0.0, 0.0, 0.0 };

glm::dvec3 GetEmitted(vtkParticipatingMedium* medium, const glm::dvec3& direction, double length)
{
  glm::dvec3 radiance;
  Check(vtkAirlight::Ambient(medium, Eye, &direction.x, length, &radiance.x), "it is computed");
  return radiance;
}

void CheckNear(double value, double expected, double tolerance, const std::string& what)
{
  Check(std::abs(value - expected) <= tolerance * std::abs(expected),
    Text(what, ": ", value, ", not ", expected));
}

//------------------------------------------------------------------------------
void TestLayer()
{
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetRegionToBox();
  medium->SetBounds(-1, 1, -1, 1, -7, -2);
  medium->SetScattering(0.1, 0.0, 0.0);
  medium->SetAbsorption(0.3, 0.0, 2.0);
  medium->SetEmission(2.0, 3.0, 5.0);
  const glm::dvec3 seen = GetEmitted(medium, { 0, 0, -1 }, 100.0);
  CheckNear(seen.x, 2.0 * (1.0 - std::exp(-0.4 * 5.0)) / 0.4, 1e-12, "a layer");
  CheckNear(seen.y, 3.0 * 5.0, 1e-12, "a clear layer");
  CheckNear(seen.z, 5.0 * (1.0 - std::exp(-2.0 * 5.0)) / 2.0, 1e-12, "an opaque layer");
}

//------------------------------------------------------------------------------
// A box of fog that falls with height, in a channel that is clear and in one that is not.
void TestHeight()
{
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetRegionToBox();
  medium->SetBounds(-5, 5, -1, 20, -9, 9);
  medium->SetDensityToExponentialHeight();
  medium->SetScaleHeight(1.7);
  medium->SetAbsorption(0.4, 0.0, 3.0);
  medium->SetEmission(1.0, 1.0, 1.0);
  const glm::dvec3 direction = glm::normalize(glm::dvec3(0.1, 0.8, -0.5));
  const double length = 12.0;
  const glm::dvec3 seen = GetEmitted(medium, direction, length);
  for (int k = 0; k < 3; ++k)
  {
    const auto integrand = [&](double t) {
      const double rise = direction.y / 1.7;
      const double column = -std::expm1(-rise * t) / rise;
      return std::exp(-rise * t - medium->GetAbsorption()[k] * column);
    };
    const std::vector<long double> ends = { 0.0L, 1.0L, 3.0L, static_cast<long double>(length) };
    CheckNear(seen[k], Integrate(integrand, ends, 1e-12), 1e-9, Text("height, channel ", k));
  }
}

//------------------------------------------------------------------------------
void TestInfinite()
{
  vtkNew<vtkParticipatingMedium> medium;
  ErrorListener errors(medium);
  medium->SetAbsorption(0.5, 0.5, 0.0);
  medium->SetEmission(1.0, 1.0, 1.0);
  const glm::dvec3 seen = GetEmitted(medium, { 0, 0, -1 }, HUGE_VAL);
  Check(errors.Take() == 1 && errors.GetText().find("channel 2") != std::string::npos,
    "an error names the channel: " + errors.GetText());
  CheckNear(seen.x, 2.0, 1e-12, "emission over extinction");
  Check(seen.z == 0.0, "the channel without extinction emits nothing");
  GetEmitted(medium, { 0, 0, -1 }, 3.0);
  Check(errors.Take() == 0, "it is said once");
  medium->SetAbsorption(0.5, 0.5, 0.5);
  CheckNear(GetEmitted(medium, { 0, 0, -1 }, HUGE_VAL).z, 2.0, 1e-12, "with extinction it does");
  for (const double bad : { -1.0, std::nan(""), HUGE_VAL })
  {
    medium->SetEmission(1.0, bad, 1.0);
    Check(errors.Take() == 1 && medium->GetEmission()[1] == 1.0, "a bad value is rejected");
  }
}

//------------------------------------------------------------------------------
double GetLuminance(const glm::dvec3& rgb)
{
  return 683.0 * glm::dot(rgb, glm::dvec3(0.2126, 0.7152, 0.0722));
}

void TestBlackbody()
{
  glm::dvec3 rgb;
  // The candela's definition of 1946: platinum at its freezing point, 2045 K as known then and 2042 K
  // as known now, has 60 cd/cm^2.
  Check(vtkAirlight::BlackbodyRadiance(2042.0, &rgb.x), "platinum");
  CheckNear(GetLuminance(rgb), 60e4, 0.03, "luminance of freezing platinum");
  // D65's neighbour on the Planckian locus, 6504 K: x = 0.3135, y = 0.3237; lamps of CIE standard
  // illuminant A, 2856 K: x = 0.4476, y = 0.4075.
  const struct
  {
    double Temperature;
    double X;
    double Y;
  } expected[] = { { 6504.0, 0.3135, 0.3237 }, { 2856.0, 0.4476, 0.4075 } };
  for (const auto& body : expected)
  {
    vtkAirlight::BlackbodyRadiance(body.Temperature, &rgb.x);
    const glm::dmat3 toXYZ(glm::dvec3(0.4124, 0.2126, 0.0193), glm::dvec3(0.3576, 0.7152, 0.1192),
      glm::dvec3(0.1805, 0.0722, 0.9505));
    const glm::dvec3 xyz = toXYZ * rgb;
    const double sum = xyz.x + xyz.y + xyz.z;
    Check(std::abs(xyz.x / sum - body.X) < 0.005 && std::abs(xyz.y / sum - body.Y) < 0.005,
      Text("chromaticity of ", body.Temperature, " K: ", xyz.x / sum, " ", xyz.y / sum));
  }
  vtkAirlight::BlackbodyRadiance(300.0, &rgb.x);
  Check(rgb.x >= 0.0 && rgb.x < 1e-12, "a room is dark");
  Check(vtkAirlight::BlackbodyRadiance(1e6, &rgb.x) && std::isfinite(rgb.z), "a star is finite");
}
}

//------------------------------------------------------------------------------
int TestEmission(int, char*[])
{
  TestLayer();
  TestHeight();
  TestInfinite();
  TestBlackbody();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
