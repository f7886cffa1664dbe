// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Volumes that are media: a volume of one scalar against a uniform box, with a phase function of
// its own; a cloud in vtkAirlightPass and vtkAirlightReference against midpoint sums of its
// transfer functions; the pass against the reference, in fog and with a sun. Volumes that cannot be
// media are drawn as before, with a warning.

#include "AirlightTestCloudVolume.h"
#include "AirlightTestErrors.h"
#include "AirlightTestTools.h"

#include "vtkHenyeyGreensteinPhaseFunction.h"
#include "vtkInformation.h"
#include "vtkInformationObjectBaseKey.h"

#include <cmath>
#include <cstdlib>
#include <functional>

using namespace airlight_test;

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr double Median = 1e-3;
constexpr double P99 = 1e-2;
constexpr double Scale = 1.5;

class ScatteringScene : public DensityScene
{
public:
  explicit ScatteringScene(std::uint64_t seed)
    : DensityScene(MakeDensity(glm::ivec3(2), glm::dvec3(-9), glm::dvec3(9)), 48, 36)
  {
    const auto image =
      MakeDensity(glm::ivec3(22, 18, 20), glm::dvec3(-1.2, -0.8, -1.0), glm::dvec3(1.2, 0.8, 1.1));
    FillCloud(image, seed);
    this->Volume = MakeCloudVolume(image, 0.8, 0.7);
    this->Volume->SetScale(Scale);
    this->Volume->RotateWXYZ(30, 1, 2, 0.5);
    this->Volume->SetPosition(0.3, 1.4, 0.2);
    const double most = image->GetPointData()->GetScalars()->GetRange()[1];
    vtkColorTransferFunction* colours = this->Volume->GetProperty()->GetRGBTransferFunction();
    colours->RemoveAllPoints();
    colours->AddRGBPoint(0.0, 0.9, 0.3, 0.1);
    colours->AddRGBPoint(0.6 * most, 0.5, 0.9, 0.7);
    colours->AddRGBPoint(most, 0.1, 0.3, 1.0);
    this->Renderer->AddVolume(this->Volume);
    vtkAirlightPass::SetVolumeScatters(this->Volume, true);
    this->Medium->SetDensityToUniform();
    this->Medium->SetScattering(0, 0, 0);
    this->Medium->SetAbsorption(0, 0, 0);
  }

  vtkSmartPointer<vtkVolume> Volume;
};

//------------------------------------------------------------------------------
// The volume's scalar at a place, by its extinction: the opacity function is monotonic where it is
// not 0, and where it is, colours do not count.
glm::dvec3 GetColourAt(vtkVolume* volume, double extinction)
{
  vtkVolumeProperty* property = volume->GetProperty();
  const double alpha =
    1.0 - std::exp(-extinction * property->GetScalarOpacityUnitDistance() * Scale);
  double range[2];
  property->GetScalarOpacity()->GetRange(range);
  double low = range[0];
  double high = range[1];
  for (int i = 0; i < 60; ++i)
  {
    const double middle = 0.5 * (low + high);
    (property->GetScalarOpacity()->GetValue(middle) < alpha ? low : high) = middle;
  }
  glm::dvec3 colour;
  property->GetRGBTransferFunction()->GetColor(low, &colour.x);
  return colour;
}

// Sums over steps of one length.
double GetDepth(vtkVolume* volume, const glm::dvec3& from, const glm::dvec3& to, double step)
{
  const int count = std::max(1, static_cast<int>(std::ceil(glm::length(to - from) / step)));
  double sum = 0.0;
  for (int i = 0; i < count; ++i)
  {
    sum += GetExtinctionAt(volume, glm::mix(from, to, (i + 0.5) / count), Scale);
  }
  return sum * glm::length(to - from) / count;
}

glm::dvec3 GetScattered(
  vtkVolume* volume, const Ray& ray, double first, double last, const glm::dvec3& lamp)
{
  constexpr double Step = 0.03;
  const glm::dvec3 intensity(40.0, 30.0, 20.0);
  glm::dvec3 sum(0.0);
  double depth = 0.0;
  for (double t = first + 0.5 * Step; t < last; t += Step)
  {
    const glm::dvec3 point = ray.Origin + t * ray.Direction;
    const double extinction = GetExtinctionAt(volume, point, Scale);
    if (extinction > 0.0)
    {
      const double passes =
        std::exp(-depth - 0.5 * Step * extinction - GetDepth(volume, point, lamp, Step));
      sum += Step * extinction * passes * GetColourAt(volume, extinction) * intensity /
        (4.0 * Pi * glm::dot(point - lamp, point - lamp));
      depth += Step * extinction;
    }
  }
  return sum;
}

void TestTransferFunctions()
{
  ScatteringScene scene(81021);
  const glm::dvec3 place(1.2, 4.2, 1.5);
  scene.AddPointLight(place);
  scene.Window->Render();
  scene.Reference->SetSize(scene.Width, scene.Height);
  scene.Reference->Update();
  vtkDataArray* reference = scene.Reference->GetOutput()->GetPointData()->GetArray("Airlight");
  Comparison comparison("a cloud of transfer functions in the pass, of itself or the mean");
  Comparison ofReference("in the reference");
  Random random(81022);
  std::vector<glm::ivec2> pixels;
  std::vector<glm::dvec3> expected;
  double mean = 0.0;
  for (int i = 0; i < 60; ++i)
  {
    pixels.emplace_back(random.Index(scene.Width), random.Index(scene.Height));
    expected.push_back(GetScattered(scene.Volume, scene.GetPixelRay(pixels[i]), 6.0, 14.0, place));
    mean += (expected[i].x + expected[i].y + expected[i].z) / (3.0 * 60.0);
  }
  Check(mean > 0.0, "the cloud is seen");
  for (int i = 0; i < 60; ++i)
  {
    const glm::dvec3 drawn = GetColour(scene.GetBuffer("Airlight"), pixels[i].x, pixels[i].y);
    glm::dvec3 computed;
    reference->GetTuple(
      pixels[i].x + static_cast<vtkIdType>(pixels[i].y) * scene.Width, &computed.x);
    const double size = std::max(glm::length(expected[i]), mean);
    const auto describe = [&] {
      return Text("pixel ", pixels[i].x, " ", pixels[i].y, ": ", drawn.y, ", ", expected[i].y);
    };
    comparison.Add(glm::length(drawn - expected[i]) / size, 2e-2, describe);
    ofReference.Add(glm::length(computed - expected[i]) / size, 2e-2, describe);
  }
  Check(AllOk({ &comparison, &ofReference }), "against sums of transfer functions");
}

//------------------------------------------------------------------------------
void TestConstant(double anisotropy)
{
  ScatteringScene scene(81023);
  vtkNew<vtkHenyeyGreensteinPhaseFunction> phase;
  phase->SetAnisotropy(anisotropy);
  scene.Renderer->RemoveVolume(scene.Volume);
  const auto image =
    MakeDensity(glm::ivec3(7, 5, 6), glm::dvec3(-2, -1, -1.5), glm::dvec3(2, 2, 1));
  const auto volume = MakeCloudVolume(image, 0.5, 0.8);
  volume->GetProperty()->GetScalarOpacity()->RemoveAllPoints();
  volume->GetProperty()->GetScalarOpacity()->AddPoint(0.0, 0.4);
  volume->GetProperty()->GetRGBTransferFunction()->RemoveAllPoints();
  volume->GetProperty()->GetRGBTransferFunction()->AddRGBPoint(0.0, 0.25, 0.5, 0.75);
  vtkAirlightPass::SetVolumeScatters(volume, true);
  vtkAirlightPass::SetVolumePhaseFunction(volume, anisotropy == 0.0 ? nullptr : phase.Get());
  scene.Renderer->AddVolume(volume);
  scene.AddPointLight({ 0.5, 4.2, -1.5 });
  scene.AddBodies();
  scene.Window->Render();
  const Buffers buffers = scene.CopyBuffers();
  scene.Renderer->RemoveVolume(volume);
  const double sigma = -std::log(0.6) / 0.8;
  scene.Medium->SetScattering(0.25 * sigma, 0.5 * sigma, 0.75 * sigma);
  scene.Medium->SetAbsorption(0.75 * sigma, 0.5 * sigma, 0.25 * sigma);
  scene.Medium->SetPhaseFunction(phase);
  scene.Medium->SetRegionToBox();
  scene.Medium->SetBounds(-2, 2, -1, 2, -1.5, 1);
  scene.Window->Render();
  for (const char* buffer : { "Airlight", "Transmittance", "Radiance" })
  {
    CheckErrors(Text("a volume of one scalar, g ", anisotropy, ", ", buffer), buffers.at(buffer),
      scene.GetBuffer(buffer)->GetPointData()->GetScalars(), 1e-5, 1e-4);
  }
}

//------------------------------------------------------------------------------
void TestFog()
{
  ScatteringScene scene(81024);
  ErrorListener warnings(scene.Reference, vtkCommand::WarningEvent);
  scene.AddBodies();
  scene.Medium->SetScattering(0.05, 0.06, 0.07);
  vtkNew<vtkHenyeyGreensteinPhaseFunction> phase;
  phase->SetAnisotropy(0.7);
  vtkAirlightPass::SetVolumePhaseFunction(scene.Volume, phase);
  vtkLight* lamp = scene.AddPointLight({ 0.8, 4.2, 1.5 });
  scene.Compare("a volume in fog, lamp", Median, P99);
  lamp->SwitchOff();
  scene.AddDirectionalLight({ 0.4, 2, 0.5 });
  scene.Compare("a volume in fog, sun", Median, P99);
  phase->SetAnisotropy(-0.4);
  scene.Compare("a volume in fog, sun, backward", Median, P99);
  Check(warnings.Take() == 0, "no warning of the reference: " + warnings.GetText());
}

//------------------------------------------------------------------------------
double GetSum(Scene& scene, const char* name)
{
  scene.Window->Render();
  vtkDataArray* values = scene.GetBuffer(name)->GetPointData()->GetScalars();
  double sum = 0.0;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    sum += values->GetComponent(i, 0);
  }
  return sum;
}

// A band of colour between the points' scalars is where the scalars are.
void TestBand()
{
  ScatteringScene scene(81026);
  const auto image = MakeDensity(glm::ivec3(6), glm::dvec3(-2), glm::dvec3(2));
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    image->GetPointData()->GetScalars()->SetComponent(i, 0, image->GetPoint(i)[0]);
  }
  vtkVolumeProperty* property = scene.Volume->GetProperty();
  scene.Volume->SetScale(1.0);
  scene.Volume->SetOrientation(0, 0, 0);
  scene.Volume->SetPosition(0, 0, 0);
  vtkGPUVolumeRayCastMapper::SafeDownCast(scene.Volume->GetMapper())->SetInputData(image);
  property->GetScalarOpacity()->RemoveAllPoints();
  property->GetScalarOpacity()->AddPoint(-2.0, 0.2);
  property->GetScalarOpacity()->AddPoint(2.0, 0.2);
  vtkColorTransferFunction* colours = property->GetRGBTransferFunction();
  colours->RemoveAllPoints();
  colours->AddRGBPoint(-0.3, 0.0, 0.0, 0.0);
  colours->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  colours->AddRGBPoint(0.3, 0.0, 0.0, 0.0);
  scene.AddDirectionalLight({ 0.0, 1.0, 0.0 });
  scene.Window->Render();
  const auto get = [&](double x) {
    const glm::ivec2 pixel = scene.GetPixel({ x, 0.0, 0.0 });
    return GetColour(scene.GetBuffer("Airlight"), pixel.x, pixel.y).x;
  };
  // Points are at -0.4 and 0.4, where the colour is black.
  Check(get(0.0) > 0.0 && get(1.5) < 0.05 * get(0.0),
    Text("a band: ", get(0.0), " in it, ", get(1.5), " beside it"));
}

// Set, changed and removed. A key whose object is something else is as none.
void TestPhaseFunction(ScatteringScene& scene, double isotropic)
{
  vtkNew<vtkHenyeyGreensteinPhaseFunction> phase;
  vtkAirlightPass::SetVolumePhaseFunction(scene.Volume, phase);
  const double even = GetSum(scene, "Airlight");
  Check(std::abs(even / isotropic - 1.0) < 1e-3, Text("g of 0: ", even, " as ", isotropic));
  const vtkMTimeType time = scene.Reference->GetMTime();
  phase->SetAnisotropy(0.8);
  Check(scene.Reference->GetMTime() > time, "the reference follows it");
  const double forward = GetSum(scene, "Airlight");
  phase->SetAnisotropy(-0.8);
  const double backward = GetSum(scene, "Airlight");
  Check(std::abs(forward / even - 1.0) > 0.1 && std::abs(backward / forward - 1.0) > 0.1,
    Text("forward ", forward, ", backward ", backward));
  vtkAirlightPass::SetVolumePhaseFunction(scene.Volume, nullptr);
  Check(GetSum(scene, "Airlight") == isotropic, "without it as before");
  scene.Volume->GetPropertyKeys()->Set(vtkAirlightPass::VOLUME_PHASE_FUNCTION(), scene.Volume);
  Check(GetSum(scene, "Airlight") == isotropic, "no phase function");
  vtkAirlightPass::SetVolumePhaseFunction(scene.Volume, nullptr);
}

// Changes of the volume are seen, and volumes that cannot be media are as without the key.
void TestUpdates()
{
  ScatteringScene scene(81025);
  ErrorListener warnings(scene.Pass, vtkCommand::WarningEvent);
  scene.AddPointLight({ 0.8, 4.2, 1.5 });
  const double scattered = GetSum(scene, "Airlight");
  vtkAirlightPass::SetVolumeScatters(scene.Volume, false);
  const double cast = GetSum(scene, "Radiance");
  Check(GetSum(scene, "Airlight") == 0.0 && scattered > 0.0 && cast > 0.0,
    Text("without the key nothing is scattered: ", scattered, ", ", cast));
  vtkAirlightPass::SetVolumeScatters(scene.Volume, true);
  Check(GetSum(scene, "Airlight") == scattered, "the same as before");
  TestPhaseFunction(scene, scattered);
  scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(70.0);
  Check(GetSum(scene, "Airlight") < 0.1 * scattered, "a thinner volume");
  scene.Volume->VisibilityOff();
  Check(GetSum(scene, "Airlight") == 0.0, "a hidden volume");
  scene.Volume->VisibilityOn();
  scene.Volume->GetProperty()->SetScalarOpacityUnitDistance(0.7);
  Check(warnings.Take() == 0, "no warning: " + warnings.GetText());
  auto* mapper = vtkGPUVolumeRayCastMapper::SafeDownCast(scene.Volume->GetMapper());
  mapper->CroppingOn();
  Check(GetSum(scene, "Airlight") == 0.0, "no medium of a cropped volume");
  GetSum(scene, "Airlight");
  Check(warnings.Take() == 1 && warnings.GetText().find("CroppingOff()") != std::string::npos,
    "one warning: " + warnings.GetText());
  mapper->CroppingOff();
  scene.Volume->SetScale(1.5, 1.5, 0.0);
  Check(GetSum(scene, "Airlight") == 0.0, "no medium of a flat volume");
  Check(warnings.Take() == 1 && warnings.GetText().find("does not scatter") != std::string::npos,
    "one warning: " + warnings.GetText());
  scene.Volume->SetScale(1.5);
  Check(GetSum(scene, "Airlight") == scattered, "the same with its scale");
  for (int i = 0; i < 8; ++i)
  {
    vtkNew<vtkParticipatingMedium> medium;
    scene.Pass->AddMedium(medium);
  }
  scene.Pass->RemoveMedium(scene.Medium);
  Check(GetSum(scene, "Airlight") == 0.0, "no ninth medium");
  Check(warnings.Take() == 1 && warnings.GetText().find("8 media already") != std::string::npos,
    "one warning: " + warnings.GetText());
}
}

//------------------------------------------------------------------------------
int TestVolumeScatters(int, char*[])
{
  TestTransferFunctions();
  TestConstant(0.0);
  TestConstant(0.6);
  TestFog();
  TestBand();
  TestUpdates();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
