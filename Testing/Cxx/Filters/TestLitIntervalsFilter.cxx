// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkLitIntervalsFilter: the numbers of a bent line by quadrature, causes that are known by
// construction, shadows of closed meshes without cracks, the same output in one thread and in many.

#include "AirlightTestCheck.h"
#include "AirlightTestLines.h"
#include "AirlightTestQuadrature.h"

#include "vtkCallbackCommand.h"
#include "vtkPlaneSource.h"
#include "vtkSMPTools.h"
#include "vtkSphereSource.h"

#include <cstdlib>
#include <functional>

using namespace airlight_test;

namespace
{
//------------------------------------------------------------------------------
// An isotropic medium without borders: exp(-sigma_t (s + r)) sigma_s/(4 pi) I/r^2, with s counted
// along the line.
double GetAirlight(vtkParticipatingMedium* medium, const Polyline& line, const glm::dvec3& position,
  double intensity, int channel)
{
  const double extinction = medium->GetExtinction()[channel];
  double sum = 0.0;
  double before = 0.0;
  for (size_t i = 1; i < line.size(); ++i)
  {
    const double length = glm::distance(line[i], line[i - 1]);
    if (length > 0.0)
    {
      const glm::dvec3 direction = (line[i] - line[i - 1]) / length;
      const double foot = glm::dot(position - line[i - 1], direction);
      const double h = glm::length(position - line[i - 1] - foot * direction);
      sum += std::exp(-extinction * before) *
        IsotropicAirlight(
          [](double r, double) { return 1.0 / (r * r); }, extinction, foot, h, 0.0, length);
    }
    before += length;
  }
  return medium->GetScattering()[channel] * intensity * sum;
}

void TestBends()
{
  const Polyline line = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 }, { 2, 1, 0 }, { 2, 1, 2 } };
  Run run({ line });
  const auto lights = MakeLights();
  run.Filter->SetLight(lights[0].second);
  run.Filter->Update();
  if (!Check(run.Count() == 1, "an unshadowed polyline is lit in one part"))
  {
    return;
  }
  const glm::dvec3 position(GetPosition(lights[0].second));
  glm::dvec3 expected(4.0, 3.0, 2.0);
  for (int c = 0; c < 3; ++c)
  {
    expected[c] = GetAirlight(run.Medium, line, position, expected[c], c);
  }
  Comparison comparison("airlight of a polyline, relative");
  const double length = 3.0 + std::sqrt(2.0);
  Check(run.Filter->GetOutput()->GetCell(0)->GetNumberOfPoints() == 4, "bends are points");
  Check(std::abs(run.Get("Length", 0) - length) < 1e-12, "length of a polyline");
  Check(run.Get("StartCause", 0) == 0 && run.Get("EndCause", 0) == 0, "lit from end to end");
  for (int c = 0; c < 3; ++c)
  {
    const double depth = run.Medium->GetExtinction()[c] * length;
    comparison.Add(std::abs(run.Get("Airlight", 0, c) / expected[c] - 1.0), 1e-8,
      [&] { return Text(run.Get("Airlight", 0, c), ", by quadrature ", expected[c]); });
    Check(std::abs(run.Get("OpticalDepth", 0, c) - depth) < 1e-12, "its optical depth");
    Check(std::abs(run.Get("Transmittance", 0, c) - std::exp(-depth)) < 1e-12, "transmittance");
  }
  Check(comparison.Report(), "airlight of a polyline");
}

//------------------------------------------------------------------------------
// A square at y = 1 below a lamp at y = 2 shades |x| < 1 at y = 0; the medium ends at x = 3. The
// second line comes from the dark, bends at x = -1/2 and leaves into the light.
void TestCauses()
{
  vtkNew<vtkPlaneSource> other; // far away
  other->SetCenter(0.0, -50.0, 0.0);
  vtkNew<vtkPlaneSource> square;
  square->SetOrigin(-0.5, 1.0, -0.5);
  square->SetPoint1(0.5, 1.0, -0.5);
  square->SetPoint2(-0.5, 1.0, 0.5);
  Run run({ { { -2, 0, 0.1 }, { 4, 0, 0.1 } },
    { { 0.2, 0.0, 0.1 }, { -0.5, 0, 0.1 }, { -2.0, 0, 0.1 } } });
  run.Medium->SetRegionToBox();
  run.Medium->SetBounds(-10.0, 3.0, -10.0, 10.0, -10.0, 10.0);
  const auto lights = MakeLights();
  lights[0].second->SetPosition(0.0, 2.0, 0.0);
  run.Filter->SetLight(lights[0].second);
  run.Filter->AddInputConnection(1, other->GetOutputPort());
  run.Filter->AddInputConnection(1, square->GetOutputPort());
  run.Filter->Update();
  const double expected[3][8] = { // start, end, causes, occluders, cells
    { 0.0, 1.0, 0, 1, -1, 1, -1, 0 }, { 3.0, 5.0, 1, 2, 1, -1, 0, -1 },
    { 1.2, 2.2, 1, 0, 1, -1, 0, -1 }
  };
  const char* const names[8] = { "Start", "End", "StartCause", "EndCause", "StartOccluder",
    "EndOccluder", "StartOccluderCell", "EndOccluderCell" };
  Check(run.Count() == 3, Text("lit parts beside a square: ", run.Count()));
  for (int i = 0; i < 3 && run.Count() == 3; ++i)
  {
    for (int k = 0; k < 8; ++k)
    {
      Check(std::abs(run.Get(names[k], i) - expected[i][k]) < 1e-12,
        Text("part ", i, ": ", names[k], " is ", run.Get(names[k], i)));
    }
  }
  // In the cone from y = 2 of half angle 45 degrees, |x| < 2 at y = 0 and z = 0.
  Run spot({ { { -3, 0, 0 }, { 3, 0, 0 } } });
  const vtkSmartPointer<vtkLight> lamp = lights[3].second;
  lamp->SetPosition(0.0, 2.0, 0.0);
  lamp->SetFocalPoint(0.0, 0.0, 0.0);
  lamp->SetConeAngle(45.0);
  spot.Filter->SetLight(lamp);
  spot.Filter->Update();
  Check(spot.Count() == 1 && std::abs(spot.Get("Start", 0) - 1.0) < 1e-12 &&
      spot.Get("StartCause", 0) == vtkLitIntervalsFilter::CONE &&
      spot.Get("EndCause", 0) == vtkLitIntervalsFilter::CONE,
    "a spot's cone");
  // Into the shadow in the bend itself: the line turns upwards into the square.
  Run bend({ { { -2, 1, 0 }, { -0.5, 1, 0 }, { 0.1, 0.8, 0 } } });
  bend.Filter->SetLight(lights[0].second);
  bend.Filter->AddInputConnection(1, square->GetOutputPort());
  bend.Filter->Update();
  Check(bend.Count() == 1 && bend.Get("EndCause", 0) == vtkLitIntervalsFilter::BEND,
    "dark behind a bend");
}

//------------------------------------------------------------------------------
// A closed mesh: its shadow has no cracks.
void TestMesh()
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(100);
  sphere->SetPhiResolution(100);
  Random random(3);
  std::vector<Polyline> lines;
  for (int i = 0; i < 2000; ++i)
  {
    const glm::dvec3 side = 2.0 * glm::normalize(RandomPoint(random, 1.0));
    lines.push_back({ side, -side });
  }
  for (const auto& light : MakeLights())
  {
    Run run(lines);
    light.second->SetConeAngle(90.0);
    if (light.second->GetPosition()[1] < 1.0)
    {
      continue; // inside the sphere
    }
    run.Filter->SetLight(light.second);
    run.Filter->AddInputConnection(1, sphere->GetOutputPort());
    run.Filter->Update();
    std::vector<int> parts(lines.size(), 0);
    for (vtkIdType i = 0; i < run.Count(); ++i)
    {
      ++parts[static_cast<size_t>(run.Get("SourceCell", i))];
    }
    Check(*std::max_element(parts.begin(), parts.end()) == 2 &&
        *std::min_element(parts.begin(), parts.end()) == 1,
      light.first + ": one shadow of a sphere");
  }
}

//------------------------------------------------------------------------------
bool AreSame(vtkPolyData* a, vtkPolyData* b)
{
  bool same = a->GetNumberOfCells() == b->GetNumberOfCells() &&
    a->GetCellData()->GetNumberOfArrays() == 13 && b->GetCellData()->GetNumberOfArrays() == 13;
  for (int k = 0; same && k < a->GetCellData()->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* x = a->GetCellData()->GetArray(k);
    vtkDataArray* y = b->GetCellData()->GetArray(k);
    for (vtkIdType i = 0; same && i < x->GetNumberOfTuples(); ++i)
    {
      for (int c = 0; c < x->GetNumberOfComponents(); ++c)
      {
        same = same && x->GetComponent(i, c) == y->GetComponent(i, c);
      }
    }
  }
  return same;
}

void TestThreadsAndUpdates()
{
  Random random(5);
  std::vector<Triangle> triangles;
  const vtkSmartPointer<vtkPolyData> soup = MakeRandomSoup(random, 200, triangles);
  std::vector<Polyline> lines;
  for (int i = 0; i < 3000; ++i)
  {
    lines.push_back(
      { RandomPoint(random, 1.5), RandomPoint(random, 1.5), RandomPoint(random, 1.5) });
  }
  const auto lights = MakeLights();
  Run run(lines);
  run.Filter->SetLight(lights[0].second);
  run.Filter->AddOccluderData(soup);
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(1);
  run.Filter->Update();
  vtkNew<vtkPolyData> one;
  one->DeepCopy(run.Filter->GetOutput());
  vtkSMPTools::Initialize(4);
  run.Filter->Modified();
  run.Filter->Update();
  Check(AreSame(one, run.Filter->GetOutput()), "the same output of one and four threads");

  const auto changes = [&](const char* what, const std::function<void()>& change) {
    run.Filter->Update();
    vtkNew<vtkPolyData> before;
    before->DeepCopy(run.Filter->GetOutput());
    change();
    run.Filter->Update();
    Check(!AreSame(before, run.Filter->GetOutput()), Text("a change of ", what, " is seen"));
  };
  changes("the light", [&] { lights[0].second->SetPosition(0.4, 1.5, 0.0); });
  changes("the medium", [&] { run.Medium->SetAbsorption(0.5, 0.5, 0.5); });
  changes("the occluders", [&] { run.Filter->RemoveAllOccluders(); });
  lights[0].second->SwitchOff();
  run.Filter->Update();
  Check(run.Count() == 0, "a light that is switched off lights nothing");
  lights[0].second->SwitchOn();

  int events = 0;
  vtkNew<vtkCallbackCommand> abort;
  abort->SetClientData(&events);
  abort->SetCallback([](vtkObject* filter, unsigned long, void* count, void*) {
    if (++*static_cast<int*>(count) == 5)
    {
      vtkAlgorithm::SafeDownCast(filter)->SetAbortExecute(1);
    }
  });
  run.Filter->AddObserver(vtkCommand::ProgressEvent, abort);
  run.Filter->Modified();
  run.Filter->Update();
  Check(events >= 5 && events < 10, Text("progress events until the abortion: ", events));
  Check(run.Count() == 0, "no output after an abortion");
}
}

//------------------------------------------------------------------------------
int TestLitIntervalsFilter(int, char*[])
{
  TestBends();
  TestCauses();
  TestMesh();
  TestThreadsAndUpdates();
  std::cout << Failures << " failures\n";
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
