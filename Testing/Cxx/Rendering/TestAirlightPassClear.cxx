// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass without a medium or with a clear one: VTK's own picture, whatever the shading.

#include "AirlightTestScene.h"

#include "vtkElevationFilter.h"
#include "vtkLightKit.h"
#include "vtkPlaneSource.h"
#include "vtkTexture.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
// Without a medium, and with one that is clear, the picture is VTK's own to the last step.
void CheckPlain(const std::string& name, Scene& scene)
{
  scene.Pass->RecordBuffersOff();
  scene.Pass->SetShadowTechniqueToNone();
  scene.Renderer->SetPass(nullptr);
  const Picture plain = Capture(scene.Window);
  scene.Renderer->SetPass(scene.Pass);
  scene.Pass->RemoveAllMedia();
  const int without = Compare(plain, Capture(scene.Window));
  vtkNew<vtkParticipatingMedium> clear;
  scene.Pass->SetMedium(clear);
  const int withClear = Compare(plain, Capture(scene.Window));
  std::cout << name << ": differs by " << without << ", clear medium " << withClear << "\n";
  Check(without <= 1, name + ": without medium the picture is VTK's");
  Check(withClear <= 1, name + ": with a clear medium the picture is VTK's");
  Check(
    *std::max_element(plain.begin(), plain.end()) > 100, name + ": the picture shows something");
}

void AddShinySphere(Scene& scene)
{
  vtkProperty* property = scene.Add(MakeSphere(1.5))->GetProperty();
  property->SetInterpolationToPhong();
  property->SetColor(0.9, 0.5, 0.2);
  property->SetAmbient(0.1);
  property->SetSpecular(0.6);
  property->SetSpecularPower(20.0);
}

void TestPlainLook()
{
  {
    Scene scene;
    AddShinySphere(scene);
    scene.AddPointLight({ 3, 3, 3 }, { 20, 20, 20 });
    scene.AddDirectionalLight({ -1, 1, 2 }, { 1, 1, 1.5 });
    CheckPlain("specular sphere, two lights", scene);
  }
  {
    Scene scene;
    AddShinySphere(scene);
    vtkNew<vtkLightKit> kit;
    kit->AddLightsToRenderer(scene.Renderer);
    CheckPlain("light kit", scene);
  }
  {
    Scene scene;
    AddShinySphere(scene);
    scene.Renderer->AutomaticLightCreationOn();
    scene.Renderer->SetBackground(0.1, 0.2, 0.3);
    CheckPlain("headlight made by the renderer", scene);
  }
  for (const bool peel : { false, true })
  {
    Scene scene;
    AddShinySphere(scene);
    scene.Add(MakeSphere(0.8), [](vtkActor* actor) { actor->SetPosition(1, 1, 2); })
      ->GetProperty()
      ->SetOpacity(0.4);
    scene.Renderer->SetUseDepthPeeling(peel);
    scene.Renderer->SetBackground(0.1, 0.2, 0.3);
    scene.AddPointLight({ 3, 3, 3 }, { 20, 20, 20 });
    CheckPlain(peel ? "translucent sphere, peeled" : "translucent sphere", scene);
  }
  {
    Scene scene;
    vtkNew<vtkElevationFilter> elevation;
    elevation->SetInputData(MakeSphere(1.5));
    elevation->SetLowPoint(0, -1.5, 0);
    elevation->SetHighPoint(0, 1.5, 0);
    elevation->Update();
    scene.Add(elevation->GetPolyDataOutput())->GetMapper()->ScalarVisibilityOn();
    scene.AddDirectionalLight({ -1, 1, 2 });
    CheckPlain("colours by point", scene);
  }
  {
    Scene scene;
    vtkNew<vtkImageData> image;
    image->SetDimensions(16, 16, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    for (int i = 0; i < 3 * 16 * 16; ++i)
    {
      static_cast<unsigned char*>(image->GetScalarPointer())[i] =
        static_cast<unsigned char>((i * i * 7) % 256);
    }
    vtkNew<vtkTexture> texture;
    texture->SetInputData(image);
    vtkNew<vtkPlaneSource> plane;
    scene.Add(plane, [](vtkActor* actor) { actor->SetScale(4.0); })->SetTexture(texture);
    scene.AddPointLight({ 1, 1, 3 }, { 20, 20, 20 });
    CheckPlain("texture", scene);
  }
}
}

//------------------------------------------------------------------------------
int TestAirlightPassClear(int, char*[])
{
  TestPlainLook();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
