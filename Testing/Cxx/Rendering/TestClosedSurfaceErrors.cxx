// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Surfaces that close nothing: an error that says what and what to do, once, and a medium that is
// ignored, in numbers and in pictures, until it is fixed. Surfaces that only look bad are taken.

#include "AirlightTestCheck.h"
#include "AirlightTestErrors.h"
#include "AirlightTestPixelScene.h"
#include "AirlightTestSurfaces.h"

#include "vtkAirlight.h"
#include "vtkLight.h"

#include <cstdlib>
#include <iostream>
#include <limits>

using namespace airlight_test;

namespace
{
const Box Unit{ -1.0, 1.0, -1.0, 1.0, -1.0, 1.0 };

// The unit box without one of its six faces.
Mesh MakeOpenBox()
{
  const Mesh box = MakeBoxMesh(Unit);
  box->BuildCells();
  box->DeleteCell(5);
  box->RemoveDeletedCells();
  return box;
}

Mesh MakeLines()
{
  const Mesh mesh = MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 } }, {});
  vtkNew<vtkCellArray> lines;
  const vtkIdType ids[] = { 0, 1 };
  lines->InsertNextCell(2, ids);
  mesh->SetLines(lines);
  mesh->SetVerts(lines);
  return mesh;
}

Mesh MakeBoxWithPoint(double x)
{
  const Mesh mesh = MakeBoxMesh(Unit);
  mesh->GetPoints()->SetPoint(3, x, 1.0, 1.0);
  return mesh;
}

// exp(-2 sigmaT) through the middle of the unit box.
double Pass(vtkParticipatingMedium* medium)
{
  const double a[3] = { -5.0, 0.1, 0.2 };
  const double b[3] = { 5.0, 0.1, 0.2 };
  double rgb[3];
  vtkAirlight::Transmittance(medium, a, b, rgb);
  return rgb[0];
}

constexpr double SigmaT = 0.3;
const double ThroughBox = std::exp(-2.0 * SigmaT);

void SetFog(vtkParticipatingMedium* medium, vtkPolyData* surface)
{
  medium->SetScattering(SigmaT, SigmaT, SigmaT);
  medium->SetAbsorption(0.0, 0.0, 0.0);
  medium->SetRegionToSurface();
  medium->SetSurface(surface);
}

bool IsNear(double value, double expected) { return std::abs(value - expected) < 1e-6; }

//------------------------------------------------------------------------------
// Refused when set: one error with these words, and the old surface stays in use.
void CheckRefused(const std::string& name, vtkPolyData* bad, const std::vector<std::string>& words)
{
  vtkNew<vtkParticipatingMedium> medium;
  const Mesh box = MakeBoxMesh(Unit);
  SetFog(medium, box);
  ErrorListener errors(medium);
  medium->SetSurface(bad);
  Check(errors.Take() == 1, name + ": one error when set");
  std::cout << name << ": " << errors.GetText() << "\n";
  for (const std::string& word : words)
  {
    Check(errors.GetText().find(word) != std::string::npos, name + ": the error says " + word);
  }
  Check(errors.GetText().find("vtkParticipatingMedium (0x") != std::string::npos,
    name + ": the error names the object");
  Check(medium->GetSurface() == box, name + ": the old surface stays");
  Check(IsNear(Pass(medium), ThroughBox), name + ": the old surface is in use");
  Check(errors.Take() == 0, name + ": no error when used");
}

void TestRefused()
{
  constexpr double inf = std::numeric_limits<double>::infinity();
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  vtkNew<vtkPolyData> empty;
  CheckRefused("empty", empty, { "no polygons", "update its source" });
  CheckRefused("lines and vertices", MakeLines(), { "no polygons" });
  CheckRefused("open box", MakeOpenBox(), { "not closed", "4 edges", "vtkFillHolesFilter" });
  CheckRefused("point at NaN", MakeBoxWithPoint(nan), { "point 3", "nan", "finite", "fix" });
  CheckRefused("point at infinity", MakeBoxWithPoint(inf), { "point 3", "inf", "finite" });
  CheckRefused("point at 1e20", MakeBoxWithPoint(1e20), { "point 3", "1e+20", "1e15" });
  CheckRefused("one polygon twice",
    MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 } }, { { 0, 1, 2 }, { 0, 2, 1 } }), { "0" });
  // Closed, and flat: two squares in one plane whose diagonals differ.
  CheckRefused("flat body",
    MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 } },
      { { 0, 1, 2 }, { 0, 2, 3 }, { 0, 1, 3 }, { 1, 2, 3 } }),
    { "encloses nothing" });
  CheckRefused("polygons without area",
    MakeMesh({ { 0, 0, 0 }, { 1, 0, 0 } }, { { 0, 1, 1 }, { 0, 0, 1 } }), { "triangles" });
}

//------------------------------------------------------------------------------
// Taken without an error.
void CheckTaken(const std::string& name, vtkPolyData* mesh)
{
  vtkNew<vtkParticipatingMedium> medium;
  ErrorListener errors(medium);
  SetFog(medium, mesh);
  Check(IsNear(Pass(medium), ThroughBox), name + ": is the unit box");
  Check(errors.Take() == 0, name + ": no error");
}

void TestTaken()
{
  // A vtkCubeSource has four points at each corner's place but one, which are one corner.
  CheckTaken("corners several times", MakeBoxMesh(Unit));
  const Mesh degenerate = MakeBoxMesh(Unit);
  const vtkIdType twice[] = { 0, 1, 1 };
  const vtkIdType thrice[] = { 2, 2, 2 };
  degenerate->GetPolys()->InsertNextCell(3, twice);
  degenerate->GetPolys()->InsertNextCell(3, thrice);
  CheckTaken("triangles of one or two corners", degenerate);
  // The same box twice and once more: an odd number of crossings.
  CheckTaken(
    "the same box thrice", Join({ MakeBoxMesh(Unit), MakeBoxMesh(Unit), MakeBoxMesh(Unit) }));
  // Halves that share a face, which bounds nothing: with the same corners.
  CheckTaken("halves that share a face",
    Join({ MakeBoxMesh({ -1.0, 0.3, -1.0, 1.0, -1.0, 1.0 }),
      MakeBoxMesh({ 0.3, 1.0, -1.0, 1.0, -1.0, 1.0 }) }));
}

//------------------------------------------------------------------------------
void TestMissing()
{
  vtkNew<vtkParticipatingMedium> medium;
  ErrorListener errors(medium);
  SetFog(medium, nullptr);
  Check(errors.Take() == 0, "none: no error before it is used");
  Check(Pass(medium) == 1.0, "none: the medium is nowhere");
  Check(Pass(medium) == 1.0, "none: the medium is nowhere again");
  Check(errors.Take() == 1, "none: one error however often it is used");
  Check(errors.GetText().find("SetSurface()") != std::string::npos, "none: the error has a remedy");
  medium->SetSurface(MakeBoxMesh(Unit));
  Check(IsNear(Pass(medium), ThroughBox) && errors.Take() == 0, "none: fixed");
  medium->SetSurface(nullptr);
  Check(Pass(medium) == 1.0 && errors.Take() == 1, "taken away: an error, and nowhere");
}

//------------------------------------------------------------------------------
// Good when set, open later, fixed at last.
void TestChanged()
{
  vtkNew<vtkParticipatingMedium> medium;
  ErrorListener errors(medium);
  vtkNew<vtkPolyData> mesh;
  mesh->ShallowCopy(MakeBoxMesh(Unit));
  SetFog(medium, mesh);
  Check(IsNear(Pass(medium), ThroughBox), "changed: good at first");
  const vtkMTimeType before = medium->GetMTime();
  mesh->ShallowCopy(MakeOpenBox());
  mesh->Modified();
  Check(medium->GetMTime() > before, "changed: so is the medium");
  Check(Pass(medium) == 1.0 && Pass(medium) == 1.0, "changed: nowhere");
  Check(errors.Take() == 1, "changed: one error however often it is used");
  Check(errors.GetText().find("not closed") != std::string::npos &&
      errors.GetText().find("ignored until it is fixed") != std::string::npos,
    "changed: the error says what and what is done");
  mesh->ShallowCopy(MakeBoxMesh(Unit));
  mesh->Modified();
  Check(IsNear(Pass(medium), ThroughBox) && errors.Take() == 0, "changed: fixed");
}

//------------------------------------------------------------------------------
// The sum of a picture's airlight, and whether all of it is finite.
double Render(PixelScene& scene)
{
  scene.Window->Render();
  double sum = 0.0;
  for (int pixel = 0; pixel < PixelScene::Width * PixelScene::Height; ++pixel)
  {
    const float* rgb =
      scene.GetPixel("Airlight", pixel % PixelScene::Width, pixel / PixelScene::Width);
    sum += rgb ? rgb[0] + rgb[1] + rgb[2] : std::numeric_limits<double>::quiet_NaN();
  }
  return sum;
}

void TestPicture()
{
  PixelScene scene;
  vtkNew<vtkLight> light;
  const double intensity[3] = { 5.0, 5.0, 5.0 };
  vtkAirlight::SetRadiantIntensity(light, intensity);
  light->SetPosition(0.0, 2.0, 0.5);
  scene.Renderer->AddLight(light);
  scene.Renderer->GetActiveCamera()->SetPosition(0.5, 0.7, 5.0);
  vtkNew<vtkPolyData> mesh;
  mesh->ShallowCopy(MakeBoxMesh(Unit));
  SetFog(scene.Medium, mesh);
  ErrorListener errors(scene.Medium);
  const double good = Render(scene);
  Check(good > 0.0 && errors.Take() == 0, "picture: the medium is seen");
  mesh->ShallowCopy(MakeOpenBox());
  mesh->Modified();
  Check(Render(scene) == 0.0, "picture: no medium while it is open");
  Check(Render(scene) == 0.0, "picture: nor in the next frame");
  Check(errors.Take() == 1, "picture: one error for two frames");
  mesh->ShallowCopy(MakeBoxMesh(Unit));
  mesh->Modified();
  Check(Render(scene) == good && errors.Take() == 0, "picture: the same when fixed");
  scene.Medium->SetSurface(nullptr);
  Check(Render(scene) == 0.0 && errors.Take() == 1, "picture: no surface, no medium, one error");
}
}

//------------------------------------------------------------------------------
int TestClosedSurfaceErrors(int, char*[])
{
  TestRefused();
  TestTaken();
  TestMissing();
  TestChanged();
  TestPicture();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
