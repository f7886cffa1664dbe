// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkDrainePhaseFunction: its values against Draine's formula in extended precision, its integral
// and mean cosine by quadrature, its limits, its fits and tables against the bounds that they
// claim, airlight against adaptive quadrature (AirlightTestMatrixReference.h), and bad parameters.

#include "AirlightTestCheck.h"
#include "AirlightTestErrors.h"
#include "AirlightTestMatrix.h"
#include "AirlightTestMatrixReference.h"
#include "AirlightTestPhase.h"
#include "AirlightTestQuadrature.h"
#include "Integration/AirlightMath.h"
#include "Phase/AirlightPhaseShape.h"

#include "vtkAirlight.h"
#include "vtkCornetteShanksPhaseFunction.h"
#include "vtkDrainePhaseFunction.h"
#include "vtkHenyeyGreensteinPhaseFunction.h"
#include "vtkNew.h"

#include <cstdlib>
#include <limits>

using namespace airlight_test;
using Medium = vtkParticipatingMedium;

namespace
{
constexpr double inf = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

const double Anisotropies[] = { -0.99, -0.8, -0.3, 0.0, 0.01, 0.5, 0.76, 0.9, 0.95, 0.99 };
const double Alphas[] = { 0.0, 0.01, 0.3, 1.0, 5.0, 30.0, 100.0 };

// Draine 2003, of 1 - mu and 1 + mu, which keep the digits of narrow peaks.
long double Formula(long double g, long double alpha, long double below, long double above)
{
  const long double pi = std::acos(-1.0L);
  const long double mu = below < above ? 1.0L - below : above - 1.0L;
  const long double d =
    g > 0.0L ? (1 - g) * (1 - g) + 2 * g * below : (1 + g) * (1 + g) - 2 * g * above;
  return (1 - g * g) / (4 * pi) / (1 + alpha * (1 + 2 * g * g) / 3) * (1 + alpha * mu * mu) /
    (d * std::sqrt(d));
}

// Henyey and Greenstein's moments of mu and mu^3 are g and (3 g + 2 g^3)/5.
double MeanCosine(double g, double alpha)
{
  return (g + alpha * (3.0 * g + 2.0 * g * g * g) / 5.0) /
    (1.0 + alpha * (1.0 + 2.0 * g * g) / 3.0);
}

// 2 pi times the integral of p(mu) mu^power over [-1, 1], on panels graded towards both ends.
double IntegrateOverSphere(vtkPhaseFunction* function, int power)
{
  std::vector<long double> ends = { -1.0L, 0.0L, 1.0L };
  for (long double distance = 0.3L; distance > 1e-9L; distance *= 0.3L)
  {
    ends.push_back(1.0L - distance);
    ends.push_back(distance - 1.0L);
  }
  std::sort(ends.begin(), ends.end());
  double sum = 0.0;
  for (size_t i = 1; i < ends.size(); ++i)
  {
    // Each panel's integrand has one sign.
    const double sign = power == 1 && ends[i] <= 0.0L ? -1.0 : 1.0;
    sum += sign *
      Integrate(
        [&](double mu) { return function->Evaluate(mu) * (power == 0 ? 1.0 : std::abs(mu)); },
        { ends[i - 1], ends[i] }, 1e-13);
  }
  return 2.0 * Pi * sum;
}

//------------------------------------------------------------------------------
bool TestValues()
{
  Comparison values("value, relative");
  Comparison integrals("integral over the sphere");
  Comparison means("mean cosine");
  vtkNew<vtkDrainePhaseFunction> function;
  for (const double g : Anisotropies)
  {
    for (const double alpha : Alphas)
    {
      function->SetAnisotropy(g);
      function->SetAlpha(alpha);
      const std::string name = Text("g ", g, ", alpha ", alpha);
      for (double mu = -1.0; mu <= 1.0; mu += 1.0 / 64.0)
      {
        const long double expected = Formula(g, alpha, 1.0L - mu, 1.0L + mu);
        const double value = function->Evaluate(mu);
        values.Add(static_cast<double>(std::abs(value / expected - 1.0L)), 1e-12,
          [&] { return Text(name, ", cosine ", mu, ": ", value, ", expected ", expected); });
      }
      const double integral = IntegrateOverSphere(function, 0);
      integrals.Add(std::abs(integral - 1.0), 1e-9, [&] { return Text(name, ": ", integral); });
      const double mean = IntegrateOverSphere(function, 1);
      means.Add(std::abs(mean - MeanCosine(g, alpha)), 1e-9,
        [&] { return Text(name, ": ", mean, ", expected ", MeanCosine(g, alpha)); });
    }
  }
  return AllOk({ &values, &integrals, &means });
}

//------------------------------------------------------------------------------
bool TestLimits()
{
  Comparison limits("limits, relative");
  vtkNew<vtkDrainePhaseFunction> draine;
  vtkNew<vtkHenyeyGreensteinPhaseFunction> henyey;
  vtkNew<vtkCornetteShanksPhaseFunction> cornette;
  for (const double g : Anisotropies)
  {
    draine->SetAnisotropy(g);
    henyey->SetAnisotropy(g);
    cornette->SetAnisotropy(g);
    for (double mu = -1.0; mu <= 1.0; mu += 1.0 / 128.0)
    {
      const auto describe = [&] { return Text("g ", g, ", cosine ", mu); };
      draine->SetAlpha(0.0);
      limits.Add(std::abs(draine->Evaluate(mu) / henyey->Evaluate(mu) - 1.0), 1e-15, describe);
      draine->SetAlpha(1.0);
      limits.Add(std::abs(draine->Evaluate(mu) / cornette->Evaluate(mu) - 1.0), 2e-15, describe);
      if (g == 0.0)
      {
        const double rayleigh = 3.0 / (16.0 * Pi) * (1.0 + mu * mu);
        limits.Add(std::abs(draine->Evaluate(mu) / rayleigh - 1.0), 2e-15, describe);
      }
    }
  }
  // And the fit at alpha = 0 is that of Henyey and Greenstein's.
  draine->SetAnisotropy(0.7);
  draine->SetAlpha(0.0);
  henyey->SetAnisotropy(0.7);
  vtkNew<Medium> medium;
  vtkNew<Medium> other;
  medium->SetPhaseFunction(draine);
  other->SetPhaseFunction(henyey);
  limits.Add(
    medium->GetPhaseErrorBound() - other->GetPhaseErrorBound(), 0.0, [] { return "bound"; });
  return AllOk({ &limits });
}

//------------------------------------------------------------------------------
// The bound is honest, whether the function is fitted or has a table, and within the tolerance.
void CompareShape(vtkDrainePhaseFunction* function, double tolerance, Comparison& within,
  Comparison& honest, int& tables)
{
  vtkNew<Medium> medium;
  medium->SetPhaseTolerance(tolerance);
  medium->SetPhaseFunction(function);
  const double g = function->GetAnisotropy();
  const double alpha = function->GetAlpha();
  const double bound = medium->GetPhaseErrorBound();
  const std::string name = Text("g ", g, ", alpha ", alpha, ", tolerance ", tolerance, ", ",
    medium->GetNumberOfPhasePoles(), " poles");
  // At alpha = 0 it is Henyey and Greenstein's fit, whose bound may exceed the tolerance.
  if (alpha > 0.0 || std::abs(g) <= 0.95)
  {
    within.Add(bound, tolerance, [&] { return name; });
  }
  const auto shape = medium->GetPhaseShape();
  tables += shape->Rows.empty() ? 0 : 1;
  Check(shape->Rows.empty() || std::abs(g) > 0.9, name + ": fitted");
  airlight::f64::AirlightPhase table{};
  table.data = shape->Rows.data();
  table.rows = static_cast<int>(shape->Rows.size());
  const auto fit = GetPhase<airlight::f64::AirlightPhase>(medium);
  for (int k = 0; k <= 4000; ++k)
  {
    const double mu = std::cos(Pi * k / 4000.0);
    const double below = 2.0 * std::pow(std::sin(0.5 * Pi * k / 4000.0), 2);
    const double above = 2.0 * std::pow(std::cos(0.5 * Pi * k / 4000.0), 2);
    const auto expected = static_cast<double>(Formula(g, alpha, below, above));
    const double value = shape->Rows.empty() ? FittedPhase(fit, below, above)
                                             : airlight::f64::airlightPhase(table, mu);
    honest.Add(std::abs(value / expected - 1.0), bound + 1e-12,
      [&] { return Text(name, ", cosine ", mu, ": ", value, ", expected ", expected); });
  }
}

bool TestShapes()
{
  Comparison within("bound, of the tolerance");
  Comparison honest("distance from the function, of the bound");
  int tables = 0;
  vtkNew<vtkDrainePhaseFunction> function;
  for (const double g : { -0.8, 0.0, 0.3, 0.6, 0.9, 0.99 })
  {
    for (const double alpha : { 0.0, 0.3, 1.0, 5.0, 40.0 })
    {
      function->SetAnisotropy(g);
      function->SetAlpha(alpha);
      CompareShape(function, 1e-3, within, honest, tables);
    }
  }
  function->SetAnisotropy(0.6);
  function->SetAlpha(2.0);
  CompareShape(function, 1e-2, within, honest, tables);
  CompareShape(function, 1e-4, within, honest, tables);
  Check(tables > 0 && tables < 10, Text("of 32 functions, ", tables, " have tables"));
  return AllOk({ &within, &honest });
}

//------------------------------------------------------------------------------
// In unbounded media, boxes, spheres and cylinders around the origin.
bool TestAirlight()
{
  Comparison closed("closed form");
  Comparison quadrature("quadrature");
  Random random(61);
  vtkNew<Medium> medium;
  medium->SetBounds(-2.0, 2.5, -1.5, 2.0, -2.5, 1.8);
  medium->SetRadius(2.0);
  medium->SetHeight(3.0);
  medium->SetScaleHeight(4.0);
  const int regions[] = { Medium::UNBOUNDED, Medium::BOX, Medium::SPHERE, Medium::CYLINDER };
  for (const int phase : { MATRIX_DRAINE, MATRIX_FOG })
  {
    for (int i = 0; i < 120; ++i)
    {
      const MatrixCell cell{ i % MATRIX_LIGHTS, regions[i / 5 % 4], i / 20 % 2, phase };
      vtkNew<vtkLight> light;
      cell.Apply(medium, light);
      medium->SetScattering(random.Uniform(0.05, 0.4), 0.2, random.Uniform(0.05, 0.4));
      medium->SetAbsorption(0.0, random.Uniform(0.0, 0.2), 0.05);
      const glm::dvec3 position =
        (random.Index(2) ? random.Uniform(0.0, 1.2) : random.Uniform(4.0, 6.0)) *
        RandomUnit(random);
      const glm::dvec3 origin = random.Uniform(0.0, 5.0) * RandomUnit(random);
      const glm::dvec3 direction =
        glm::normalize(random.Uniform(0.0, 1.2) * RandomUnit(random) - origin);
      glm::dvec3 focalPoint = origin + random.Uniform(1.0, 6.0) * direction;
      if (cell.Light == MATRIX_SUN)
      {
        focalPoint = position + glm::normalize(RandomUnit(random) - glm::dvec3(0.0, 1.5, 0.0));
      }
      light->SetPosition(&position.x);
      light->SetFocalPoint(&focalPoint.x);
      light->SetColor(4.0, 7.0, 2.0);
      const double t1 = i % 3 == 0 ? inf : random.Uniform(1.0, 12.0);
      const MatrixReference reference(medium, light);
      const bool isClosed = cell.HasClosedForm(reference.IsInside(position), medium);
      double rgb[3];
      vtkAirlight::Inscatter(medium, light, &origin.x, &direction.x, 0.0, t1, rgb);
      for (int k = 0; k < 3; ++k)
      {
        const double expected = reference.Airlight(k, origin, direction, 0.0, t1);
        const double limit = medium->GetPhaseErrorBound() + (isClosed ? 1e-9 : 1e-6);
        (isClosed ? closed : quadrature)
          .Add(std::abs(rgb[k] - expected), limit * expected + 1e-200, [&] {
            return Text(cell.Describe(), ", ray ", i, ", channel ", k, ": expected ", expected,
              ", got ", rgb[k], "; light ", Text3(&position.x), " to ", Text3(&focalPoint.x),
              ", origin ", Text3(&origin.x), ", direction ", Text3(&direction.x), ", t1 ", t1);
          });
      }
    }
  }
  return AllOk({ &closed, &quadrature });
}

//------------------------------------------------------------------------------
void TestErrors()
{
  vtkNew<vtkDrainePhaseFunction> function;
  ErrorListener errors(function);
  Check(function->GetAlpha() == 1.0 && function->GetAnisotropy() == 0.0, "the defaults");
  function->SetAlpha(2.5);
  function->SetAnisotropy(0.25);
  const vtkMTimeType time = function->GetMTime();
  const auto check = [&](const char* property, double bad, const char* range, const char* stays) {
    Check(errors.Take() == 1, Text("one error for ", property, " ", bad));
    for (const std::string& part : { Text(property, " ", bad), std::string(range),
           Text("it stays ", stays), std::string("vtkDrainePhaseFunction") })
    {
      Check(errors.GetText().find(part) != std::string::npos,
        Text("\"", part, "\" in ", errors.GetText()));
    }
  };
  for (const double bad : { -0.5, 100.5, inf, -inf, nan })
  {
    function->SetAlpha(bad);
    check("Alpha", bad, "[0, 100]", "2.5");
    function->SetParameter("alpha", bad);
    check("alpha", bad, "[0, 100]", "2.5");
  }
  for (const double bad : { 1.0, -1.25, inf, nan })
  {
    function->SetAnisotropy(bad);
    check("Anisotropy", bad, "[-0.99, 0.99]", "0.25");
  }
  Check(function->GetMTime() == time && function->GetAlpha() == 2.5 &&
      function->GetParameter("alpha") == 2.5,
    "nothing has changed");
}
}

//------------------------------------------------------------------------------
int TestDrainePhaseFunction(int, char*[])
{
  TestErrors();
  const bool values = TestValues();
  const bool limits = TestLimits();
  const bool shapes = TestShapes();
  return TestAirlight() && values && limits && shapes && Failures == 0 ? EXIT_SUCCESS
                                                                       : EXIT_FAILURE;
}
