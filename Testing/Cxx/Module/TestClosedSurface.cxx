// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlight for media inside closed surfaces of boxes, convex and not: transmittance against the
// intervals of the boxes, airlight against quadrature over them, for every kind of light at places
// inside, outside and in cavities; a mesh of a box against the region of a box; and that the
// orientation of polygons is of no account. Rays that graze are in TestClosedSurfaceRays.cxx.

#include "AirlightTestMatrix.h"
#include "AirlightTestMatrixReference.h"
#include "AirlightTestSurfaces.h"

#include "vtkAirlight.h"

#include <cstdlib>
#include <functional>

using namespace airlight_test;

namespace
{
constexpr double Far = 1e18;

// What varies from ray to ray. Positions are within the solids' bounds or beyond, by turns.
struct Setting
{
  glm::dvec3 Origin;
  glm::dvec3 Direction;
  double T1;
};

class Experiment
{
public:
  Setting Place(const MatrixCell& cell, const Solid& solid, int i)
  {
    cell.Apply(this->Medium, this->Light);
    this->Medium->SetScattering(this->Numbers.Uniform(0.05, 0.4), 0.2, 0.1);
    this->Medium->SetAbsorption(0.0, this->Numbers.Uniform(0.0, 0.2), 0.05);
    this->Medium->SetBounds(solid.Boxes.front().data());
    this->Medium->SetSurface(solid.Surface);
    this->Medium->SetScaleHeight(3.0);
    this->Medium->SetUp(0.2, 1.0, -0.1);
    const glm::dvec3 lamp = this->Point(i % 2 == 0);
    const glm::dvec3 target = this->Point(true);
    this->Light->SetPosition(&lamp.x);
    this->Light->SetFocalPoint(&target.x);
    this->Light->SetColor(4.0, 7.0, 2.0);
    Setting setting;
    setting.Origin = this->Point(i / 2 % 2 == 0);
    setting.Direction = glm::normalize(this->Point(true) - setting.Origin);
    setting.T1 = i % 3 == 0 ? this->Numbers.Uniform(1.0, 8.0) : Far;
    return setting;
  }

  Random Numbers{ 91 };
  vtkNew<vtkParticipatingMedium> Medium;
  vtkNew<vtkLight> Light;

private:
  glm::dvec3 Point(bool near)
  {
    Random& random = this->Numbers;
    return near
      ? glm::dvec3(random.Uniform(-1.9, 2.4), random.Uniform(-1.4, 1.9), random.Uniform(-2.0, 1.7))
      : random.Uniform(5.0, 9.0) * RandomUnit(random);
  }
};

struct Numbers
{
  double Airlight[3];
  double Transmittance[3];
};

Numbers Measure(Experiment& experiment, const Setting& setting)
{
  Numbers numbers;
  const glm::dvec3 end = setting.Origin + std::min(setting.T1, 1e3) * setting.Direction;
  vtkAirlight::Inscatter(experiment.Medium, experiment.Light, &setting.Origin.x,
    &setting.Direction.x, 0.0, setting.T1, numbers.Airlight);
  vtkAirlight::Transmittance(experiment.Medium, &setting.Origin.x, &end.x, numbers.Transmittance);
  return numbers;
}

std::string Describe(
  const MatrixCell& cell, const std::string& name, Experiment& experiment, const Setting& setting)
{
  return Text(name, ", ", cell.Describe(), ", light ", Text3(experiment.Light->GetPosition()),
    " to ", Text3(experiment.Light->GetFocalPoint()), ", origin ", Text3(&setting.Origin.x),
    ", direction ", Text3(&setting.Direction.x), ", t1 ", setting.T1, ", sigmaT ",
    Text3(experiment.Medium->GetExtinction()));
}

// Relative to the expected number, of which 1e-290 is none.
void Compare(Comparison& comparison, double got, double expected, double limit,
  const std::function<std::string()>& describe)
{
  comparison.Add(std::abs(got - expected), limit * std::abs(expected) + 1e-290, [&] {
    return Text(describe(), ": expected ", expected, ", got ", got, ", relative ",
      std::abs(got / expected - 1.0));
  });
}

//------------------------------------------------------------------------------
// vtkAirlight states 1e-6 where it takes quadrature, and 1e-9 in closed form, which the region of a
// box has and the mesh has not.
bool TestBoxMesh()
{
  Comparison airlight("mesh of a box and region of a box, airlight");
  Comparison transmittance("mesh of a box and region of a box, transmittance");
  Experiment experiment;
  const Solid box = MakeSolids().front();
  for (int i = 0; i < 240; ++i)
  {
    MatrixCell cell{ i % MATRIX_LIGHTS, vtkParticipatingMedium::SURFACE, i / 5 % 2,
      i / 10 % 2 == 0 ? MATRIX_ISOTROPIC : MATRIX_FORWARD };
    const Setting setting = experiment.Place(cell, box, i / MATRIX_LIGHTS);
    const Numbers mesh = Measure(experiment, setting);
    experiment.Medium->SetRegionToBox();
    const Numbers region = Measure(experiment, setting);
    for (int k = 0; k < 3; ++k)
    {
      const auto describe = [&] { return Describe(cell, box.Name, experiment, setting); };
      // The closed form's phase function is the fit itself, and so is what quadrature takes.
      Compare(airlight, mesh.Airlight[k], region.Airlight[k], 1e-6, describe);
      Compare(transmittance, mesh.Transmittance[k], region.Transmittance[k], 1e-12, describe);
    }
  }
  return AllOk({ &airlight, &transmittance });
}

//------------------------------------------------------------------------------
bool TestSolids()
{
  Comparison airlight("closed surfaces, airlight by quadrature");
  Comparison transmittance("closed surfaces, transmittance of uniform media");
  Experiment experiment;
  for (const Solid& solid : MakeSolids())
  {
    for (int i = 0; i < 120; ++i)
    {
      MatrixCell cell{ i % MATRIX_LIGHTS, vtkParticipatingMedium::SURFACE, i / 5 % 3 == 2,
        MATRIX_ISOTROPIC };
      const Setting setting = experiment.Place(cell, solid, i / MATRIX_LIGHTS);
      const Numbers numbers = Measure(experiment, setting);
      MatrixReference reference(experiment.Medium, experiment.Light);
      reference.SetBoxes(solid.Boxes);
      const double length =
        LengthInside(solid.Boxes, setting.Origin, setting.Direction, std::min(setting.T1, 1e3));
      for (int k = 0; k < 3; ++k)
      {
        const auto describe = [&] { return Describe(cell, solid.Name, experiment, setting); };
        const double expected =
          reference.Airlight(k, setting.Origin, setting.Direction, 0.0, setting.T1);
        Compare(airlight, numbers.Airlight[k], expected, 1e-6, describe);
        if (cell.Density == vtkParticipatingMedium::UNIFORM)
        {
          Compare(transmittance, numbers.Transmittance[k],
            std::exp(-experiment.Medium->GetExtinction()[k] * length), 1e-12, describe);
        }
      }
    }
  }
  return AllOk({ &airlight, &transmittance });
}

//------------------------------------------------------------------------------
// All polygons turned over, or a random half of them; sums run in other orders, no more.
bool TestOrientation()
{
  Comparison airlight("polygons turned over, airlight");
  Comparison transmittance("polygons turned over, transmittance");
  Experiment experiment;
  for (const Solid& solid : MakeSolids())
  {
    for (int i = 0; i < 30; ++i)
    {
      MatrixCell cell{ i % MATRIX_LIGHTS, vtkParticipatingMedium::SURFACE, 0, MATRIX_ISOTROPIC };
      const Setting setting = experiment.Place(cell, solid, i / MATRIX_LIGHTS);
      const Numbers straight = Measure(experiment, setting);
      experiment.Medium->SetSurface(Flip(solid.Surface, i % 2 == 0, experiment.Numbers));
      const Numbers turned = Measure(experiment, setting);
      for (int k = 0; k < 3; ++k)
      {
        const auto describe = [&] { return Describe(cell, solid.Name, experiment, setting); };
        Compare(airlight, turned.Airlight[k], straight.Airlight[k], 1e-10, describe);
        Compare(transmittance, turned.Transmittance[k], straight.Transmittance[k], 1e-13, describe);
      }
    }
  }
  return AllOk({ &airlight, &transmittance });
}
}

//------------------------------------------------------------------------------
int TestClosedSurface(int, char*[])
{
  bool ok = TestBoxMesh();
  ok = TestSolids() && ok;
  ok = TestOrientation() && ok;
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
