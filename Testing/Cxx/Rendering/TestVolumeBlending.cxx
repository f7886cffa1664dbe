// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// All ways in which VTK blends the samples of volumes: in fog so thick that nothing is seen through
// it, a volume must not be seen either, since each sample then shows the fog that is before it.
// What cannot be put behind the medium is drawn as it is, and one warning says so.

#include "AirlightTestErrors.h"
#include "AirlightTestVolume.h"

#include "vtkContourValues.h"
#include "vtkFixedPointVolumeRayCastMapper.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkMultiVolume.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlane.h"
#include "vtkSmartVolumeMapper.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr double Thick = 3.0;
// Where VTK blends into 8 bits, colour and opacity are rounded.
constexpr double EightBits = 6e-3;

// Of thick fog; 0 for clear air.
vtkSmartPointer<vtkImageData> Draw(Scene& scene, double scattering)
{
  scene.Medium->SetScattering(scattering, scattering, scattering);
  scene.Medium->SetAbsorption(0.0, 0.0, 0.0);
  scene.Window->Render();
  auto copy = vtkSmartPointer<vtkImageData>::New();
  copy->DeepCopy(scene.GetBuffer("Radiance"));
  return copy;
}

double GetLargestDifference(const Scene& scene, vtkImageData* a, vtkImageData* b)
{
  double most = 0.0;
  for (int i = 0; i < scene.Width * scene.Height; ++i)
  {
    const int x = i % scene.Width;
    const int y = i / scene.Width;
    const glm::dvec3 d = glm::abs(GetColour(a, x, y) - GetColour(b, x, y));
    most = std::max({ most, d.x, d.y, d.z });
    Check(std::isfinite(d.x + d.y + d.z), Text("pixel ", x, ", ", y, " is a number"));
  }
  return most;
}

class Stage
{
public:
  Stage()
  {
    this->Theatre.Pass->SetShadowMapResolution(256);
    this->Theatre.Renderer->SetBackground(0.1, 0.2, 0.3);
    this->Theatre.Look({ 0, 1, 10 }, { 0, 0, 0 });
    // In front, so that the thick fog is lit.
    this->Theatre.AddPointLight({ 1, 2, 9 }, { 20.0, 15.0, 10.0 });
    this->Clear = Draw(this->Theatre, 0.0);
    this->Foggy = Draw(this->Theatre, Thick);
  }

  // `limit` is of the largest radiance, about 1.
  void CheckHidden(const std::string& name, vtkVolume* volume, double limit = 1e-5)
  {
    ErrorListener warned(this->Theatre.Pass, vtkCommand::WarningEvent);
    this->Theatre.Renderer->AddVolume(volume);
    const double seen = GetLargestDifference(this->Theatre, this->Clear, Draw(this->Theatre, 0.0));
    Check(seen > 0.1, Text(name, " is seen in clear air: ", seen));
    const double hidden =
      GetLargestDifference(this->Theatre, this->Foggy, Draw(this->Theatre, Thick));
    std::cout << name << ": differs by " << seen << " in clear air, " << hidden << " in fog\n";
    Check(hidden <= limit, Text(name, " is hidden by fog: ", hidden));
    Check(warned.Take() == 0, name + ": no warnings: " + warned.GetText());
    this->Theatre.Renderer->RemoveVolume(volume);
  }

  Scene Theatre{ 80, 60 };
  vtkSmartPointer<vtkImageData> Clear;
  vtkSmartPointer<vtkImageData> Foggy;
};

template <typename Mapper>
vtkSmartPointer<vtkVolume> MakeVolume(const Slab& slab, int components = 1)
{
  vtkNew<Mapper> mapper;
  mapper->SetInputData(MakeSlabImage(slab, components));
  mapper->SetScalarModeToUseCellData();
  auto volume = vtkSmartPointer<vtkVolume>::New();
  volume->SetMapper(mapper);
  volume->SetProperty(MakeSlabProperty(slab));
  return volume;
}

vtkSmartPointer<vtkVolume> MakeVolume(int components = 1)
{
  Slab slab;
  slab.Step = 0.1;
  auto volume = MakeVolume<vtkGPUVolumeRayCastMapper>(slab, components);
  auto* mapper = vtkGPUVolumeRayCastMapper::SafeDownCast(volume->GetMapper());
  mapper->SetAutoAdjustSampleDistances(0);
  mapper->SetSampleDistance(0.1f);
  return volume;
}

vtkGPUVolumeRayCastMapper* GetMapper(vtkVolume* volume)
{
  return vtkGPUVolumeRayCastMapper::SafeDownCast(volume->GetMapper());
}

//------------------------------------------------------------------------------
void TestSamples(Stage& stage)
{
  stage.CheckHidden("one component", MakeVolume());
  auto two = MakeVolume(2);
  const auto property = MakeSlabProperty({});
  two->GetProperty()->SetColor(1, property->GetRGBTransferFunction(0));
  two->GetProperty()->SetScalarOpacity(1, property->GetScalarOpacity(0));
  stage.CheckHidden("independent components", two);
  auto four = MakeVolume(4);
  four->GetProperty()->IndependentComponentsOff();
  stage.CheckHidden("colours and opacity", four);
  auto shaded = MakeVolume();
  shaded->GetProperty()->ShadeOn();
  vtkNew<vtkPiecewiseFunction> gradient;
  gradient->AddPoint(0.0, 0.8);
  gradient->AddPoint(255.0, 1.0);
  shaded->GetProperty()->SetGradientOpacity(gradient);
  shaded->GetProperty()->SetAmbient(0.5);
  stage.CheckHidden("gradient opacity, shaded", shaded);
}

void TestBlendModes(Stage& stage)
{
  auto isosurface = MakeVolume();
  GetMapper(isosurface)->SetBlendModeToIsoSurface();
  isosurface->GetProperty()->GetIsoSurfaceValues()->SetValue(0, 75.0);
  stage.CheckHidden("isosurface", isosurface);
  auto slice = MakeVolume();
  GetMapper(slice)->SetBlendModeToSlice();
  vtkNew<vtkPlane> plane;
  plane->SetNormal(0.2, 0.0, 1.0);
  slice->GetProperty()->SetSliceFunction(plane);
  stage.CheckHidden("slice", slice);
}

void TestMappers(Stage& stage)
{
  auto coarse = MakeVolume();
  GetMapper(coarse)->SetImageSampleDistance(2.0f);
  stage.CheckHidden("half the resolution", coarse, EightBits);
  auto level = MakeVolume();
  GetMapper(level)->SetFinalColorWindow(0.5f);
  GetMapper(level)->SetFinalColorLevel(0.4f);
  GetMapper(level)->UseJitteringOn();
  stage.CheckHidden("window and level, jittered", level);
  stage.CheckHidden("smart mapper", MakeVolume<vtkSmartVolumeMapper>({}));
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  vtkNew<vtkMultiVolume> several;
  several->SetMapper(mapper);
  for (int i = 0; i < 2; ++i)
  {
    Slab slab;
    slab.High.z -= 1.2 * i;
    mapper->SetInputDataObject(i, MakeSlabImage(slab));
    several->SetVolume(MakeVolume(), i);
  }
  mapper->SetScalarModeToUseCellData();
  stage.CheckHidden("several volumes", several);
  stage.Theatre.Renderer->GetActiveCamera()->SetPosition(0, 1, 10);
}

void TestPeeled(Stage& stage)
{
  stage.Theatre.Window->SetAlphaBitPlanes(1);
  stage.Theatre.Renderer->UseDepthPeelingOn();
  stage.Theatre.Renderer->UseDepthPeelingForVolumesOn();
  stage.CheckHidden("peeled", MakeVolume(), EightBits);
  stage.Theatre.Renderer->UseDepthPeelingOff();
  stage.Theatre.Renderer->UseDepthPeelingForVolumesOff();
}

//------------------------------------------------------------------------------
// Is seen through the fog, with one warning.
void CheckUnfogged(const std::string& name, vtkVolume* volume, const std::string& said)
{
  Stage stage;
  stage.Theatre.Renderer->AddVolume(volume);
  ErrorListener warned(stage.Theatre.Pass, vtkCommand::WarningEvent);
  Draw(stage.Theatre, 0.0);
  Check(warned.Take() == 0, name + ": clear air is no reason to warn");
  const auto foggy = Draw(stage.Theatre, Thick);
  Draw(stage.Theatre, Thick);
  Check(warned.Take() == 1, name + ": one warning");
  Check(warned.GetText().find(said) != std::string::npos,
    name + ": it says " + said + ": " + warned.GetText());
  Check(GetLargestDifference(stage.Theatre, stage.Foggy, foggy) > 0.1, name + " is drawn");
}

void TestUnfogged()
{
  auto projection = MakeVolume();
  GetMapper(projection)->SetBlendModeToMaximumIntensity();
  CheckUnfogged("maximum intensity", projection, "blend mode");
  vtkNew<vtkImageData> image; // which knows values of points alone
  image->SetDimensions(8, 8, 8);
  image->SetOrigin(-1.0, -1.0, -1.0);
  image->SetSpacing(0.3, 0.3, 0.3);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 1);
  std::fill_n(static_cast<unsigned char*>(image->GetScalarPointer()), 8 * 8 * 8, 100);
  vtkNew<vtkFixedPointVolumeRayCastMapper> mapper;
  mapper->SetInputData(image);
  auto fixed = MakeVolume();
  fixed->SetMapper(mapper);
  CheckUnfogged("fixed point", fixed, "vtkFixedPointVolumeRayCastMapper");
}
}

//------------------------------------------------------------------------------
int TestVolumeBlending(int, char*[])
{
  {
    Stage stage;
    TestSamples(stage);
    TestBlendModes(stage);
    TestMappers(stage);
    TestPeeled(stage);
  }
  TestUnfogged();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
