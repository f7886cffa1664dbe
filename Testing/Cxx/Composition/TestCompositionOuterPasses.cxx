// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// VTK's passes around the pass, tone mapping and antialiasing apart: they get its colours and its
// depths; what cannot be is said.

#include "AirlightTestComposition.h"
#include "AirlightTestErrors.h"

#include "vtkDepthOfFieldPass.h"
#include "vtkEDLShading.h"
#include "vtkGaussianBlurPass.h"
#include "vtkOverlayPass.h"
#include "vtkRenderPassCollection.h"
#include "vtkRenderStepsPass.h"
#include "vtkSSAOPass.h"
#include "vtkSequencePass.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkToneMappingPass.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
//------------------------------------------------------------------------------
// Around the pass in clear air as around VTK's own steps.
void CheckClear(
  Composition& scene, vtkImageProcessingPass* outside, int limit, const std::string& name)
{
  scene.SetClear();
  vtkNew<vtkRenderStepsPass> steps;
  const Picture bare = scene.Show(steps);
  outside->SetDelegatePass(steps);
  const Picture own = scene.Show(outside);
  outside->SetDelegatePass(scene.Pass);
  const int difference = Compare(scene.Show(outside), own);
  const int effect = CountApart(own, bare, 8);
  std::cout << name << ": differs by " << difference << ", effect in " << effect << " values\n";
  Check(difference <= limit, name + ": in clear air VTK's picture");
  Check(effect > 500, name + ": there is an effect");
  outside->ReleaseGraphicsResources(scene.Window);
  scene.SetFoggy();
}

//------------------------------------------------------------------------------
// How far a pixel is from what is between the plain picture's around it, in steps of 1/255.
int GetDistance(const Picture& plain, const Picture& shown, int width, int x, int y)
{
  int distance = 0;
  for (int c = 0; c < 3; ++c)
  {
    int least = 255;
    int most = 0;
    for (int k = 0; k < 9; ++k)
    {
      const int value = plain[3 * ((y - 1 + k / 3) * width + x - 1 + k % 3) + c];
      least = std::min(least, value);
      most = std::max(most, value);
    }
    const int value = shown[3 * (y * width + x) + c];
    distance = std::max({ distance, least - value, value - most });
  }
  return distance;
}

//------------------------------------------------------------------------------
// The wall is in focus: it keeps its pixels, the edges of shadows among them, where nothing nearer
// is within the blur's reach of 9 pixels. The ball before it is blurred. The target that VTK gives
// the pass is larger, by as much at each side: in a square window its pixels have the same rays.
// VTK then takes the picture from it by less than a pixel beside its pixels, so a value may be any
// between those of its neighbours.
void CheckFocus(Composition& scene)
{
  scene.SetFoggy();
  vtkNew<vtkPlaneSource> wall;
  wall->SetOrigin(-9.0, -9.0, -4.0);
  wall->SetPoint1(9.0, -9.0, -4.0);
  wall->SetPoint2(-9.0, 9.0, -4.0);
  scene.Add(wall);
  scene.Floor->VisibilityOff();
  scene.Box->VisibilityOff();
  scene.Look({ 0.0, 0.0, 10.0 }, { 0.0, 0.0, 0.0 });
  scene.Renderer->GetActiveCamera()->SetViewAngle(30.0);
  scene.Renderer->GetActiveCamera()->SetClippingRange(1.0, 40.0);
  scene.Renderer->GetActiveCamera()->SetFocalPoint(0.0, 0.0, -4.0);
  scene.Renderer->GetActiveCamera()->SetFocalDisk(3.0);
  const Picture plain = scene.Show(scene.Pass);
  vtkSmartPointer<vtkImageData> depth = scene.CopyBuffers()["Depth"];
  vtkNew<vtkDepthOfFieldPass> field;
  field->AutomaticFocalDistanceOff();
  field->SetDelegatePass(scene.Pass);
  const Picture shown = scene.Show(field);
  field->ReleaseGraphicsResources(scene.Window);
  int sharp = 0;
  int blurred = 0;
  int largest = 0;
  const int reach = 10;
  for (int y = reach; y < scene.Height - reach; ++y)
  {
    for (int x = reach; x < scene.Width - reach; ++x)
    {
      bool wallOnly = true;
      for (int k = 0; k < (2 * reach + 1) * (2 * reach + 1) && wallOnly; ++k)
      {
        const int i = x - reach + k % (2 * reach + 1);
        const int j = y - reach + k / (2 * reach + 1);
        wallOnly = GetValue(depth, i, j) > 13.9;
      }
      const int difference = GetDistance(plain, shown, scene.Width, x, y);
      largest = wallOnly ? std::max(largest, difference) : largest;
      sharp += wallOnly ? 1 : 0;
      blurred += !wallOnly && difference > 4 ? 1 : 0;
    }
  }
  std::cout << "depth of field: " << sharp << " pixels in focus differ by " << largest << ", "
            << blurred << " others are blurred\n";
  Check(sharp > 1000 && largest <= 1, "depth of field: what is in focus is the plain picture");
  Check(blurred > 200, "depth of field: what is not is blurred");
}

//------------------------------------------------------------------------------
// Drawn last, annotations are those of the pass alone, and nothing outside touches them.
void CheckAnnotations(Composition& scene)
{
  vtkNew<vtkTextActor> text;
  text->SetInput("Airlight");
  text->GetTextProperty()->SetFontSize(24);
  text->SetPosition(10.0, 80.0);
  vtkNew<vtkGaussianBlurPass> blur;
  blur->SetDelegatePass(scene.Pass);
  vtkNew<vtkSequencePass> sequence;
  vtkNew<vtkRenderPassCollection> passes;
  vtkNew<vtkOverlayPass> overlay;
  passes->AddItem(blur);
  passes->AddItem(overlay);
  sequence->SetPasses(passes);
  const Picture bare = scene.Show(blur);
  scene.Renderer->AddActor(text);
  const Picture blurred = scene.Show(blur);
  scene.Pass->AnnotationsOff();
  Check(Compare(scene.Show(blur), bare) == 0, "no annotations on request");
  const Picture last = scene.Show(sequence);
  scene.Pass->AnnotationsOn();
  // White text: sharp edges have more values that are white.
  const auto white = [](const Picture& picture) {
    return std::count_if(picture.begin(), picture.end(), [](int value) { return value > 250; });
  };
  std::cout << "annotations: " << white(bare) << ", blurred " << white(blurred) << ", last "
            << white(last) << " white values\n";
  Check(white(last) > white(blurred) + 100, "annotations drawn last are not blurred");
  scene.Renderer->RemoveActor(text);
  blur->ReleaseGraphicsResources(scene.Window);
  scene.Renderer->SetPass(nullptr);
}

//------------------------------------------------------------------------------
void CheckWarnings(Composition& scene)
{
  ErrorListener warnings(scene.Pass, vtkCommand::WarningEvent);
  scene.Renderer->UseFXAAOn();
  vtkNew<vtkToneMappingPass> tone;
  tone->SetDelegatePass(scene.Pass);
  scene.Show(tone);
  scene.Show(tone);
  Check(warnings.Take() == 1 &&
      warnings.GetText().find("vtkOpenGLFXAAPass the outermost") != std::string::npos,
    "FXAA in a target of floating point is left out, with a warning: " + warnings.GetText());
  tone->ReleaseGraphicsResources(scene.Window);
  scene.Show(scene.Pass);
  Check(warnings.Take() == 0, "no warning without tone mapping");
  scene.Renderer->UseFXAAOff();
  vtkNew<vtkSSAOPass> occlusion;
  occlusion->SetDelegatePass(scene.Pass);
  scene.Show(occlusion);
  Check(
    warnings.Take() == 1 && warnings.GetText().find("SetDelegatePass(ssao)") != std::string::npos,
    "SSAO outside is warned of: " + warnings.GetText());
  occlusion->ReleaseGraphicsResources(scene.Window);
}
}

//------------------------------------------------------------------------------
int TestCompositionOuterPasses(int, char*[])
{
  Composition scene(120, 120);
  scene.Renderer->GetActiveCamera()->SetFocalDisk(0.02);
  // VTK rounds what its passes get to 8 bits; one value of 1/255 at an edge of depth may change the
  // weights of a blur, which are 1 in sum.
  CheckClear(scene, vtkNew<vtkEDLShading>().Get(), 1, "EDL");
  CheckClear(scene, vtkNew<vtkGaussianBlurPass>().Get(), 1, "blur");
  CheckClear(scene, vtkNew<vtkDepthOfFieldPass>().Get(), 1, "depth of field");
  CheckAnnotations(scene);
  CheckFocus(scene);
  CheckWarnings(scene);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
