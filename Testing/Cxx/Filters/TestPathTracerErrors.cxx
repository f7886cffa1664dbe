// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The numbers that vtkAirlightReference's paths end by: honest standard errors, the same bytes in
// any number of threads, target error and time limit, pictures that grow, abort, and bad input.

#include "AirlightTestErrors.h"
#include "AirlightTestPaths.h"

#include "vtkCallbackCommand.h"
#include "vtkPlaneSource.h"
#include "vtkSMPTools.h"

#include <chrono>
#include <cstdlib>
#include <limits>
#include <vector>

using namespace airlight_test;

namespace
{
void Build(PathScene& scene)
{
  scene.AddLamp({ 0.4, 0.3, 0.8 });
  PathScene::SetMedium(scene.Medium, { 0.9, 0.8, 0.5 }, { 0.5, 1.0, 1.0 });
  scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
  scene.Medium->SetAnisotropy(0.3);
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-5.0, -5.0, 0.0);
  floor->SetPoint1(5.0, -5.0, 0.0);
  floor->SetPoint2(-5.0, 5.0, 0.0);
  scene.AddSurface(floor, { 0.2, 0.5, 0.8 });
  scene.Look({ 2.5, 0.0, 1.0 }, { -1.0, 0.1, -0.2 }, 50.0);
}

std::vector<double> GetValues(PathScene& scene, const char* name)
{
  vtkDataArray* array = scene.Get(name);
  std::vector<double> values;
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i)
  {
    values.push_back(array->GetVariantValue(i).ToDouble());
  }
  return values;
}

//------------------------------------------------------------------------------
// Pictures of many seeds differ from their mean as their standard errors say.
void CheckHonest()
{
  constexpr int Seeds = 16;
  PathScene scene;
  Build(scene);
  std::vector<std::vector<double>> pictures;
  std::vector<double> squares;
  for (int seed = 0; seed < Seeds; ++seed)
  {
    scene.Compute(100, seed);
    pictures.push_back(GetValues(scene, "Radiance"));
    const std::vector<double> errors = GetValues(scene, "StandardError");
    squares.resize(errors.size(), 0.0);
    for (size_t i = 0; i < errors.size(); ++i)
    {
      squares[i] += errors[i] * errors[i] / Seeds;
    }
  }
  double chi2 = 0.0;
  for (size_t i = 0; i < squares.size(); ++i)
  {
    double mean = 0.0;
    for (const std::vector<double>& picture : pictures)
    {
      mean += picture[i] / Seeds;
    }
    for (const std::vector<double>& picture : pictures)
    {
      chi2 += std::pow(picture[i] - mean, 2) / squares[i];
    }
  }
  chi2 /= (Seeds - 1.0) * static_cast<double>(squares.size());
  std::cout << "chi^2 per pixel of " << Seeds << " seeds: " << chi2 << "\n";
  Check(chi2 > 0.8 && chi2 < 1.2, Text("standard errors are honest: chi^2 per pixel ", chi2));
}

//------------------------------------------------------------------------------
void CheckDeterminism()
{
  PathScene scene;
  Build(scene);
  std::vector<double> first[2];
  for (const int threads : { 1, 2, 3 })
  {
    vtkSMPTools::Initialize(threads);
    scene.Compute(20, 7);
    const std::vector<double> values[2] = { GetValues(scene, "Radiance"),
      GetValues(scene, "StandardError") };
    for (int k = 0; k < 2; ++k)
    {
      first[k] = first[k].empty() ? values[k] : first[k];
      Check(!first[k].empty() && values[k] == first[k], Text("the same by ", threads, " threads"));
    }
  }
  vtkSMPTools::Initialize();
  scene.Compute(20, 8);
  Check(GetValues(scene, "Radiance") != first[0], "another seed, other numbers");

  // What is added is of the medium or of surfaces.
  const std::vector<double> radiance = GetValues(scene, "Radiance");
  const std::vector<double> airlight = GetValues(scene, "Airlight");
  const std::vector<double> surface = GetValues(scene, "Surface");
  bool sums = true;
  for (size_t i = 0; i < radiance.size(); ++i)
  {
    sums = sums && std::abs(radiance[i] - airlight[i] - surface[i]) < 1e-12 * radiance[i];
  }
  Check(sums, "radiance is airlight and surface, the background is black");
}

//------------------------------------------------------------------------------
void CheckTargets()
{
  PathScene scene;
  Build(scene);
  Check(scene.Reference->GetReachedError() == 0.0, "no error before");
  scene.Reference->SetTargetError(0.05);
  scene.Compute(1 << 20);
  double squares = 0.0;
  double sum = 0.0;
  for (const double error : GetValues(scene, "StandardError"))
  {
    squares += error * error;
  }
  const std::vector<double> radiance = GetValues(scene, "Radiance");
  for (const double value : radiance)
  {
    sum += value;
  }
  const auto count = static_cast<double>(radiance.size());
  const double reached = std::sqrt(squares / count) / (sum / count);
  Check(std::abs(reached - scene.Reference->GetReachedError()) < 1e-12,
    Text("the error is as it is defined: ", reached));
  Check(reached <= 0.05 && reached > 0.03, Text("the target is met, not by far: ", reached));

  scene.Reference->SetTargetError(0.0);
  scene.Reference->SetTimeLimit(0.3);
  const auto start = std::chrono::steady_clock::now();
  scene.Compute(1 << 30);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  Check(elapsed.count() < 10.0, Text("it stops in time: ", elapsed.count()));
  Check(scene.Reference->GetReachedError() > 0.0, "there is a picture");
}

//------------------------------------------------------------------------------
struct Watch
{
  PathScene* Scene;
  double Last = 0.0;
  double LastBeforeEnd = 0.0; // below 1
  double AbortAt = 2.0;
  bool Ascends = true;
  int Pictures = 0; // so far that differ from the one before
  double Sum = 0.0;
};

void Observe(vtkObject* caller, unsigned long, void* data, void* progress)
{
  auto* watch = static_cast<Watch*>(data);
  const double now = *static_cast<double*>(progress);
  watch->Ascends = watch->Ascends && now >= watch->Last;
  watch->Last = now;
  watch->LastBeforeEnd = now < 1.0 ? now : watch->LastBeforeEnd;
  auto* reference = vtkAirlightReference::SafeDownCast(caller);
  auto* image = vtkImageData::SafeDownCast(reference->GetOutputDataObject(0));
  vtkDataArray* radiance = image->GetPointData()->GetArray("Radiance");
  double sum = 0.0;
  for (vtkIdType i = 0; radiance && i < radiance->GetNumberOfTuples(); ++i)
  {
    sum += radiance->GetComponent(i, 1);
  }
  watch->Pictures += sum != watch->Sum ? 1 : 0;
  watch->Sum = sum;
  if (now >= watch->AbortAt)
  {
    reference->SetAbortExecute(1);
  }
}

void CheckProgress()
{
  PathScene scene;
  Build(scene);
  Watch watch;
  watch.Scene = &scene;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&watch);
  command->SetCallback(Observe);
  scene.Reference->AddObserver(vtkCommand::ProgressEvent, command);
  scene.Compute(30);
  Check(watch.Ascends && watch.Last == 1.0, "progress ascends to 1");
  Check(watch.Pictures > 20, Text("an observer sees the picture grow: ", watch.Pictures));
  const std::vector<double> whole = GetValues(scene, "Radiance");
  watch = Watch();
  watch.AbortAt = 0.5;
  scene.Compute(30);
  // Newer versions of VTK say 1 after an abort, too.
  Check(watch.LastBeforeEnd >= 0.5 && watch.LastBeforeEnd < 0.8,
    Text("it stops soon: ", watch.LastBeforeEnd));
  Check(scene.Reference->GetOutput()->GetNumberOfPoints() == 0, "no picture after an abort");
  scene.Reference->SetAbortExecute(0);
  watch = Watch();
  scene.Compute(30);
  Check(!whole.empty() && GetValues(scene, "Radiance") == whole, "all is there afterwards");
}

//------------------------------------------------------------------------------
void CheckSettings()
{
  vtkNew<vtkAirlightReference> reference;
  ErrorListener errors(reference);
  const auto check = [&](const std::string& part) {
    Check(errors.Take() == 1, part + ": one message");
    Check(errors.GetText().find(part) != std::string::npos,
      "it says '" + part + "', not: " + errors.GetText());
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  reference->SetScatteringOrders(-1);
  check("ScatteringOrders -1 must be 1");
  reference->SetSamplesPerPixel(0);
  check("SamplesPerPixel 0 must be at least 2");
  reference->SetSamplesPerPixel(1);
  check("it stays 64");
  reference->SetTargetError(nan);
  check("TargetError nan");
  reference->SetTargetError(-0.1);
  check("TargetError -0.1");
  reference->SetTimeLimit(HUGE_VAL);
  check("TimeLimit inf");
  reference->SetTimeLimit(-1.0);
  check("TimeLimit -1");
  Check(reference->GetScatteringOrders() == 1 && reference->GetSamplesPerPixel() == 64 &&
      reference->GetTargetError() == 0.0 && reference->GetTimeLimit() == 0.0,
    "the values stay");

  // Without lights, and with a lamp on the eye's ray, at the eye and on a surface.
  PathScene scene(4);
  PathScene::SetMedium(scene.Medium, glm::dvec3(0.9), glm::dvec3(1.0));
  scene.Look({ 2.0, 0.0, 1.0 }, { -1.0, 0.0, 0.0 });
  scene.Compute(10);
  vtkNew<vtkPlaneSource> wall;
  wall->SetNormal(1.0, 0.0, 0.0);
  scene.AddSurface(wall, glm::dvec3(0.5));
  for (const glm::dvec3& lamp :
    { glm::dvec3(1.0, 0.0, 1.0), glm::dvec3(2.0, 0.0, 1.0), glm::dvec3(0.0) })
  {
    scene.AddLamp(lamp);
    scene.Compute(10);
    bool finite = true;
    for (const char* name : { "Radiance", "StandardError" })
    {
      for (const double value : GetValues(scene, name))
      {
        finite = finite && std::isfinite(value);
      }
    }
    Check(finite, Text("finite numbers with a lamp at ", lamp.x, ", ", lamp.y, ", ", lamp.z));
  }
}
}

int TestPathTracerErrors(int, char*[])
{
  CheckSettings();
  CheckHonest();
  CheckDeterminism();
  CheckTargets();
  CheckProgress();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
