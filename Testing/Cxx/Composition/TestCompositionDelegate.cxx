// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// A delegate that draws everything at once, by itself: the pass has it draw the surfaces, and fogs
// what blends over them as without a delegate.

#include "AirlightTestComposition.h"

#include "vtkCameraPass.h"
#include "vtkDualDepthPeelingPass.h"
#include "vtkObjectFactory.h"
#include "vtkRenderState.h"
#include "vtkRenderStepsPass.h"
#include "vtkTextActor.h"
#include "vtkTextProperty.h"
#include "vtkTranslucentPass.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
// Draws the renderer's own list of props, as ParaView's pass does.
class ListPass : public vtkRenderPass
{
public:
  static ListPass* New();
  vtkTypeMacro(ListPass, vtkRenderPass);

  void Render(const vtkRenderState* s) override
  {
    vtkRenderer* renderer = s->GetRenderer();
    this->ClearLights(renderer);
    this->UpdateLightGeometry(renderer);
    this->UpdateLights(renderer);
    this->UpdateGeometry(renderer, s->GetFrameBuffer());
  }
};

vtkStandardNewMacro(ListPass);

//------------------------------------------------------------------------------
vtkSmartPointer<vtkTextActor> MakeText()
{
  auto text = vtkSmartPointer<vtkTextActor>::New();
  text->SetInput("Airlight");
  text->GetTextProperty()->SetFontSize(24);
  text->SetPosition(10.0, 80.0);
  return text;
}

// The fogged pixels are those of a picture without a delegate. `limit` in steps of 1/255.
void CheckSame(Composition& scene, vtkRenderPass* delegate, int limit, const std::string& what)
{
  scene.Pass->SetDelegatePass(nullptr);
  const Picture own = scene.Show(scene.Pass);
  scene.Pass->SetDelegatePass(delegate);
  const int difference = Compare(scene.Show(scene.Pass), own);
  std::cout << what << ": differs by " << difference << "\n";
  Check(difference <= limit, what + ": as without a delegate");
  scene.Pass->SetDelegatePass(nullptr);
  delegate->ReleaseGraphicsResources(scene.Window);
}

// In clear air, what the delegate shows without the pass.
void CheckClear(Composition& scene, vtkRenderPass* delegate, int limit, const std::string& what)
{
  scene.SetClear();
  const Picture own = scene.Show(delegate);
  scene.Pass->SetDelegatePass(delegate);
  const int difference = Compare(scene.Show(scene.Pass), own);
  std::cout << what << ", clear: differs by " << difference << "\n";
  Check(difference <= limit, what + ": in clear air the delegate's picture");
  scene.Pass->SetDelegatePass(nullptr);
  delegate->ReleaseGraphicsResources(scene.Window);
  scene.SetFoggy();
}

// Translucency shows, and the fog before it.
void CheckShows(Composition& scene, vtkProp* prop)
{
  const Picture with = scene.Show(scene.Pass);
  prop->VisibilityOff();
  Check(CountApart(scene.Show(scene.Pass), with, 8) > 500, "translucent surfaces show");
  prop->VisibilityOn();
}
}

//------------------------------------------------------------------------------
int TestCompositionDelegate(int, char*[])
{
  Composition scene;
  scene.SetFoggy();
  const double intensity[3] = { 20.0, 17.0, 13.0 }; // the ball is close to the lamp
  vtkAirlight::SetRadiantIntensity(scene.Lamp, intensity);
  const vtkSmartPointer<vtkTextActor> text = MakeText();
  scene.Renderer->AddActor(text);

  // Annotations are drawn once, over the medium.
  vtkNew<vtkRenderStepsPass> steps;
  CheckSame(scene, steps, 0, "annotations");

  // One convex surface is two layers. In 8 bits VTK rounds each and what is behind, the pass in
  // single precision once: 1.5 and 0.5 steps.
  scene.AddTranslucentBall();
  CheckShows(scene, scene.Renderer->GetActors()->GetLastActor());
  vtkNew<vtkTranslucentPass> translucent;
  vtkNew<vtkDualDepthPeelingPass> peeling;
  peeling->SetTranslucentPass(translucent);
  steps->SetTranslucentPass(peeling);
  scene.Renderer->UseDepthPeelingOn();
  scene.Renderer->SetMaximumNumberOfPeels(peeling->GetMaximumNumberOfPeels());
  CheckSame(scene, steps, 0, "a delegate's depth peeling");
  scene.Renderer->UseDepthPeelingOff();
  CheckClear(scene, steps, 2, "a delegate's depth peeling");
  steps->SetTranslucentPass(translucent);
  CheckClear(scene, steps, 2, "a delegate's plain blending");

  // A delegate that does not draw what it is given: translucent actors are fogged by themselves
  // nevertheless.
  vtkNew<vtkCameraPass> camera;
  vtkNew<ListPass> list;
  camera->SetDelegatePass(list);
  scene.Renderer->RemoveActor(text);
  CheckSame(scene, camera, 0, "the renderer's list, order-independent");
  scene.Renderer->UseDepthPeelingOn();
  CheckSame(scene, camera, 0, "the renderer's list, peeled");
  scene.Renderer->UseDepthPeelingOff();
  CheckClear(scene, camera, 2, "the renderer's list");
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
