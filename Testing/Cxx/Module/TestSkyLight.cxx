// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Skies of two colours and of spherical harmonics, scattered into rays by phase functions of all
// kinds, against quadrature over all directions; harmonics below 0; skies that are the same in all
// directions; and what a sky of two colours loses if it is given by harmonics to order 2.

#include "AirlightTestCheck.h"
#include "AirlightTestErrors.h"
#include "AirlightTestPhase.h"
#include "AirlightTestSingle.h"
#include "AirlightTestSky.h"
#include "AirlightTestTools.h"

#include "Medium/AirlightConvert.h"

#include "vtkAirlight.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkTable.h"

#include <cmath>
#include <cstdlib>

using namespace airlight_test;
using namespace airlight;

namespace
{
using Medium = vtkSmartPointer<vtkParticipatingMedium>;

Medium MakeMedium(int type, double g)
{
  auto medium = Medium::New();
  medium->SetScattering(0.3, 0.1, 0.2);
  medium->SetAbsorption(0.2, 0.0, 0.4);
  medium->SetPhaseFunction(type);
  medium->SetAnisotropy(g);
  return medium;
}

std::vector<Medium> MakeMedia()
{
  using M = vtkParticipatingMedium;
  std::vector<Medium> media = { MakeMedium(M::ISOTROPIC, 0.0), MakeMedium(M::RAYLEIGH, 0.0),
    MakeMedium(M::SCHLICK, 0.6), MakeMedium(M::CORNETTE_SHANKS, 0.8), MakeMedium(M::MIE_HAZY, 0.0),
    MakeMedium(M::MIE_MURKY, 0.0) };
  for (const double g : { -0.5, 0.3, 0.5, 0.85, 0.95 })
  {
    media.push_back(MakeMedium(M::HENYEY_GREENSTEIN, g));
  }
  for (const int kind : { TABLE_SMOOTH, TABLE_RAINBOW })
  {
    media.push_back(MakeMedium(M::TABULATED, 0.0));
    media.back()->SetPhaseTable(MakeTable(kind));
  }
  return media;
}

void SetSky(vtkParticipatingMedium* medium, const SkyRadiance& sky)
{
  medium->SetSkyRadiance(&sky.Above.x);
  medium->SetGroundRadiance(&sky.Below.x);
  medium->SetUp(&sky.Up.x);
  medium->SetSkyHarmonics(sky.Harmonics.data());
}

SkyRadiance MakeHarmonics(Random& random)
{
  SkyRadiance sky;
  for (int i = 0; i < 27; ++i)
  {
    sky.Harmonics[i] = i < 3 ? random.Uniform(4.0, 5.0) : random.Uniform(-0.3, 0.3);
  }
  return sky;
}

SkyRadiance MakeHemisphere(Random& random)
{
  SkyRadiance sky;
  sky.Above = glm::dvec3(1.0, 2.0, 3.0);
  sky.Below = glm::dvec3(0.2, 2.0, 0.0);
  sky.Up = RandomUnit(random);
  return sky;
}

// Ambient light of a ray that is long enough for some of it to be lost.
glm::dvec3 GetSeen(vtkParticipatingMedium* medium, const glm::dvec3& d)
{
  const double eye[3] = { 3.0, -2.0, 5.0 };
  glm::dvec3 seen;
  Check(vtkAirlight::Ambient(medium, eye, &d.x, 2.5, &seen.x), "it is computed");
  return seen;
}

// The share of ambient radiance that such a ray gets.
glm::dvec3 GetShare()
{
  const glm::dvec3 sigmaS(0.3, 0.1, 0.2);
  const glm::dvec3 sigmaT(0.5, 0.1, 0.6);
  return sigmaS / sigmaT * (1.0 - glm::exp(-2.5 * sigmaT));
}

// The differences from quadrature, relative to the sky's largest radiance.
void Compare(vtkParticipatingMedium* medium, const SkyRadiance& sky, const glm::dvec3& d,
  double limit, Comparison& doubles, Comparison& singles)
{
  SetSky(medium, sky);
  const bool table = medium->GetPhaseFunction() == vtkParticipatingMedium::TABULATED;
  const glm::dvec3 expected = ScatterSky(ReferencePhase(medium), sky, d, table ? 0.1 : 4.0);
  const glm::dvec3 seen = GetSeen(medium, d) / GetShare();
  const f64::AirlightMedia media = ConvertMedia({ medium }, glm::dvec3(0.0));
  const glm::vec3 single = f32::airlightAmbientRadiance(ToSingle(media).item[0], glm::vec3(d));
  for (int c = 0; c < 3; ++c)
  {
    const auto describe = [&] {
      return Text(DescribePhase(medium), ", direction ", d.x, " ", d.y, " ", d.z, ", channel ", c,
        ": ", seen[c], ", not ", expected[c]);
    };
    doubles.Add(std::abs(seen[c] - expected[c]) / 3.0, limit, describe);
    singles.Add(std::abs(single[c] - seen[c]) / 3.0, 1e-6, describe);
  }
}

//------------------------------------------------------------------------------
bool TestScattering()
{
  Random random(4201);
  Comparison harmonics("harmonics");
  Comparison hemispheres("two colours");
  Comparison singles("single precision");
  for (const Medium& medium : MakeMedia())
  {
    // What is expected of tables is good for 1e-7; a rainbow is narrower than the fit's
    // polynomials.
    const bool table = medium->GetPhaseFunction() == vtkParticipatingMedium::TABULATED;
    const bool rainbow = table && medium->GetPhaseTable()->GetNumberOfRows() > 91;
    for (int i = 0; i < 3; ++i)
    {
      Compare(
        medium, MakeHarmonics(random), RandomUnit(random), table ? 1e-6 : 1e-8, harmonics, singles);
    }
    const SkyRadiance sky = MakeHemisphere(random);
    const glm::dvec3 side = glm::normalize(glm::cross(sky.Up, RandomUnit(random)));
    for (const double height : { -1.0, -0.4, -0.05, 0.0, 0.01, 0.1, 0.7, 1.0 })
    {
      const glm::dvec3 d = height * sky.Up + std::sqrt(1.0 - height * height) * side;
      Compare(medium, sky, d, rainbow ? 1e-3 : 1e-5, hemispheres, singles);
    }
  }
  return AllOk({ &harmonics, &hemispheres, &singles });
}

//------------------------------------------------------------------------------
// All kinds together, with what arrives evenly; two media of different phase functions.
void TestSum()
{
  Random random(4202);
  SkyRadiance sky = MakeHarmonics(random);
  const SkyRadiance colours = MakeHemisphere(random);
  sky.Above = colours.Above;
  sky.Below = colours.Below;
  sky.Up = colours.Up;
  const Medium first = MakeMedium(vtkParticipatingMedium::HENYEY_GREENSTEIN, 0.7);
  const Medium second = MakeMedium(vtkParticipatingMedium::RAYLEIGH, 0.0);
  SetSky(first, sky);
  SetSky(second, sky);
  first->SetAmbientRadiance(0.5, 0.25, 0.125);
  first->SetEmission(0.01, 0.02, 0.03);
  const glm::dvec3 d = RandomUnit(random);
  const glm::dvec3 one = ScatterSky(ReferencePhase(first), sky, d) + glm::dvec3(0.5, 0.25, 0.125);
  const glm::dvec3 two = ScatterSky(ReferencePhase(second), sky, d);
  const glm::dvec3 sigmaS(0.3, 0.1, 0.2);
  const glm::dvec3 sigmaT(0.5, 0.1, 0.6);
  const glm::dvec3 expected = (sigmaS * (one + two) + glm::dvec3(0.01, 0.02, 0.03)) /
    (2.0 * sigmaT) * (1.0 - glm::exp(-2.5 * 2.0 * sigmaT));
  const glm::dvec3 seen =
    f64::airlightAmbient(ConvertMedia({ first, second }, glm::dvec3(0.0)), glm::dvec3(0.0), d, 2.5);
  Check(glm::length(seen - expected) < 1e-5 * glm::length(expected),
    Text("two media: ", seen.x, " ", seen.y, " ", seen.z, ", not ", expected.x, " ", expected.y,
      " ", expected.z));
}

//------------------------------------------------------------------------------
// Without a direction a sky is ambient light, bit for bit; below 0 it is dark.
void TestLimits()
{
  Random random(4203);
  const glm::dvec3 d = RandomUnit(random);
  const Medium medium = MakeMedium(vtkParticipatingMedium::HENYEY_GREENSTEIN, 0.8);
  medium->SetAmbientRadiance(0.5, 0.25, 2.0);
  const glm::dvec3 even = GetSeen(medium, d);
  medium->SetAmbientRadiance(0.0, 0.0, 0.0);
  medium->SetSkyRadiance(0.5, 0.25, 2.0);
  medium->SetGroundRadiance(0.5, 0.25, 2.0);
  Check(GetSeen(medium, d) == even, "two equal colours are ambient light");
  Check(ConvertMedia({ medium }, d).item[0].sky.on == 0, "and compile nothing else");
  medium->SetSkyRadiance(0.0, 0.0, 0.0);
  medium->SetGroundRadiance(0.0, 0.0, 0.0);
  double coefficients[27] = {};
  coefficients[0] = -1.0;
  medium->SetSkyHarmonics(coefficients);
  Check(GetSeen(medium, d) == glm::dvec3(0.0), "a negative mean is dark");
  coefficients[0] = 0.5;
  coefficients[9] = 2.0; // x, red
  medium->SetSkyHarmonics(coefficients);
  // 0.28209 0.5 - 0.8 0.48860 2 < 0 towards -x; forward scattering has the bright side there where
  // it is.
  Check(GetSeen(medium, { -1, 0, 0 }) == glm::dvec3(0.0), "a negative sum is dark");
  const double bright = (0.28209479 * 0.5 + 0.8 * 0.48860251 * 2.0) * GetShare().x;
  const double seen = GetSeen(medium, { 1, 0, 0 }).x;
  Check(std::abs(seen - bright) < 1e-7 * bright, Text("the bright side: ", seen, ", not ", bright));
  medium->ClearSkyHarmonics();
  Check(GetSeen(medium, { 1, 0, 0 }) == glm::dvec3(0.0), "there is no sky any more");
}

//------------------------------------------------------------------------------
void TestErrors()
{
  vtkNew<vtkParticipatingMedium> medium;
  ErrorListener errors(medium);
  medium->SetSkyRadiance(1.0, 2.0, 3.0);
  medium->SetGroundRadiance(0.1, 0.2, 0.3);
  double coefficients[27] = {};
  coefficients[3] = -0.5;
  medium->SetSkyHarmonics(coefficients);
  Check(errors.Take() == 0, "these are accepted");
  const vtkMTimeType time = medium->GetMTime();
  for (const double bad : { -1.0, std::nan(""), HUGE_VAL })
  {
    medium->SetSkyRadiance(1.0, bad, 3.0);
    Check(errors.Take() == 1 && errors.GetText().find("SkyRadiance (1, ") != std::string::npos,
      "a bad colour above is named: " + errors.GetText());
    medium->SetGroundRadiance(bad, 0.2, 0.3);
    Check(errors.Take() == 1 && errors.GetText().find("GroundRadiance (") != std::string::npos,
      "a bad colour below is named: " + errors.GetText());
  }
  for (const double bad : { 1e101, std::nan(""), HUGE_VAL })
  {
    coefficients[17] = bad;
    medium->SetSkyHarmonics(coefficients);
    Check(errors.Take() == 1 && errors.GetText().find(" at 17, ") != std::string::npos,
      "a bad coefficient is named: " + errors.GetText());
  }
  medium->GetSkyHarmonics(coefficients);
  Check(medium->GetMTime() == time && medium->GetSkyRadiance()[1] == 2.0 &&
      medium->GetGroundRadiance()[0] == 0.1 && coefficients[3] == -0.5 && coefficients[17] == 0.0,
    "the old values stay");
}

//------------------------------------------------------------------------------
// Multiple scattering takes its place, as it does that of ambient light.
void TestMultiple()
{
  const Medium medium = MakeMedium(vtkParticipatingMedium::ISOTROPIC, 0.0);
  medium->SetSkyRadiance(1.0, 2.0, 3.0);
  medium->MultipleScatteringOn();
  Check(GetSeen(medium, { 0, 1, 0 }) == glm::dvec3(0.0), "multiple scattering replaces the sky");
}

//------------------------------------------------------------------------------
// A sky of two colours by harmonics of order 1, all that it has to order 2. The errors that
// Documentation/accuracy.md states.
void TestOrders()
{
  const struct
  {
    double G;
    double Error;
  } expected[] = { { 0.0, 0.0 }, { 0.5, 0.046 }, { 0.85, 0.174 } };
  SkyRadiance sky;
  sky.Above = glm::dvec3(2.0);
  for (const auto& one : expected)
  {
    const HenyeyGreensteinPhase phase{ one.G };
    double largest = 0.0;
    for (int i = 0; i <= 40; ++i)
    {
      const double y = i / 40.0;
      const glm::dvec3 d(std::sqrt(1.0 - y * y), y, 0.0);
      const double byOrders = 1.0 + one.G * 1.5 * y;
      largest = std::max(largest, std::abs(ScatterSky(phase, sky, d).x - byOrders));
    }
    std::cout << "g " << one.G << ": harmonics to order 2 are off by " << 0.5 * largest
              << " of the sky above\n";
    Check(std::abs(0.5 * largest - one.Error) < 0.001, Text("the error for g = ", one.G));
  }
}
}

//------------------------------------------------------------------------------
int TestSkyLight(int, char*[])
{
  const bool ok = TestScattering();
  TestSum();
  TestLimits();
  TestErrors();
  TestMultiple();
  TestOrders();
  return ok && Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
