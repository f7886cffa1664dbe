// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlight::Inscatter for every kind of light in every kind of region, density and phase
// function, against adaptive quadrature of the integrand of physics.md (AirlightTestMatrixReference.h); and
// what it says of directional lights in unbounded media, against exponentials written here.

#include "AirlightTestErrors.h"
#include "AirlightTestMatrix.h"
#include "AirlightTestMatrixReference.h"

#include "vtkAirlight.h"
#include "vtkNew.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr double inf = std::numeric_limits<double>::infinity();

// In the middle of the region, or apart from it: regions reach at most 7 from the origin.
glm::dvec3 PlacePoint(const MatrixCell& cell, bool inside, Random& random)
{
  if (cell.Region == vtkParticipatingMedium::UNBOUNDED)
  {
    return random.Uniform(0.0, 4.0) * RandomUnit(random);
  }
  return (inside ? random.Uniform(0.0, 0.9) : random.Uniform(8.0, 12.0)) * RandomUnit(random);
}

// Around the origin, which the region holds with all points up to 1 from it.
void PlaceMedium(vtkParticipatingMedium* medium, Random& random)
{
  medium->SetScattering(
    random.Uniform(0.02, 0.5), random.Uniform(0.02, 0.5), random.Uniform(0.02, 0.5));
  medium->SetAbsorption(random.Uniform(0.0, 0.2), 0.0, random.Uniform(0.0, 0.2));
  Box bounds;
  for (int i = 0; i < 6; ++i)
  {
    bounds[i] = (i % 2 ? 1.0 : -1.0) * random.Uniform(1.0, 4.0);
  }
  SetBox(medium, bounds);
  const glm::dvec3 centre = random.Uniform(0.0, 1.0) * RandomUnit(random);
  medium->SetCenter(&centre.x);
  medium->SetRadius(random.Uniform(2.0, 5.0));
  const glm::dvec3 up = RandomUnit(random);
  medium->SetUp(&up.x);
  medium->SetScaleHeight(random.Uniform(3.0, 6.0));
  medium->SetReferenceHeight(random.Uniform(-1.0, 1.0));
}

//------------------------------------------------------------------------------
// One light and one ray; the ray goes through the region, and a spot shines at it there.
void RunCell(const MatrixCell& cell, int i, vtkParticipatingMedium* medium, Random& random,
  Comparison& closed, Comparison& quadrature)
{
  vtkNew<vtkLight> light;
  PlaceMedium(medium, random);
  cell.Apply(medium, light);
  const glm::dvec3 position = PlacePoint(cell, i % 2 == 0, random);
  const glm::dvec3 origin = PlacePoint(cell, i / 2 % 2 == 0, random);
  const glm::dvec3 target = PlacePoint(cell, true, random);
  const glm::dvec3 direction = glm::normalize(target - origin);
  const double* up = medium->GetUp();
  glm::dvec3 focalPoint =
    origin + glm::distance(origin, target) * random.Uniform(0.8, 1.2) * direction;
  if (cell.Light == MATRIX_SUN)
  {
    // From above, at least 10 degrees high: from below it is dark, see TestUnboundedSun().
    const glm::dvec3 zenith(up[0], up[1], up[2]);
    glm::dvec3 towards = RandomUnit(random);
    while (glm::dot(towards, zenith) < 0.174)
    {
      towards = RandomUnit(random);
    }
    focalPoint = position - 2.0 * towards;
  }
  light->SetPosition(&position.x);
  light->SetFocalPoint(&focalPoint.x);
  light->SetColor(4.0, 7.0, 2.0);
  light->SetIntensity(1.5);
  if (cell.IsSpot())
  {
    light->SetConeAngle(random.Uniform(10.0, 60.0));
  }
  const double t0 = i % 3 == 2 ? random.Uniform(0.0, 2.0) : 0.0;
  const double t1 = i % 3 == 0 ? inf : t0 + random.Uniform(0.5, 15.0);

  const MatrixReference reference(medium, light);
  const bool isClosed = cell.HasClosedForm(reference.IsInside(position), medium);
  double rgb[3];
  vtkAirlight::Inscatter(medium, light, &origin.x, &direction.x, t0, t1, rgb);
  for (int k = 0; k < 3; ++k)
  {
    const double expected = reference.Airlight(k, origin, direction, t0, t1);
    const double limit = medium->GetPhaseErrorBound() + (isClosed ? 1e-9 : 1e-6);
    (isClosed ? closed : quadrature)
      .Add(std::abs(rgb[k] - expected), limit * expected + 1e-200, [&] {
        return Text(cell.Describe(), ", ray ", i, ", channel ", k, ": expected ", expected,
          ", got ", rgb[k], ", relative ", rgb[k] / expected - 1.0, "; sigmaT ",
          medium->GetExtinction()[k], ", light ", Text3(&position.x), " to ", Text3(&focalPoint.x),
          ", cone ", light->GetConeAngle(), ", origin ", Text3(&origin.x), ", direction ",
          Text3(&direction.x), ", [", t0, ", ", t1, "], box ", Text3(medium->GetBounds()), " ",
          Text3(medium->GetBounds() + 3), ", sphere ", Text3(medium->GetCenter()), " ",
          medium->GetRadius(), ", up ", Text3(up), ", scale ", medium->GetScaleHeight(),
          ", reference ", medium->GetReferenceHeight());
      });
  }
}

bool TestCells()
{
  Comparison closed("closed form, all cells");
  Comparison quadrature("quadrature, all cells");
  Random random(71);
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetPhaseTolerance(1e-6);
  // The table's fit misses that, and its bound says by how much.
  ErrorListener warnings(medium, vtkCommand::WarningEvent);
  int i = 0; // what there is of rays repeats after 12
  ForEachCell([&](const MatrixCell& cell) {
    for (const int end = i + 12; i < end; ++i)
    {
      RunCell(cell, i % 12, medium, random, closed, quadrature);
    }
  });
  return AllOk({ &closed, &quadrature });
}

//------------------------------------------------------------------------------
// Uniform and unbounded: the light arrives unattenuated from wherever it comes, which leaves
// sigmaS p E (1 - exp(-sigmaT t1))/sigmaT. Thinning out upwards: a light from below or from the
// horizon passes infinitely much, and there is none.
bool TestUnboundedSun()
{
  Comparison bright("directional light, unbounded uniform medium, relative");
  Comparison dark("directional light from below, unbounded height fog, absolute");
  Random random(72);
  for (int i = 0; i < 200; ++i)
  {
    vtkNew<vtkParticipatingMedium> medium;
    vtkNew<vtkLight> light;
    PlaceMedium(medium, random);
    MatrixCell cell{ MATRIX_SUN, vtkParticipatingMedium::UNBOUNDED, i % 2, MATRIX_ISOTROPIC };
    cell.Apply(medium, light);
    const glm::dvec3 origin = random.Uniform(0.0, 10.0) * RandomUnit(random);
    const glm::dvec3 direction = RandomUnit(random);
    const glm::dvec3 towards = RandomUnit(random);
    const double t1 = i % 3 == 0 ? inf : random.LogUniform(1e-2, 20.0);
    light->SetFocalPoint(0.0, 0.0, 0.0);
    light->SetPosition(&towards.x);
    if (i % 2 == 1)
    {
      const glm::dvec3 up =
        random.Uniform(0.1, 1.0) * glm::normalize(RandomUnit(random) * 0.3 - towards);
      medium->SetUp(&up.x);
    }
    double rgb[3];
    vtkAirlight::Inscatter(medium, light, &origin.x, &direction.x, 0.0, t1, rgb);
    for (int k = 0; k < 3; ++k)
    {
      const double sigmaT = medium->GetExtinction()[k];
      const double expected =
        medium->GetScattering()[k] / (4.0 * Pi) * Pi * -std::expm1(-sigmaT * t1) / sigmaT;
      const auto describe = [&] {
        return Text("towards ", Text3(&towards.x), ", up ", Text3(medium->GetUp()), ", direction ",
          Text3(&direction.x), ", t1 ", t1, ", sigmaT ", sigmaT, ": got ", rgb[k]);
      };
      if (i % 2 == 0)
      {
        bright.Add(std::abs(rgb[k] / expected - 1.0), 1e-9, describe);
      }
      else
      {
        dark.Add(std::abs(rgb[k]), 1e-300, describe);
      }
    }
  }
  return AllOk({ &bright, &dark });
}
}

//------------------------------------------------------------------------------
int TestAirlightMatrix(int, char*[])
{
  const bool cells = TestCells();
  return TestUnboundedSun() && cells ? EXIT_SUCCESS : EXIT_FAILURE;
}
