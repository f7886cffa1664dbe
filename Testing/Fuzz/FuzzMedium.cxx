// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Random calls on a medium and a light, and vtkAirlight's functions with any arguments: true or
// false, and finite numbers of at least 0 in either case.

#include "AirlightFuzzScene.h"

#include "vtkAirlight.h"
#include "vtkLight.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"

#include <sstream>

using namespace airlight_fuzz;

namespace
{
void AskMedium(Input& input, vtkParticipatingMedium* medium)
{
  double values[4] = {};
  medium->GetExtinction(values);
  RequirePositive(values, 3, "the extinction");
  medium->GetAlbedo(values);
  RequirePositive(values, 3, "the albedo");
  values[0] = medium->GetPhaseErrorBound();
  RequirePositive(values, 1, "the bound of the phase function's error");
  values[0] = medium->EvaluatePhaseFunction(input.Number());
  RequirePositive(values, 1, "the phase function");
  medium->GetPhasePole(input.Integer(-1, 8), values);
  RequireFinite(values, 4, "a pole of the phase function");
  medium->GetPhasePower(values);
  RequireFinite(values, 2, "a power of the phase function");
  std::ostringstream text;
  medium->Print(text);
}

void AskAirlight(Input& input, vtkParticipatingMedium* medium, vtkLight* light)
{
  const Vector position = input.Numbers();
  const Vector origin = input.Numbers();
  const Vector direction = input.Numbers();
  const double t0 = input.Number();
  const double t1 = input.Number();
  double rgb[3] = { -1.0, -1.0, -1.0 };
  switch (input.Integer(0, 3))
  {
    case 0:
      vtkAirlight::Inscatter(medium, position.data(), input.Numbers().data(), origin.data(),
        direction.data(), t0, t1, rgb);
      break;
    case 1:
      vtkAirlight::Inscatter(medium, light, origin.data(), direction.data(), t0, t1, rgb);
      break;
    case 2:
      vtkAirlight::Transmittance(medium, position.data(), origin.data(), rgb);
      Require(rgb[0] <= 1.0 && rgb[1] <= 1.0 && rgb[2] <= 1.0, "the transmittance is at most 1");
      break;
    default:
      vtkAirlight::Ambient(medium, origin.data(), direction.data(), t1, rgb);
  }
  RequireFinite(rgb, 3, "the airlight");
}
}

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
  Input input(data, size);
  vtkNew<vtkParticipatingMedium> medium;
  vtkNew<vtkLight> light;
  medium->SetScattering(0.1, 0.2, 0.3);
  vtkAirlight::SetRadiantIntensity(light, Vector{ 3.0, 2.0, 1.0 }.data());
  for (int i = 0; i < 24 && input.HasMore(); ++i)
  {
    switch (input.Integer(0, 3))
    {
      case 0:
      case 1:
        ChangeMedium(input, medium);
        break;
      case 2:
        ChangeLight(input, light);
        break;
      default:
        AskAirlight(input, input.Integer(0, 15) == 0 ? nullptr : medium.Get(), light);
    }
  }
  AskMedium(input, medium);
  AskAirlight(input, medium, light);
  return 0;
}
