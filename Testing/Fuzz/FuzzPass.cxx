// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Random calls on the pass without a window, and the silhouettes that another process sends: bytes
// from outside.

#include "AirlightFuzzScene.h"

#include "vtkAirlightPass.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkRenderer.h"
#include "vtkUnsignedCharArray.h"

#include <algorithm>
#include <sstream>

using namespace airlight_fuzz;

namespace
{
void AskPass(Input& input, vtkAirlightPass* pass, vtkLight* light)
{
  pass->GetMedium(input.Integer(-1, 4));
  pass->GetEffectiveShadowTechnique();
  pass->GetLightScatters(light);
  Require(!pass->GetLightPhotometry(light), "no file was good");
  double values[3] = { pass->GetLightPhotometryMaximum(light) };
  RequirePositive(values, 1, "the largest intensity");
  pass->GetLightPhotometryUp(light, values);
  RequireFinite(values, 3, "the direction up");
  Require(!pass->GetBuffer("Radiance"), "no buffer before the first frame");
  std::ostringstream text;
  pass->Print(text);
}

// All that is left of the input. What is taken once is taken again.
void TakeSilhouettes(Input& input, vtkAirlightPass* pass)
{
  const std::vector<uint8_t> bytes = input.Rest();
  vtkNew<vtkUnsignedCharArray> array;
  array->SetNumberOfValues(static_cast<vtkIdType>(bytes.size()));
  std::copy(bytes.begin(), bytes.end(), array->GetPointer(0));
  const bool taken = pass->AddRemoteSilhouettes(array);
  Require(pass->AddRemoteSilhouettes(array) == taken, "the same bytes, the same answer");
}
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  Input input(data, size);
  vtkNew<vtkAirlightPass> pass;
  vtkNew<vtkParticipatingMedium> medium;
  vtkNew<vtkLight> light;
  for (int i = input.Integer(0, 24); i > 0; --i)
  {
    switch (input.Integer(0, 3))
    {
      case 0:
        ChangeMedium(input, medium);
        break;
      case 1:
        ChangeLight(input, light);
        break;
      default:
        ChangePass(input, pass, medium, light);
    }
  }
  AskPass(input, pass, light);
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkUnsignedCharArray> silhouettes;
  Require(!pass->GetSilhouettes(input.Flag() ? renderer : nullptr, silhouettes),
    "no silhouettes without a window");
  TakeSilhouettes(input, pass);
  return 0;
}
