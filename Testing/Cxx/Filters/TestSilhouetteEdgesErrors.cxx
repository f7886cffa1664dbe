// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkSilhouetteEdgesFilter and vtkShadowPlanesFilter with bad input.

#include "AirlightTestCheck.h"
#include "AirlightTestErrors.h"
#include "AirlightTestSoup.h"

#include "vtkCubeSource.h"
#include "vtkExecutive.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLineSource.h"
#include "vtkShadowPlanesFilter.h"

#include <cstdlib>
#include <limits>
#include <string>

using namespace airlight_test;

namespace
{
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

vtkSmartPointer<vtkPolyData> MakeCube()
{
  vtkNew<vtkCubeSource> cube;
  cube->Update();
  return cube->GetOutput();
}

// Both filters, as what is tested here is common to them.
class Filters
{
public:
  Filters()
    : All{ vtkSmartPointer<vtkSilhouetteEdgesFilter>::New(),
      vtkSmartPointer<vtkShadowPlanesFilter>::New() }
  {
  }

  // Calls set(filter); the update is to give one error that contains the text, and nothing else;
  // none where the text is empty.
  template <typename Function>
  void Update(const std::string& name, const std::string& text, const Function& set)
  {
    for (vtkSilhouetteEdgesFilter* filter : this->All)
    {
      ErrorListener errors(filter);
      set(filter);
      filter->Update();
      const int count = errors.Take();
      Check(count == (text.empty() ? 0 : 1) && errors.GetText().find(text) != std::string::npos,
        Text(name, ": ", count, " errors, ", errors.GetText()));
      const bool empty = filter->GetOutput()->GetNumberOfCells() == 0;
      Check(empty == !text.empty() || name.find("empty") != std::string::npos,
        name + ": the output is empty where there was an error");
    }
  }

  vtkSmartPointer<vtkSilhouetteEdgesFilter> All[2];
};

//------------------------------------------------------------------------------
void TestLights()
{
  Filters filters;
  const vtkSmartPointer<vtkPolyData> cube = MakeCube();
  vtkNew<vtkLight> light;
  light->PositionalOn();
  filters.Update("a good light", "", [&](vtkSilhouetteEdgesFilter* f) {
    f->SetInputData(cube);
    f->SetLightPosition(3, 4, 5);
  });
  filters.Update("a light that is not a number", "nan", [&](vtkSilhouetteEdgesFilter* f) {
    light->SetPosition(1, nan, 2);
    f->SetLight(light);
  });
  filters.Update("an infinite light", "inf",
    [&](vtkSilhouetteEdgesFilter*) { light->SetPosition(infinity, 0, 0); });
  filters.Update("a light without direction", "(1, 2, 3)", [&](vtkSilhouetteEdgesFilter*) {
    light->PositionalOff();
    light->SetPosition(1, 2, 3);
    light->SetFocalPoint(1, 2, 3);
  });
  // A corner, the middle of an edge, a place on a face, all of the cube; and one just off it.
  const glm::dvec3 places[3] = { { 0.5, 0.5, 0.5 }, { 0.5, 0.0, 0.5 }, { 0.1, 0.5, -1.0 / 3.0 } };
  for (const glm::dvec3& p : places)
  {
    filters.Update("a light on the mesh", "lies on", [&](vtkSilhouetteEdgesFilter* f) {
      f->SetLight(nullptr);
      f->SetLightPosition(&p.x);
    });
  }
  filters.Update("a light just off the mesh", "",
    [&](vtkSilhouetteEdgesFilter* f) { f->SetLightPosition(0.1, 0.5 + 1e-9, 0.2); });
}

//------------------------------------------------------------------------------
void TestRefused()
{
  vtkNew<vtkShadowPlanesFilter> filter;
  filter->SetLightPosition(1, 2, 3);
  filter->SetLightDirection(4, 5, 6);
  filter->SetFarDistance(7);
  filter->SetBounds(1, 2, 3, 4, 5, 6);
  const vtkMTimeType time = filter->GetMTime();
  ErrorListener errors(filter);
  for (const double bad : { nan, infinity, -1e101 })
  {
    filter->SetLightPosition(1, bad, 3);
    filter->SetLightDirection(bad, 0, 0);
    filter->SetFarDistance(bad);
    filter->SetBounds(0, 1, bad, 1, 0, 1);
    Check(errors.Take() == 4, Text(bad, " is refused everywhere"));
  }
  filter->SetFarDistance(-1.0);
  Check(errors.Take() == 1, "a negative distance is refused");
  Check(filter->GetMTime() == time && filter->GetLightPosition()[1] == 2.0 &&
      filter->GetLightDirection()[0] == 4.0 && filter->GetFarDistance() == 7.0 &&
      filter->GetBounds()[2] == 3.0,
    "refused values leave the old ones");
  filter->SetInputData(MakeCube());
  filter->SetExtentToBounds();
  filter->SetBounds(0, 1, 1, 1, 0, 1);
  filter->Update();
  Check(errors.Take() == 1 && errors.GetText().find("(0, 1, 1, 1, 0, 1)") != std::string::npos &&
      filter->GetOutput()->GetNumberOfCells() == 0,
    "bounds without volume: " + errors.GetText());
}

//------------------------------------------------------------------------------
void TestMeshes()
{
  Filters filters;
  vtkNew<vtkPolyData> nothing;
  filters.Update("empty input", "", [&](vtkSilhouetteEdgesFilter* f) {
    f->SetLightPosition(3, 4, 5);
    f->SetInputData(nothing);
  });
  vtkNew<vtkLineSource> line;
  line->Update();
  filters.Update("lines only", "no triangle",
    [&](vtkSilhouetteEdgesFilter* f) { f->SetInputData(line->GetOutput()); });
  const glm::dvec3 a(0, 0, 0);
  const glm::dvec3 b(1, 0, 0);
  const glm::dvec3 c(0, 0, 1);
  const glm::dvec3 undefined(nan, 0, 0);
  const glm::dvec3 remote(infinity, 0, 0);
  TriangleList triangles{ { a, a, b } };
  triangles.push_back({ a, undefined, b });
  triangles.push_back({ remote, b, c });
  const vtkSmartPointer<vtkPolyData> bad = MakeSoup(triangles);
  filters.Update(
    "no good triangle", "no triangle", [&](vtkSilhouetteEdgesFilter* f) { f->SetInputData(bad); });
  triangles.push_back({ a, b, c });
  const vtkSmartPointer<vtkPolyData> mixed = MakeSoup(triangles);
  filters.Update(
    "one good triangle", "", [&](vtkSilhouetteEdgesFilter* f) { f->SetInputData(mixed); });
  for (vtkSilhouetteEdgesFilter* f : filters.All)
  {
    Check(f->GetOutput()->GetNumberOfCells() == 3, "of bad and good triangles the good one casts");
  }
  // Points that do not exist.
  vtkNew<vtkPolyData> broken;
  broken->DeepCopy(mixed);
  const vtkIdType ids[3] = { 0, 1000000, -5 };
  broken->GetPolys()->InsertNextCell(3, ids);
  filters.Update(
    "points that do not exist", "", [&](vtkSilhouetteEdgesFilter* f) { f->SetInputData(broken); });
  // In one line: nothing to see, and nothing wrong with it.
  const vtkSmartPointer<vtkPolyData> flat = MakeSoup(TriangleList{ { a, b, 3.0 * b } });
  filters.Update(
    "empty silhouette", "", [&](vtkSilhouetteEdgesFilter* f) { f->SetInputData(flat); });
  // Other data do not pass the port.
  vtkNew<vtkImageData> image;
  for (vtkSilhouetteEdgesFilter* f : filters.All)
  {
    f->SetInputDataObject(image);
    ErrorListener errors(f->GetExecutive());
    f->Update();
    Check(errors.Take() > 0, "an image is refused");
  }
}
}

//------------------------------------------------------------------------------
int TestSilhouetteEdgesErrors(int, char*[])
{
  TestLights();
  TestRefused();
  TestMeshes();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
