// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// More translucent fragments than a buffer of the graphics card holds: Mesa's software renderer has
// 128 MiB, which a volume over a large window exceeds. The medium is drawn nevertheless. Without
// shadows in the scene the picture is that of a pass without shadows; one warning says so. Rays
// through volumes get fewer nodes.

#include "AirlightTestErrors.h"
#include "AirlightTestScene.h"
#include "AirlightTestTools.h"

#include "vtkColorTransferFunction.h"
#include "vtkGPUVolumeRayCastMapper.h"
#include "vtkPiecewiseFunction.h"
#include "vtkPlaneSource.h"
#include "vtkVolume.h"
#include "vtkVolumeProperty.h"

#include <cstdlib>
#include <cstring>

using namespace airlight_test;

namespace
{
// Of so many records it is known that Mesa has no room.
bool IsMesa(Scene& scene)
{
  return std::strstr(scene.Window->ReportCapabilities(), "llvmpipe") != nullptr;
}

// Panes one behind another, over all of the picture; they neither cast nor show shadows.
void AddPanes(Scene& scene, int count)
{
  for (int i = 0; i < count; ++i)
  {
    vtkNew<vtkPlaneSource> plane;
    plane->SetOrigin(-30.0, -30.0, 0.2 * i);
    plane->SetPoint1(30.0, -30.0, 0.2 * i);
    plane->SetPoint2(-30.0, 30.0, 0.2 * i);
    vtkSmartPointer<vtkActor> pane = Scene::MakeActor(Make(plane));
    pane->GetProperty()->SetOpacity(0.02);
    pane->GetProperty()->SetLighting(false);
    vtkAirlightPass::SetCastsShadow(pane, false);
    scene.Renderer->AddActor(pane);
  }
}

void AddVolume(Scene& scene)
{
  vtkNew<vtkImageData> image;
  image->SetDimensions(4, 4, 4);
  image->SetOrigin(-30.0, -30.0, 0.0);
  image->SetSpacing(20.0, 20.0, 1.0);
  image->AllocateScalars(VTK_FLOAT, 1);
  image->GetPointData()->GetScalars()->Fill(1.0);
  vtkNew<vtkGPUVolumeRayCastMapper> mapper;
  mapper->SetInputData(image);
  mapper->SetAutoAdjustSampleDistances(false);
  mapper->SetSampleDistance(0.5f);
  vtkNew<vtkPiecewiseFunction> opacity;
  opacity->AddPoint(0.0, 0.05);
  opacity->AddPoint(2.0, 0.05);
  vtkNew<vtkColorTransferFunction> colour;
  colour->AddRGBPoint(1.0, 0.2, 0.4, 0.8);
  vtkNew<vtkVolume> volume;
  volume->SetMapper(mapper);
  volume->GetProperty()->SetScalarOpacity(opacity);
  volume->GetProperty()->SetColor(colour);
  vtkAirlightPass::SetCastsShadow(volume, false);
  scene.Renderer->AddVolume(volume);
}

// One in 7 x 7 pixels.
double GetLargestDifference(Scene& scene, vtkImageData* expected)
{
  vtkImageData* radiance = scene.GetBuffer("Radiance");
  double largest = 0.0;
  for (int y = 0; y < scene.Height; y += 7)
  {
    for (int x = 0; x < scene.Width; x += 7)
    {
      const glm::dvec3 a = GetColour(radiance, x, y);
      const glm::dvec3 b = GetColour(expected, x, y);
      largest = std::max(largest, glm::length(a - b) / std::max(glm::length(b), 1e-6));
    }
  }
  return largest;
}

// Draws with shadows, of which there are none, and without. `warnings`: with Mesa.
void TestScene(Scene& scene, const std::string& name, int warnings, double limit)
{
  ErrorListener errors(scene.Pass);
  ErrorListener warned(scene.Pass, vtkCommand::WarningEvent);
  scene.AddPointLight({ 2, 4, 12 }, { 40.0, 30.0, 20.0 });
  scene.Pass->SetShadowTechniqueToNone();
  scene.Window->Render();
  vtkNew<vtkImageData> expected;
  expected->DeepCopy(scene.GetBuffer("Radiance"));
  warned.Take();
  scene.Pass->SetShadowTechniqueToShadowPlanes();
  scene.Window->Render();
  scene.Window->Render();
  const int count = warned.Take();
  Check(count == (IsMesa(scene) ? warnings : count), Text(name, ": ", count, " warnings"));
  Check(count == 0 || warned.GetText().find("translucent fragments") != std::string::npos,
    name + ": the warning says why: " + warned.GetText());
  Check(errors.Take() == 0, name + ": no error");
  const double largest = GetLargestDifference(scene, expected);
  Check(largest < limit, Text(name, ": differs by ", largest));
  scene.Medium->SetScattering(0.0, 0.0, 0.0);
  scene.Window->Render();
  Check(GetLargestDifference(scene, expected) > 0.1, name + ": the medium is seen");
}
}

//------------------------------------------------------------------------------
int TestTranslucentOverflow(int, char*[])
{
  Scene panes(480, 360);
  AddPanes(panes, 22); // 3.8 million fragments of 40 bytes
  TestScene(panes, "panes", 1, 1e-4);
  Scene volume(560, 440);
  AddVolume(volume); // 3.9 million nodes
  TestScene(volume, "volume", 0, 2e-3);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
