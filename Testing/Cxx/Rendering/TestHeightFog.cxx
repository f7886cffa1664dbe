// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Media whose densities fall with height. The sun in two equal unbounded ones, which take
// quadrature: from eyes in the fog and up to 60 scale heights above it, where all of a ray's
// airlight comes from a short part of it. With D(t) the density's integral from the eye to t, h the
// eye's height over the scale height H, m and mu the rises of ray and sun, the optical depth at t
// is sigmaT (exp(-h) H/mu + (1 - m/mu) D(t)), so that the integral of both media together is
// closed:
//
//   sigmaS E p exp(-sigmaT exp(-h) H/mu) (1 - exp(-s D(end)))/s, s = sigmaT (1 - m/mu)

#include "AirlightTestSceneRays.h"

using namespace airlight_test;

namespace
{
constexpr double ScaleHeight = 0.5;
const glm::dvec3 SigmaS(0.3, 0.02, 3.0);
const glm::dvec3 SigmaA(0.1, 0.3, 0.0);
const glm::dvec3 Irradiance(3.0, 2.0, 1.0);

double GetExpected(const Ray& ray, const glm::dvec3& toSun, int k)
{
  const double sigmaT = SigmaS[k] + SigmaA[k];
  const double above = std::exp(-ray.Origin.y / ScaleHeight) * ScaleHeight;
  const double s = sigmaT * (1.0 - ray.Direction.y / toSun.y);
  const double sight = ray.Direction.y > 0.0 ? -std::expm1(-s * above / ray.Direction.y) / s
                                             : 1.0 / s; // downwards there is infinitely much
  const double phase = 0.25 / Pi;
  return SigmaS[k] * Irradiance[k] * phase * std::exp(-sigmaT * above / toSun.y) * sight;
}

void Compare(double height, const glm::dvec3& toSun)
{
  Scene scene(640, 480);
  scene.SmoothEdges();
  vtkNew<vtkParticipatingMedium> second;
  for (vtkParticipatingMedium* medium : { scene.Medium.Get(), second.Get() })
  {
    const glm::dvec3 sigmaS = 0.5 * SigmaS;
    const glm::dvec3 sigmaA = 0.5 * SigmaA;
    medium->SetScattering(&sigmaS.x);
    medium->SetAbsorption(&sigmaA.x);
    medium->SetDensityToExponentialHeight();
    medium->SetScaleHeight(ScaleHeight);
  }
  scene.Pass->AddMedium(second);
  scene.AddDirectionalLight(toSun, Irradiance);
  const glm::dvec3 eye(0.3, height * ScaleHeight, 0.2);
  scene.Look(eye, eye + glm::dvec3(0.1, 0.05, -1.0));
  scene.Renderer->GetActiveCamera()->SetViewAngle(140.0);
  scene.Renderer->GetActiveCamera()->SetClippingRange(0.1, 1000.0);
  scene.Window->Render();
  vtkSmartPointer<vtkImageData> drawn = scene.GetBuffer("Airlight");
  glm::dvec3 brightest(0.0);
  const auto forEachPixel = [&](const auto& visit) {
    const int* size = drawn->GetDimensions();
    for (int y = 2; y < size[1]; y += 9)
    {
      for (int x = 2; x < size[0]; x += 17)
      {
        const Ray ray = scene.GetPixelRay({ x, y });
        visit(x, y,
          glm::dvec3(
            GetExpected(ray, toSun, 0), GetExpected(ray, toSun, 1), GetExpected(ray, toSun, 2)));
      }
    }
  };
  forEachPixel(
    [&](int, int, const glm::dvec3& expected) { brightest = glm::max(brightest, expected); });
  double worst = 0.0;
  forEachPixel([&](int x, int y, const glm::dvec3& expected) {
    const glm::dvec3 seen = GetColour(drawn, x, y);
    for (int k = 0; k < 3; ++k)
    {
      const double error =
        std::abs(seen[k] - expected[k]) / std::max(expected[k], 1e-6 * brightest[k]);
      worst = std::isnan(error) ? error : std::max(worst, error);
    }
  });
  CheckClose(
    1.0 + worst, 1.0, 1e-3, Text("eye ", height, " scale heights up, sun's rise ", toSun.y));
}

//------------------------------------------------------------------------------
// Height fog that leaves a channel alone, such as an atmosphere in metres. Rays that fall through
// infinitely much of it are black in the other channels. In the clear one their transmittance is 1
// and their airlight 0, whatever the density's integral, which single precision cannot hold.
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

void TestClearChannel(
  const glm::dvec3& scattering, double scaleHeight, double reference, bool several)
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
int TestHeightFog(int, char*[])
{
  for (const double height : { -1.0, 1.5, 8.0, 25.0, 60.0 })
  {
    for (const double rise : { 0.03, 0.4, 2.0 })
    {
      Compare(height, glm::normalize(glm::dvec3(-0.6, rise, -0.8)));
    }
  }
  for (const bool several : { false, true })
  {
    TestClearChannel({ 0.0, 0.1, 0.1 }, 8000.0, 0.0, several);
    TestClearChannel({ 0.0, 1e-5, 2e-5 }, 8500.0, 0.0, several);
    TestClearChannel({ 0.0, 1e-5, 2e-5 }, 1000.0, 0.0, several);
    TestClearChannel({ 0.0, 0.1, 0.1 }, 1.0, 30.0, several);
    TestClearChannel({ 0.0, 0.0, 0.0 }, 8000.0, 0.0, several);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
