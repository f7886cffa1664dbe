// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightReference and images of density with bad input: errors that an observer sees and that
// name what is wrong, what is kept, warnings of what is not computed, progress and abort.

#include "AirlightTestCheck.h"
#include "AirlightTestErrors.h"

#include "vtkActor.h"
#include "vtkAirlight.h"
#include "vtkAirlightPass.h"
#include "vtkAirlightPolyDataMapper.h"
#include "vtkAirlightReference.h"
#include "vtkCallbackCommand.h"
#include "vtkCamera.h"
#include "vtkDoubleArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkPointData.h"
#include "vtkPolyDataMapper.h"
#include "vtkProperty.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"
#include "vtkSphereSource.h"
#include "vtkTexture.h"
#include "vtkVolume.h"

#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>

using airlight_test::Check;
using airlight_test::ErrorListener;
using airlight_test::Failures;

namespace
{
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

void CheckText(ErrorListener& listener, const std::string& part, const std::string& what)
{
  Check(listener.Take() == 1, what + ": one message");
  Check(listener.GetText().find(part) != std::string::npos,
    what + ": it says '" + part + "', not: " + listener.GetText());
}

vtkSmartPointer<vtkImageData> MakeImage(int side)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(side, side, side);
  image->AllocateScalars(VTK_DOUBLE, 1);
  image->GetPointData()->GetScalars()->SetName("soot");
  image->GetPointData()->GetScalars()->Fill(1.0);
  return image;
}

//------------------------------------------------------------------------------
void CheckImages()
{
  vtkNew<vtkParticipatingMedium> medium;
  ErrorListener errors(medium);
  const vtkSmartPointer<vtkImageData> good = MakeImage(3);
  medium->SetDensityImage(good);
  Check(errors.Take() == 0, "a good image is no error");
  const auto refuse = [&](
                        const std::string& part, const std::function<void(vtkImageData*)>& spoil) {
    const vtkSmartPointer<vtkImageData> bad = MakeImage(3);
    spoil(bad);
    medium->SetDensityImage(bad);
    CheckText(errors, part, part);
    Check(medium->GetDensityImage() == good, part + ": the old image stays");
  };
  refuse("0 x 0 x 0", [](vtkImageData* image) { image->Initialize(); });
  refuse("3 x 3 x 1", [](vtkImageData* image) { image->SetDimensions(3, 3, 1); });
  refuse("no point scalars", [](vtkImageData* image) { image->GetPointData()->Initialize(); });
  refuse("2 components", [](vtkImageData* image) { image->AllocateScalars(VTK_FLOAT, 2); });
  refuse("'soot' of 27 values", [](vtkImageData* image) { image->SetDimensions(4, 3, 3); });
  refuse("the value -0.5 at point 4 of its scalars 'soot'",
    [](vtkImageData* image) { image->GetPointData()->GetScalars()->SetComponent(4, 0, -0.5); });
  refuse("the value nan at point 26",
    [](vtkImageData* image) { image->GetPointData()->GetScalars()->SetComponent(26, 0, nan); });
  refuse("the value inf at point 0",
    [](vtkImageData* image) { image->GetPointData()->GetScalars()->SetComponent(0, 0, HUGE_VAL); });
  refuse("the spacing (1, 0, 1)", [](vtkImageData* image) { image->SetSpacing(1, 0, 1); });
  refuse("the origin (0, nan, 0)", [](vtkImageData* image) { image->SetOrigin(0, nan, 0); });

  medium->SetAbsorption(1, 1, 1);
  medium->SetDensityToImage();
  const double a[3] = { -1, 1, 1 };
  const double b[3] = { 3, 1, 1 };
  double rgb[3];
  good->GetPointData()->GetScalars()->SetComponent(13, 0, -1.0);
  good->Modified();
  vtkAirlight::Transmittance(medium, a, b, rgb);
  CheckText(errors, "the value -1 at point 13", "an image that becomes bad");
  Check(rgb[0] == 1.0, "a medium with a bad image is nowhere");
  medium->SetDensityImage(nullptr);
  vtkAirlight::Transmittance(medium, a, b, rgb);
  vtkAirlight::Transmittance(medium, a, b, rgb);
  CheckText(errors, "call SetDensityImage()", "no image");
  Check(rgb[0] == 1.0, "a medium without image is nowhere");
  medium->SetDensity(3);
  CheckText(errors, "Density 3", "no such density");
  Check(medium->GetDensity() == vtkParticipatingMedium::IMAGE, "the density stays");
}

//------------------------------------------------------------------------------
// The mapper says that it does not draw images, and draws the scene without.
void CheckRendering()
{
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetAbsorption(1, 1, 1);
  medium->SetDensityImage(MakeImage(2));
  medium->SetDensityToImage();
  vtkNew<vtkAirlightPolyDataMapper> mapper;
  vtkNew<vtkSphereSource> sphere;
  mapper->SetInputConnection(sphere->GetOutputPort());
  mapper->AddMedium(medium);
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkRenderer> renderer;
  renderer->AddActor(actor);
  vtkNew<vtkRenderWindow> window;
  window->SetOffScreenRendering(1);
  window->SetSize(20, 20);
  window->AddRenderer(renderer);
  ErrorListener ofMapper(mapper);
  window->Render();
  CheckText(ofMapper, "medium 0 has its density from an image", "the mapper");
  vtkNew<vtkAirlightPass> pass;
  pass->SetMedium(medium);
  ErrorListener ofPass(pass);
  renderer->SetPass(pass);
  window->Render();
  Check(ofPass.Take() == 0, "the pass draws images: TestDensityPassErrors");
}

//------------------------------------------------------------------------------
void CheckSettings()
{
  vtkNew<vtkAirlightReference> reference;
  ErrorListener errors(reference);
  reference->SetSize(-1, 20);
  CheckText(errors, "Size -1 x 20", "a negative size");
  reference->SetSize(0, 20);
  CheckText(errors, "Size 0 x 20", "half a size");
  reference->SetSize(40000, 20);
  CheckText(errors, "Size 40000 x 20", "a huge size");
  Check(reference->GetSize()[0] == 0 && reference->GetSize()[1] == 0, "the size stays");
  reference->SetLightRadius(nan);
  CheckText(errors, "LightRadius nan", "no radius");
  reference->SetLightRadius(-1.0);
  CheckText(errors, "LightRadius -1", "a negative radius");
  reference->SetLightScatters(nullptr, false);
  CheckText(errors, "needs a light", "no light");
  Check(reference->GetMedium(0) == nullptr, "there is no medium");
  CheckText(errors, "Medium 0", "no medium");
  reference->AddMedium(nullptr);
  Check(reference->GetNumberOfMedia() == 0 && errors.Take() == 0, "null is ignored");
}

//------------------------------------------------------------------------------
void CheckScenes()
{
  vtkNew<vtkAirlightReference> reference;
  ErrorListener errors(reference);
  const auto fail = [&](const std::string& part) {
    reference->Modified();
    reference->Update();
    Check(errors.Take() >= 1, part + ": an error");
    Check(reference->GetOutput()->GetNumberOfPoints() == 0, part + ": no picture");
  };
  fail("no renderer");
  vtkNew<vtkRenderer> renderer;
  reference->SetRenderer(renderer);
  fail("no size");
  reference->SetSize(8, 6);
  vtkNew<vtkParticipatingMedium> media[9];
  for (auto& medium : media)
  {
    reference->AddMedium(medium);
  }
  fail("nine media");
  reference->RemoveMedium(media[0]);
  Check(reference->GetNumberOfMedia() == 8, "eight media");
  renderer->GetActiveCamera()->SetPosition(nan, 0, 0);
  fail("no camera");
  renderer->GetActiveCamera()->SetPosition(0, 0, 5);

  // An empty scene, with the light that VTK would make.
  ErrorListener warnings(reference, vtkCommand::WarningEvent);
  reference->Update();
  Check(errors.Take() == 0 && warnings.Take() == 0, "an empty scene is no error");
  Check(reference->GetOutput()->GetNumberOfPoints() == 48, "48 pixels");
  Check(renderer->GetLights()->GetNumberOfItems() == 1, "a light is made");

  // What is not computed is named.
  vtkNew<vtkVolume> volume;
  renderer->AddVolume(volume);
  vtkNew<vtkSphereSource> sphere;
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(sphere->GetOutputPort());
  vtkNew<vtkActor> actor;
  actor->SetMapper(mapper);
  vtkNew<vtkTexture> texture;
  actor->SetTexture(texture);
  renderer->AddActor(actor);
  reference->Update();
  CheckText(
    warnings, "textures without an image or without coordinates, vtk", "volumes and textures");
  actor->SetTexture(nullptr);
  volume->VisibilityOff();
  actor->GetProperty()->SetInterpolationToPBR();
  reference->Update();
  CheckText(warnings, "physically based shading", "physically based shading");
  actor->GetProperty()->SetInterpolationToGouraud();
  vtkNew<vtkLight> light;
  light->SetPosition(nan, 0, 0);
  light->PositionalOn();
  renderer->AddLight(light);
  reference->Update();
  CheckText(warnings, "A light is left out", "a light that is nowhere");
  auto* radiance =
    vtkDoubleArray::SafeDownCast(reference->GetOutput()->GetPointData()->GetScalars());
  bool finite = true;
  for (vtkIdType i = 0; i < radiance->GetNumberOfValues(); ++i)
  {
    finite = finite && std::isfinite(radiance->GetValue(i));
  }
  Check(finite, "it makes nothing infinite");
}

//------------------------------------------------------------------------------
// Ends the work at half of it.
void CheckProgress()
{
  vtkNew<vtkRenderer> renderer;
  renderer->SetBackground(0.5, 0.5, 0.5);
  vtkNew<vtkAirlightReference> reference;
  reference->SetRenderer(renderer);
  reference->SetSize(4, 100);
  struct Watch
  {
    double Last = -1.0;
    int Calls = 0;
    bool Ascends = true;
    bool Abort = false;
  } watch;
  vtkNew<vtkCallbackCommand> command;
  command->SetClientData(&watch);
  command->SetCallback([](vtkObject* caller, unsigned long, void* data, void* progress) {
    auto* seen = static_cast<Watch*>(data);
    const double now = *static_cast<double*>(progress);
    seen->Ascends = seen->Ascends && now >= seen->Last;
    seen->Last = now;
    ++seen->Calls;
    if (seen->Abort && now >= 0.5)
    {
      static_cast<vtkAlgorithm*>(caller)->SetAbortExecute(1);
    }
  });
  reference->AddObserver(vtkCommand::ProgressEvent, command);
  reference->Update();
  Check(watch.Calls > 20 && watch.Ascends && watch.Last == 1.0, "progress is reported, up to 1");
  vtkDataArray* radiance = reference->GetOutput()->GetPointData()->GetArray("Radiance");
  Check(radiance->GetComponent(399, 0) == 0.5, "the background is seen");
  watch = Watch();
  watch.Abort = true;
  reference->Modified();
  reference->Update();
  Check(watch.Calls > 20 && watch.Calls < 45, "it ends before all is done");
  Check(reference->GetOutput()->GetNumberOfPoints() == 0, "no picture after an abort");
  reference->SetAbortExecute(0);
  reference->Modified();
  watch.Abort = false;
  reference->Update();
  radiance = reference->GetOutput()->GetPointData()->GetArray("Radiance");
  Check(radiance->GetComponent(399, 0) == 0.5, "all is there afterwards");
}
}

int TestAirlightReferenceErrors(int, char*[])
{
  CheckImages();
  CheckSettings();
  CheckScenes();
  CheckProgress();
  CheckRendering();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
