// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The buffer "ErrorBound": what it is made of, as the header of vtkAirlightPass says; that airlight
// is no further than that from brute force with the phase function itself (a fit 10 000 times as
// close); and that it is not idly large.

#include "AirlightTestBodies.h"
#include "AirlightTestCompareScene.h"
#include "AirlightTestTools.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
void SetPhase(vtkParticipatingMedium* medium, double anisotropy, double tolerance)
{
  medium->SetPhaseFunctionToHenyeyGreenstein();
  medium->SetAnisotropy(anisotropy);
  medium->SetPhaseTolerance(tolerance);
}

double Brightest(const glm::dvec3& colour) { return std::max({ colour.x, colour.y, colour.z }); }

//------------------------------------------------------------------------------
// |airlight - exact| against the bound. A bound that all errors stay a thousand times below would
// say nothing.
bool CompareHonesty(const std::string& name, Scene& scene)
{
  scene.Window->Render();
  vtkImageData* airlight = scene.GetBuffer("Airlight");
  vtkImageData* bound = scene.GetBuffer("ErrorBound");
  const double tolerance = scene.Medium->GetPhaseTolerance();
  scene.Medium->SetPhaseTolerance(1e-6);
  const double left = scene.Medium->GetPhaseErrorBound(); // of the reference itself
  Comparison honesty(name + ": error, of the bound");
  double largest = 0.0;
  int excluded = 0;
  Random random(3);
  const int rays = 1500;
  for (int i = 0; i < rays; ++i)
  {
    const int x = random.Index(scene.Width);
    const int y = random.Index(scene.Height);
    const Answer answer = scene.GetAnswer(x + 0.5, y + 0.5);
    if (IsUnstable(scene, x + 0.5, y + 0.5, answer, 1e-3 * answer.Unshadowed.x))
    {
      ++excluded;
      continue;
    }
    const double error = Brightest(glm::abs(GetColour(airlight, x, y) - answer.Airlight));
    const double limit = GetValue(bound, x, y);
    largest = std::max(largest, error / limit);
    honesty.Add(error, limit + left * Brightest(answer.Airlight), [&] {
      return Text("pixel ", x, " ", y, ": airlight ", answer.Airlight.x, ", bound ", limit);
    });
  }
  scene.Medium->SetPhaseTolerance(tolerance);
  std::cout << name << ": the largest error is " << largest << " of its bound\n";
  Check(excluded < MostExcluded * rays, name + ": too many rays are excluded");
  Check(largest > 1e-3, name + ": the bound is not idly large");
  return AllOk({ &honesty });
}

bool TestBound()
{
  bool ok = true;
  for (const double anisotropy : { -0.6, 0.76, 0.9 })
  {
    Scene scene;
    SetPhase(scene.Medium, anisotropy, 1e-2);
    scene.AddPointLight({ 2, 4, 3 });
    scene.AddPointLight({ -4, 2, 3 }, { 10, 30, 50 });
    AddClosedBodies(scene);
    ok = CompareHonesty(Text("two lights, g ", anisotropy), scene) && ok;
  }
  Scene falloff;
  SetPhase(falloff.Medium, 0.6, 1e-3);
  falloff.AddPointLight({ 2, 4, 3 })->SetAttenuationValues(0.0, 1.0, 0.0);
  AddClosedBodies(falloff);
  ok = CompareHonesty("1/r by quadrature", falloff) && ok;

  Scene sun;
  SetPhase(sun.Medium, 0.8, 1e-2);
  sun.Medium->SetRegionToBox();
  sun.Medium->SetBounds(-4, 3, -2, 5, -3, 4);
  sun.AddDirectionalLight({ 0.7, 2, 0.5 });
  AddClosedBodies(sun);
  return CompareHonesty("sun in a box", sun) && ok;
}

//------------------------------------------------------------------------------
// Small triangles, the shadows of some hundreds of which rays go through.
void AddLeaves(Scene& scene)
{
  scene.Pass->SetMaximumBoundariesPerPixel(VTK_DOUBLE_MAX); // shadow planes
  std::vector<Triangle> leaves;
  Random random(7);
  for (int i = 0; i < 700; ++i)
  {
    const glm::dvec3 at(
      random.Uniform(0.5, 2.0), random.Uniform(0.0, 2.0), random.Uniform(1.0, 2.0));
    leaves.push_back({ at, at + glm::dvec3(0.4, 0, 0.2), at + glm::dvec3(0, 0.1, 0.4) });
  }
  scene.Add(MakeSoup(leaves));
}

// From the parts: the lights' own airlight, with shadows and without, of which the integration has
// the relative error `integral`. Long lists take several draws, which must not count it twice.
bool CompareParts(
  const std::string& name, Scene& scene, const std::vector<double>& integral, double boundaries)
{
  scene.Window->Render();
  Buffers shadowed = scene.CopyBuffers();
  std::vector<vtkSmartPointer<vtkImageData>> single;
  for (size_t k = 0; k < integral.size(); ++k)
  {
    single.push_back(vtkSmartPointer<vtkImageData>::New());
    single.back()->DeepCopy(scene.GetBuffer(Text("Airlight:", k).c_str()));
  }
  scene.Pass->SetShadowTechniqueToNone();
  scene.Window->Render();
  const double phase = scene.Medium->GetPhaseErrorBound();
  Comparison parts(name + ": bound from its parts, relative");
  double most = 0.0;
  for (int y = 0; y < scene.Height; ++y)
  {
    for (int x = 0; x < scene.Width; ++x)
    {
      double expected = 0.0;
      glm::dvec3 ambient = GetColour(scene.GetBuffer("Airlight"), x, y);
      for (size_t k = 0; k < integral.size(); ++k)
      {
        const glm::dvec3 whole = GetColour(scene.GetBuffer(Text("Airlight:", k).c_str()), x, y);
        expected += phase * Brightest(GetColour(single[k], x, y)) + integral[k] * Brightest(whole);
        ambient -= whole;
      }
      expected += 1e-4 * Brightest(ambient);
      const double value = GetValue(shadowed["ErrorBound"], x, y);
      parts.Add(std::abs(value / expected - 1.0), 1e-4,
        [&] { return Text("pixel ", x, " ", y, ": ", value, ", expected ", expected); });
      most = std::max(most, GetValue(shadowed["BoundaryCount"], x, y));
    }
  }
  std::cout << name << ": up to " << most << " boundaries on a ray\n";
  Check(most > boundaries, name + ": some lists are long");
  return AllOk({ &parts });
}

bool TestParts()
{
  Scene scene;
  SetPhase(scene.Medium, 0.76, 1e-2);
  scene.Medium->SetAmbientRadiance(0.1, 0.3, 0.2);
  scene.AddPointLight({ 2, 4, 3 });
  vtkLight* falloff = scene.AddPointLight({ -4, 2, 3 });
  falloff->SetAttenuationValues(1.0, 0.0, 0.1);
  AddClosedBodies(scene);
  AddLeaves(scene);
  return CompareParts("two lights", scene, { 1e-4, 1e-3 }, 200.0);
}

// More boundaries than two draws read, of one light whose airlight is that of quadrature, the only
// kind that pauses between draws.
bool TestPauses()
{
  Scene scene;
  SetPhase(scene.Medium, 0.76, 1e-2);
  scene.AddPointLight({ 2, 4, 3 })->SetAttenuationValues(1.0, 0.0, 0.1);
  AddClosedBodies(scene);
  AddLeaves(scene);
  return CompareParts("lists read in several draws", scene, { 1e-3 }, 2.0 * 128.0);
}
}

//------------------------------------------------------------------------------
int TestErrorBound(int, char*[])
{
  const bool honest = TestBound();
  const bool parts = TestParts();
  const bool pauses = TestPauses();
  return honest && parts && pauses && Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
