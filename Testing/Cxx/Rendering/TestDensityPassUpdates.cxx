// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Images of density in vtkAirlightPass are where VTK draws a volume of the same image, are clipped
// by the medium's region, and follow what becomes of image, light and medium.

#include "AirlightTestDensity.h"

#include "vtkColorTransferFunction.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkUnsignedCharArray.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cmath>
#include <cstdlib>
#include <utility>

using namespace airlight_test;

namespace
{
//------------------------------------------------------------------------------
// Which pixels a white volume of the image covers, drawn by VTK alone.
std::vector<bool> GetVolumePixels(DensityScene& scene)
{
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(scene.Image);
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetSampleDistance(0.02f);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  vtkNew<vtkColorTransferFunction> white;
  white->AddRGBPoint(0.0, 1.0, 1.0, 1.0);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.9);
  opacity->AddPoint(2.0, 0.9);
  volume->GetProperty()->SetColor(white);
  volume->GetProperty()->SetScalarOpacity(opacity);
  scene.Renderer->AddVolume(volume);
  scene.Renderer->SetPass(nullptr);
  scene.Window->Render();
  vtkNew<vtkUnsignedCharArray> colours;
  scene.Window->GetPixelData(0, 0, scene.Width - 1, scene.Height - 1, 0, colours);
  std::vector<bool> covered;
  for (vtkIdType i = 0; i < colours->GetNumberOfTuples(); ++i)
  {
    covered.push_back(colours->GetComponent(i, 0) > 0);
  }
  scene.Renderer->RemoveVolume(volume);
  scene.Renderer->SetPass(scene.Pass);
  return covered;
}

std::vector<bool> GetMediumPixels(DensityScene& scene)
{
  scene.Window->Render();
  vtkDataArray* passes = scene.GetBuffer("Transmittance")->GetPointData()->GetScalars();
  std::vector<bool> covered;
  for (vtkIdType i = 0; i < passes->GetNumberOfTuples(); ++i)
  {
    covered.push_back(passes->GetComponent(i, 0) < 1.0 - 1e-5);
  }
  return covered;
}

// The two differ along the outline at most, where VTK's samples miss what is thinner than they are
// apart: by fewer pixels than half of those on it.
void ComparePlace(const std::string& name, DensityScene& scene)
{
  const std::vector<bool> volume = GetVolumePixels(scene);
  const std::vector<bool> medium = GetMediumPixels(scene);
  int both = 0;
  int one = 0;
  int outline = 0;
  for (size_t i = 0; i + scene.Width < volume.size(); ++i)
  {
    both += volume[i] && medium[i] ? 1 : 0;
    one += volume[i] != medium[i] ? 1 : 0;
    outline += medium[i] != medium[i + 1] || medium[i] != medium[i + scene.Width] ? 1 : 0;
  }
  std::cout << name << ": " << both << " pixels in both, " << one << " in one, " << outline
            << " at the outline\n";
  Check(both > 300, name + ": the image is seen");
  Check(2 * one < outline, name + ": medium and volume cover the same pixels");
}

//------------------------------------------------------------------------------
void TestPlace()
{
  const vtkSmartPointer<vtkImageData> image = MakeDensity({ 5, 7, 4 }, { -3, -1, -2 }, { 1, 3, 1 });
  DensityScene scene(image);
  scene.Medium->SetAbsorption(1, 1, 1);
  ComparePlace("along the axes", scene);
  image->SetExtent(3, 7, -2, 4, 1, 4); // moves it
  image->AllocateScalars(VTK_FLOAT, 1);
  image->GetPointData()->GetScalars()->Fill(1.0);
  image->SetOrigin(-6, 0, -3);
  ComparePlace("an extent that begins elsewhere", scene);
}

//------------------------------------------------------------------------------
// Images come, grow, shrink and go, and lamps move beside one that stays: the card has what it
// would have if all were sent again.
void TestPlacesOnCard()
{
  DensityScene scene(MakeDensity({ 12, 14, 10 }, glm::dvec3(-3), glm::dvec3(3)));
  FillCloud(scene.Image, 61);
  vtkNew<vtkParticipatingMedium> other;
  other->SetScattering(0.5, 0.4, 0.3);
  other->SetDensityToImage();
  scene.Pass->AddMedium(other);
  vtkLight* lamp = scene.AddPointLight({ 0.5, 2.2, -1.5 });
  for (const int size : { 9, 31, 30, 8, 44, 12, 17 })
  {
    const auto image = MakeDensity(glm::ivec3(size), glm::dvec3(-2, -1, -2), glm::dvec3(2, 3, 2));
    FillCloud(image, 62 + size);
    other->SetDensityImage(image);
    lamp->SetPosition(0.1 * size, 2.2, -1.5);
    scene.Window->Render();
    const Buffers kept = scene.CopyBuffers();
    scene.Pass->ReleaseGraphicsResources(scene.Window);
    scene.Window->Render();
    CheckErrors(Text("beside an image of ", size), scene.GetBuffer("Airlight"),
      kept.at("Airlight")->GetPointData()->GetScalars(), 0.0, 0.0);
  }
}

//------------------------------------------------------------------------------
// A cloud of whole numbers up to `most`, in this type.
vtkSmartPointer<vtkImageData> MakeWholeCloud(int points, std::uint64_t seed, int type, double most)
{
  const auto image = MakeDensity(glm::ivec3(points), glm::dvec3(-2, -1, -2), glm::dvec3(2, 3, 2));
  FillCloud(image, seed);
  vtkDataArray* cloud = image->GetPointData()->GetScalars();
  const double scale = most / cloud->GetRange()[1];
  auto numbers = vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(type));
  numbers->SetName("Density");
  numbers->SetNumberOfTuples(cloud->GetNumberOfTuples());
  for (vtkIdType i = 0; i < cloud->GetNumberOfTuples(); ++i)
  {
    numbers->SetComponent(i, 0, std::round(scale * cloud->GetComponent(i, 0)));
  }
  image->GetPointData()->SetScalars(numbers);
  Random random(seed);
  AddColours(image, "Albedo", 1.0, random);
  return image;
}

// Samples of 8 and 16 bits stay such on the card while all images have as many, and are drawn as the
// same numbers in single precision, whatever was there before: in the air, on surfaces and before a
// pane, with colours.
void TestWholeNumbers()
{
  DensityScene scene(MakeDensity(glm::ivec3(2), glm::dvec3(-1), glm::dvec3(1)));
  scene.AddBodies();
  scene.AddPointLight({ 0.5, 2.2, -1.5 });
  vtkNew<vtkPlaneSource> pane;
  pane->SetOrigin(-20, -20, 0.5);
  pane->SetPoint1(20, -20, -0.5);
  pane->SetPoint2(-20, 20, 0.5);
  scene.Add(pane)->GetProperty()->SetOpacity(0.4);
  scene.Medium->SetAlbedoArrayName("Albedo");
  vtkNew<vtkParticipatingMedium> other;
  scene.Pass->AddMedium(other);
  const auto show = [](vtkParticipatingMedium* medium, int numbers, int type, int seed) {
    const double most = numbers == VTK_UNSIGNED_CHAR ? 255.0
      : numbers == VTK_UNSIGNED_SHORT                ? 65535.0
                                                     : 1000.0;
    medium->SetDensityImage(MakeWholeCloud(10 + seed % 7, seed, type, most));
    medium->SetScattering(0.5 / most, 0.4 / most, 0.3 / most);
    medium->SetAbsorption(0.1 / most, 0.2 / most, 0.0);
  };
  int seed = 80;
  const int bytes = VTK_UNSIGNED_CHAR;
  const int shorts = VTK_UNSIGNED_SHORT;
  for (const auto& [first, second] : { std::pair(bytes, bytes), std::pair(shorts, shorts),
         std::pair(shorts, bytes), std::pair(bytes, VTK_FLOAT), std::pair(shorts, shorts) })
  {
    ++seed;
    show(scene.Medium, first, first, seed);
    show(other, second, second, seed + 20);
    const Buffers whole = scene.Render();
    show(scene.Medium, first, VTK_FLOAT, seed);
    show(other, second, VTK_FLOAT, seed + 20);
    const Buffers expected = scene.Render();
    const std::string name = Text("types ", first, " and ", second);
    for (const char* buffer : { "Airlight", "Transmittance", "Radiance" })
    {
      CheckErrors(name + ", " + buffer, whole.at(buffer),
        expected.at(buffer)->GetPointData()->GetScalars(), 2e-6, 2e-5);
    }
  }
}

//------------------------------------------------------------------------------
// Of the airlight of an image of ones, whose light's grid has no error, as a share of it: what a
// region leaves whole has the bound of quadrature.
void TestBoundOfCutImages()
{
  const glm::dvec3 low(-2, -1, -2);
  const glm::dvec3 high(2, 3, 2);
  DensityScene scene(MakeDensity(glm::ivec3(4, 5, 6), low, high));
  scene.AddPointLight({ 0.5, 1.2, -0.5 });
  const auto check = [&scene](const std::string& name, double share) {
    scene.Window->Render();
    const double found = scene.GetBuffer("ErrorBound")->GetScalarRange()[1] /
      scene.GetBuffer("Airlight")->GetScalarRange()[1];
    Check(std::abs(found / share - 1.0) < 0.05, Text(name, ": the bound is ", found));
  };
  check("an image in no region", 1e-3);
  scene.Medium->SetRegionToBox();
  scene.Medium->SetBounds(-2, 2, -1, 3, -2, 2);
  check("in a box as large as it", 1e-3);
  scene.Medium->SetBounds(-3, 3, -4, 4, -3, 3);
  check("in a larger box", 1e-3);
  scene.Medium->SetBounds(-2, 1.5, -1, 3, -2, 2);
  check("cut by a box", 1e-2);
  scene.Medium->SetRegionToSphere();
  scene.Medium->SetCenter(0, 1, 0);
  scene.Medium->SetRadius(1.8);
  check("cut by a sphere", 1e-2);
}

//------------------------------------------------------------------------------
// Whatever changes, the next picture is the reference's.
void TestUpdates()
{
  const vtkSmartPointer<vtkImageData> image =
    MakeDensity({ 12, 14, 10 }, glm::dvec3(-3), glm::dvec3(3));
  FillCloud(image, 5);
  DensityScene scene(image);
  vtkLight* lamp = scene.AddPointLight({ 0.5, 2.2, -1.5 });
  const double median = 5e-4;
  const double p99 = 5e-3;
  scene.Compare("a cloud", median, p99);
  FillCloud(image, 6);
  scene.Compare("another cloud", median, p99);
  image->SetOrigin(-2.5, -3.5, -3);
  scene.Compare("a moved cloud", median, p99);
  lamp->SetPosition(-1.0, 0.5, 2.0);
  scene.Compare("a moved lamp", median, p99);
  // A pane before half of the cloud that fills the picture: no pixels at edges.
  vtkNew<vtkPlaneSource> pane;
  pane->SetOrigin(-20, -20, 0.5);
  pane->SetPoint1(20, -20, -0.5);
  pane->SetPoint2(-20, 20, 0.5);
  vtkActor* glass = scene.Add(pane);
  glass->GetProperty()->SetOpacity(0.4);
  scene.Compare("with a pane", median, p99);
  CheckErrors("pane in a cloud, Radiance", scene.GetBuffer("Radiance"),
    scene.Reference->GetOutput()->GetPointData()->GetArray("Radiance"), median, p99);
  scene.Renderer->RemoveActor(glass);
  scene.Medium->SetRegionToBox();
  scene.Medium->SetBounds(-2, 1.5, -2, 1.0, -1, 3);
  scene.Compare("cut by a box", median, p99);
  scene.Medium->SetRegionToSphere();
  scene.Medium->SetRadius(2.0);
  scene.Compare("cut by a sphere", median, p99);
  scene.Pass->SetShadowTechniqueToRayMarch();
  scene.Pass->SetNumberOfSteps(256);
  scene.Compare("marched", median, p99);
}

//------------------------------------------------------------------------------
// While a lamp is dragged its grid is a coarse one, of which the bound says how good it is; at rest
// it is as fine as ever.
void TestDragged()
{
  const vtkSmartPointer<vtkImageData> image =
    MakeDensity({ 40, 40, 40 }, glm::dvec3(-3), glm::dvec3(3));
  FillCloud(image, 7);
  DensityScene scene(image);
  vtkLight* lamp = scene.AddPointLight({ 3.5, 2.2, -1.5 });
  const auto getBound = [&scene] {
    scene.Window->Render();
    return scene.GetBuffer("ErrorBound")->GetScalarRange()[1] / scene.GetPercentile99("Airlight");
  };
  const double fine = getBound();
  scene.Window->SetDesiredUpdateRate(5000.0); // no time at all
  lamp->SetPosition(3.5, 2.0, -1.2);
  const double coarse = getBound();
  std::cout << "bound at rest " << fine << ", dragged " << coarse << "\n";
  Check(coarse > 3.0 * fine, "a dragged lamp's grid is coarse");
  scene.Reference->SetSize(scene.Width, scene.Height);
  scene.Reference->Modified();
  scene.Reference->Update();
  CheckBound("dragged", scene.GetBuffer("Airlight"), scene.GetBuffer("ErrorBound"),
    scene.Reference->GetOutput()->GetPointData()->GetArray("Airlight"));
  scene.Window->SetDesiredUpdateRate(1e-4);
  Check(getBound() < 1.5 * fine, "at rest it is fine again");
  scene.Compare("at rest", 5e-4, 5e-3);
}
}

//------------------------------------------------------------------------------
int TestDensityPassUpdates(int, char*[])
{
  TestDragged();
  TestPlace();
  TestUpdates();
  TestPlacesOnCard();
  TestWholeNumbers();
  TestBoundOfCutImages();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
