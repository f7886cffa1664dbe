// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Random calls on the pass, media, lights and actors between frames of a small window: none crashes,
// and no pixel of a finite scene is anything but a number.

#include "AirlightFuzzScene.h"

#include "vtkActor.h"
#include "vtkAirlightPass.h"
#include "vtkCamera.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkRenderWindow.h"
#include "vtkRenderer.h"

using namespace airlight_fuzz;

namespace
{
// One window for all inputs.
vtkRenderWindow* GetWindow()
{
  static const vtkNew<vtkRenderWindow> window;
  window->SetSize(16, 12);
  window->SetMultiSamples(0);
  window->OffScreenRenderingOn();
  return window;
}

void CheckBuffers(vtkAirlightPass* pass)
{
  for (const char* name : { "Radiance", "Airlight", "Surface", "Transmittance", "Depth",
         "LitLength", "BoundaryCount", "ErrorBound" })
  {
    if (vtkImageData* buffer = pass->GetBuffer(name))
    {
      RequireFinite(buffer, name);
    }
  }
}
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  Input input(data, size);
  vtkRenderWindow* window = GetWindow();
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkAirlightPass> pass;
  vtkNew<vtkParticipatingMedium> medium;
  vtkNew<vtkLight> light;
  medium->SetScattering(0.1, 0.2, 0.3);
  light->SetPositional(true);
  light->SetPosition(0.0, 3.0, 1.0);
  pass->SetMedium(medium);
  pass->SetLightScatters(light, true); // of any type
  pass->RecordBuffersOn();
  renderer->AutomaticLightCreationOff();
  renderer->AddLight(light);
  renderer->SetPass(pass);
  window->AddRenderer(renderer);
  for (int frame = 0; frame < 3 && (frame == 0 || input.HasMore()); ++frame)
  {
    for (int i = input.Integer(0, 4); i > 0; --i)
    {
      switch (input.Integer(0, 4))
      {
        case 0:
          ChangeMedium(input, medium);
          break;
        case 1:
          ChangeLight(input, light);
          break;
        case 2:
          renderer->AddActor(MakeActor(input));
          break;
        case 3:
          renderer->GetActiveCamera()->SetPosition(input.Point().data());
          break;
        default:
          ChangePass(input, pass, medium, light);
      }
    }
    window->Render();
    if (input.IsModest())
    {
      CheckBuffers(pass);
    }
  }
  renderer->SetPass(nullptr);
  pass->ReleaseGraphicsResources(window);
  window->RemoveRenderer(renderer);
  return 0;
}
