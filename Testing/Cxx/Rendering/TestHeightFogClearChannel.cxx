// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Height fog that leaves a channel alone, such as an atmosphere in metres. Rays that fall through
// infinitely much of it are black in the other channels. In the clear one their transmittance is 1 and
// their airlight 0, whatever the density's integral, which single precision cannot hold.

#include "AirlightTestCheck.h"
#include "AirlightTestScene.h"

#include <cstdlib>

using namespace airlighttest;

namespace
{
void CheckBuffer(vtkImageData* buffer, const std::string& name, const std::string& what)
{
  vtkDataArray* values = buffer->GetPointData()->GetScalars();
  int improper = 0;
  int wrong = 0;
  for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < values->GetNumberOfComponents(); ++k)
    {
      improper += std::isfinite(values->GetComponent(i, k)) ? 0 : 1;
    }
    const double clear = values->GetComponent(i, 0);
    wrong += (name == "Transmittance" && clear != 1.0) || (name == "Airlight" && clear != 0.0);
  }
  std::cout << what << ", " << name << ": " << improper << " improper values, " << wrong
            << " wrong ones\n";
  Check(improper == 0, what + ", " + name + ": all values are finite");
  Check(wrong == 0, what + ", " + name + ": the first channel is clear");
}

void TestFog(const glm::dvec3& scattering, double scaleHeight, double reference, bool several)
{
  const std::string what = "scale height " + std::to_string(scaleHeight) + ", reference " +
    std::to_string(reference) + (several ? ", two media" : "");
  Scene scene(60, 45);
  vtkNew<vtkParticipatingMedium> second;
  for (vtkParticipatingMedium* medium : { scene.Medium.Get(), second.Get() })
  {
    medium->SetScattering(&scattering.x);
    medium->SetAbsorption(0.0, 0.0, 0.0);
    medium->SetDensityToExponentialHeight();
    medium->SetScaleHeight(scaleHeight);
    medium->SetReferenceHeight(reference);
    medium->SetAmbientRadiance(0.1, 0.2, 0.3);
  }
  if (several)
  {
    scene.Pass->AddMedium(second);
  }
  scene.AddPointLight({ 0.0, 3.0, -1.0 });
  scene.AddDirectionalLight({ 0.3, 1.0, 0.2 });
  scene.Add(MakeSphere(1.0));
  const Buffers buffers = scene.Render();
  for (const char* name : { "Radiance", "Airlight", "Surface", "Transmittance", "ErrorBound" })
  {
    CheckBuffer(buffers.at(name), name, what);
  }
}
}

//------------------------------------------------------------------------------
int TestHeightFogClearChannel(int, char*[])
{
  for (const bool several : { false, true })
  {
    TestFog({ 0.0, 0.1, 0.1 }, 8000.0, 0.0, several);
    TestFog({ 0.0, 1e-5, 2e-5 }, 8500.0, 0.0, several);
    TestFog({ 0.0, 1e-5, 2e-5 }, 1000.0, 0.0, several);
    TestFog({ 0.0, 0.1, 0.1 }, 1.0, 30.0, several);
    TestFog({ 0.0, 0.0, 0.0 }, 8000.0, 0.0, several);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
