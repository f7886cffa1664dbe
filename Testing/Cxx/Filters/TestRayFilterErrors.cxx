// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkLitIntervalsFilter and vtkAirlightProbeFilter with bad input: an error or a warning that names
// it, and an output that is empty or finite.

#include "AirlightTestCheck.h"
#include "AirlightTestErrors.h"
#include "AirlightTestLines.h"

#include "vtkAirlightProbeFilter.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// One error or warning whose text has `word` in it.
void CheckTold(ErrorListener& listener, const std::string& what, const std::string& word)
{
  const int count = listener.Take();
  Check(count == 1, Text(what, " gives one message, not ", count));
  Check(listener.GetText().find(word) != std::string::npos,
    Text(what, ": \"", listener.GetText(), "\" names \"", word, "\""));
}

void CheckFinite(vtkDataSetAttributes* data, const std::string& what)
{
  for (int k = 0; k < data->GetNumberOfArrays(); ++k)
  {
    vtkDataArray* array = data->GetArray(k);
    for (vtkIdType i = 0; i < array->GetNumberOfTuples() * array->GetNumberOfComponents(); ++i)
    {
      const int n = array->GetNumberOfComponents();
      Check(std::isfinite(array->GetComponent(i / n, static_cast<int>(i % n))),
        Text(what, ": finite ", array->GetName()));
    }
  }
}

//------------------------------------------------------------------------------
void TestSettings(const Polyline& line)
{
  const auto lights = MakeLights();
  Run run({ line });
  ErrorListener errors(run.Filter);
  run.Filter->Update();
  CheckTold(errors, "no light", "SetLight()");
  Check(run.Count() == 0, "no light, no parts");
  run.Filter->SetLight(lights[0].second);
  run.Filter->SetMedium(nullptr);
  run.Filter->Update();
  CheckTold(errors, "no medium", "SetMedium()");
  run.Filter->SetMedium(run.Medium);
  lights[0].second->SetAttenuationValues(0.0, 0.0, 0.0);
  run.Filter->Update();
  CheckTold(errors, "attenuation 0", "attenuation (0, 0, 0)");
  Check(run.Count() == 0, "a bad light, no parts");
  lights[0].second->SetAttenuationValues(0.0, 0.0, 1.0);
  run.Filter->AddOccluderData(nullptr);
  CheckTold(errors, "null occluder", "vtkPolyData");
  run.Filter->Update();
  Check(errors.Take() == 0 && run.Count() == 1, "all is well again");
}

void TestLines()
{
  const auto lights = MakeLights();
  Run run({ { { 0, 0, 0 }, { 1, nan, 0 }, { 2, 0, 0 } }, { { 0, 0, 0 }, { 1, 0, 0 } },
    { { 0, 0, 0 }, { 1e200, 0, 0 } }, { { 1, 1, 1 }, { 1, 1, 1 } }, { { 1, 1, 1 } } });
  run.Filter->SetLight(lights[0].second);
  ErrorListener errors(run.Filter);
  ErrorListener warnings(run.Filter, vtkCommand::WarningEvent);
  run.Filter->Update();
  CheckTold(warnings, "lines that are not finite", "2 lines are left out");
  Check(warnings.GetText().find("first point 1 (1, nan, 0)") != std::string::npos, "which point");
  Check(run.Count() == 1 && run.Get("SourceCell", 0) == 1, "the good line is followed");
  CheckFinite(run.Filter->GetOutput()->GetCellData(), "good line");
  run.Filter->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  run.Filter->Update();
  Check(run.Count() == 0, "nothing in, nothing out");
  // The lamp on the line, at its ends, and beside occluders that are not finite.
  vtkNew<vtkPoints> points;
  points->InsertNextPoint(nan, 0, 0);
  points->InsertNextPoint(1, 0, 0);
  points->InsertNextPoint(0, 1, 0);
  vtkNew<vtkCellArray> cells;
  const vtkIdType ids[3] = { 0, 1, 2 };
  cells->InsertNextCell(3, ids);
  vtkNew<vtkPolyData> bad;
  bad->SetPoints(points);
  bad->SetPolys(cells);
  vtkNew<vtkSphereSource> ball;
  for (const glm::dvec3& p : { glm::dvec3(0.0), glm::dvec3(0.5, 0, 0), glm::dvec3(1, 0, 0) })
  {
    Run at({ { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 0, 0 } } });
    lights[0].second->SetPosition(&p.x);
    at.Filter->SetLight(lights[0].second);
    at.Filter->AddOccluderData(bad);
    at.Filter->AddInputConnection(1, ball->GetOutputPort());
    at.Filter->Update();
    Check(at.Count() >= 1, Text("parts with the lamp at ", p.x));
    CheckFinite(at.Filter->GetOutput()->GetCellData(), Text("lamp at ", p.x));
  }
  Check(errors.Take() == 0, "no further errors");
}

//------------------------------------------------------------------------------
void TestProbe()
{
  const auto lights = MakeLights();
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(0.1, 0.1, 0.1);
  vtkNew<vtkAirlightProbeFilter> probe;
  probe->SetInputData(MakeLines(
    { { { 0, 0, 0 }, { nan, 0, 0 }, { 1e200, 0, 0 }, { 1, 1, 1 }, { 0.3, 1.7, -0.4 } } }));
  ErrorListener errors(probe);
  ErrorListener warnings(probe, vtkCommand::WarningEvent);
  probe->Update();
  CheckTold(errors, "no medium", "SetMedium()");
  Check(probe->GetOutput()->GetNumberOfPoints() == 5, "the input comes out");
  Check(!probe->GetOutput()->GetPointData()->GetArray("Radiance"), "without arrays");
  probe->SetMedium(medium);
  probe->AddLight(nullptr);
  CheckTold(errors, "null light", "vtkLight");
  probe->AddLight(lights[5].second);
  lights[5].second->SetFocalPoint(lights[5].second->GetPosition());
  probe->Update();
  CheckTold(errors, "a sun that shines nowhere", "focal point");
  warnings.Take();
  probe->RemoveLight(lights[5].second);
  probe->AddLight(lights[0].second); // on the last point
  probe->SetViewpoint(0.0, nan, 0.0);
  CheckTold(errors, "bad viewpoint", "viewpoint (0, nan, 0)");
  probe->AddOccluderData(nullptr);
  CheckTold(errors, "null occluder", "vtkPolyData");
  probe->Update();
  CheckTold(warnings, "points that are not finite", "2 points get zeros");
  CheckFinite(probe->GetOutput()->GetPointData(), "probe");
  probe->ScatteredIrradianceOn();
  probe->Update();
  Check(
    warnings.Take() == 2 && !probe->GetOutput()->GetPointData()->GetArray("ScatteredIrradiance"),
    "no scattered light without normals");
  Check(probe->GetLight(0) == lights[0].second && !probe->GetLight(1) && !probe->GetLight(-1),
    "lights by number");
  probe->SetInputData(vtkSmartPointer<vtkPolyData>::New());
  probe->ScatteredIrradianceOff();
  probe->Update();
  Check(errors.Take() == 0, "no points are no error");
}

//------------------------------------------------------------------------------
// What was given is taken back; each change counts once.
void TestProbeLists()
{
  const auto lights = MakeLights();
  vtkNew<vtkParticipatingMedium> medium;
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkAirlightProbeFilter> probe;
  probe->SetInputConnection(sphere->GetOutputPort());
  probe->SetMedium(medium);
  Check(probe->GetMedium() == medium, "the medium that was set");
  probe->AddLight(lights[0].second);
  probe->AddLight(lights[1].second);
  vtkMTimeType time = probe->GetMTime();
  probe->RemoveAllLights();
  Check(probe->GetNumberOfLights() == 0 && probe->GetMTime() > time, "no lights are left");
  time = probe->GetMTime();
  probe->RemoveAllLights();
  Check(probe->GetMTime() == time, "there were none to remove");
  probe->AddInputConnection(1, sphere->GetOutputPort());
  probe->RemoveAllOccluders();
  Check(probe->GetNumberOfInputConnections(1) == 0, "no occluders are left");
}

//------------------------------------------------------------------------------
// Lines of sight: each bad number gives one message that names it, and stays out.
void TestSightLines()
{
  vtkNew<vtkAirlightProbeFilter> probe;
  ErrorListener errors(probe);
  for (double value : { 0.0, -1.0, nan, std::numeric_limits<double>::infinity() })
  {
    probe->SetReflectingSignConstant(value);
    CheckTold(errors, "bad K", Text("ReflectingSignConstant ", value, " must be finite"));
    probe->SetEmittingSignConstant(value);
    CheckTold(errors, "bad K", Text("EmittingSignConstant ", value, " must be finite"));
  }
  for (double value : { -0.5, 1.5, nan })
  {
    probe->SetSignReflectance(value);
    CheckTold(errors, "bad letters", Text("SignReflectance ", value, " must be from 0 to 1"));
    probe->SetSignGroundReflectance(value);
    CheckTold(errors, "bad ground", Text("SignGroundReflectance ", value, " must be"));
  }
  for (double value : { -0.5, std::numeric_limits<double>::infinity(), nan })
  {
    probe->SetSignRadiance(value);
    CheckTold(errors, "bad radiance", Text("SignRadiance ", value, " must be from 0 to 1e100"));
  }
  for (double value : { 0.0, nan })
  {
    probe->SetMaximumVisibility(value);
    CheckTold(errors, "bad limit", Text("MaximumVisibility ", value, " must be above 0"));
  }
  Check(probe->GetReflectingSignConstant() == 3.0 && probe->GetEmittingSignConstant() == 8.0 &&
      probe->GetSignReflectance() == 0.8 && probe->GetSignGroundReflectance() == 0.1 &&
      probe->GetSignRadiance() == 0.0 && std::isinf(probe->GetMaximumVisibility()),
    "defaults stay");
}

//------------------------------------------------------------------------------
// Null and too many media, and points that are not finite with lines of sight.
void TestProbeMedia()
{
  vtkNew<vtkAirlightProbeFilter> probe;
  probe->SetInputData(MakeLines({ { { 0, 0, 0 }, { nan, 0, 0 }, { 1e200, 0, 0 }, { 1, 1, 1 } } }));
  ErrorListener errors(probe);
  ErrorListener warnings(probe, vtkCommand::WarningEvent);
  probe->AddMedium(nullptr);
  CheckTold(errors, "null medium", "vtkParticipatingMedium");
  std::vector<vtkSmartPointer<vtkParticipatingMedium>> media;
  for (int i = 0; i < 9; ++i)
  {
    media.emplace_back(vtkSmartPointer<vtkParticipatingMedium>::New());
    media.back()->SetScattering(0.1, 0.1, 0.1);
    probe->AddMedium(media.back());
  }
  probe->Update();
  CheckTold(errors, "nine media", "There are 9 media and at most 8");
  Check(!probe->GetOutput()->GetPointData()->GetArray("Radiance"), "nine media, no arrays");
  probe->RemoveMedium(media.front());
  Check(probe->GetNumberOfMedia() == 8 && !probe->GetMedium(8) && !probe->GetMedium(-1),
    "media by number");
  probe->SightLinesOn();
  probe->Update();
  CheckTold(warnings, "points that are not finite", "2 points get zeros");
  Check(errors.Take() == 0, "eight media are computed");
  CheckFinite(probe->GetOutput()->GetPointData(), "lines of sight");
  probe->RemoveAllMedia();
  Check(probe->GetNumberOfMedia() == 0 && !probe->GetMedium(), "no media are left");
}

//------------------------------------------------------------------------------
// Scattered irradiance in other densities has no closed form: the array is left out.
void TestProbeDensity()
{
  vtkNew<vtkImageData> smoke;
  smoke->SetDimensions(2, 2, 2);
  smoke->AllocateScalars(VTK_FLOAT, 1);
  smoke->GetPointData()->GetScalars()->Fill(1.0);
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(0.1, 0.1, 0.1);
  medium->SetDensityImage(smoke);
  medium->SetDensityToImage();
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkAirlightProbeFilter> probe;
  probe->SetInputConnection(sphere->GetOutputPort());
  probe->SetMedium(medium);
  probe->AddLight(MakeLights()[0].second);
  probe->ScatteredIrradianceOn();
  ErrorListener warnings(probe, vtkCommand::WarningEvent);
  probe->Update();
  CheckTold(warnings, "scattered light of an image of density", "exponential height");
  vtkPointData* found = probe->GetOutput()->GetPointData();
  Check(!found->GetArray("ScatteredIrradiance"), "it is left out");
  Check(found->GetArray("Radiance"), "the rest is there");
  CheckFinite(found, "probe of an image");
}

//------------------------------------------------------------------------------
// The light on the surface and right above it.
void TestProbeLimits()
{
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(0.1, 0.1, 0.1);
  medium->SetRegionToSphere();
  for (double z : { 0.5, 0.5 + 1e-13, 0.0, -0.5 })
  {
    const auto light = MakeLights()[0].second;
    light->SetPosition(0.0, 0.0, z);
    vtkNew<vtkAirlightProbeFilter> probe;
    probe->SetInputConnection(sphere->GetOutputPort());
    probe->AddInputConnection(1, sphere->GetOutputPort());
    probe->SetMedium(medium);
    probe->AddLight(light);
    probe->ScatteredIrradianceOn();
    probe->SetViewpoint(0.0, 0.0, 0.5);
    probe->Update();
    Check(probe->GetOutput()->GetPointData()->GetArray("ScatteredIrradiance"), "scattered light");
    CheckFinite(probe->GetOutput()->GetPointData(), Text("lamp at z = ", z));
  }
}
}

//------------------------------------------------------------------------------
int TestRayFilterErrors(int, char*[])
{
  TestSettings({ { 0, 0, 0 }, { 1, 0, 0 } });
  TestLines();
  TestProbe();
  TestProbeLists();
  TestSightLines();
  TestProbeMedia();
  TestProbeDensity();
  TestProbeLimits();
  std::cout << Failures << " failures\n";
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
