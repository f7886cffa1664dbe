// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Sun and lamp in a uniform medium that leaves one channel alone, with height fog: what one channel
// sees ends millions of times farther than what another does. The sun against quadrature of
//
//   sum_i sigmaS_i rho_i(t) E/(4 pi) exp(-sum_i sigmaT_i D_i(t) - sigmaT_fog rho(t) H/mu),
//
// with D_i(t) the integral of rho_i over [0, t] and mu the sun's rise. The lamp's airlight has to
// be finite, and the reference's.

#include "AirlightTestCheck.h"
#include "AirlightTestQuadrature.h"
#include "AirlightTestScene.h"

#include "vtkAirlightReference.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr double ScaleHeight = 0.6;
constexpr double Reference = -1.6;
const glm::dvec3 Fog(0.11, 0.3, 0.03);

struct Fogs : Scene
{
  explicit Fogs(const glm::dvec3& uniform)
    : Scene(40, 30)
    , Uniform(uniform)
  {
    this->Medium->SetScattering(&uniform.x);
    this->Medium->SetAbsorption(0.0, 0.0, 0.0);
    this->Second->SetScattering(&Fog.x);
    this->Second->SetDensityToExponentialHeight();
    this->Second->SetScaleHeight(ScaleHeight);
    this->Second->SetReferenceHeight(Reference);
    this->Pass->AddMedium(this->Second);
    this->Look({ 0, -4, 0 }, { 1, -2.8, 0 });
  }

  double GetExpected(const Ray& ray, const glm::dvec3& toSun, int k) const
  {
    const double rise = ray.Direction.y / ScaleHeight;
    const double start = std::exp((Reference - ray.Origin.y) / ScaleHeight);
    const auto integrand = [&](double t) {
      const double density = start * std::exp(-rise * t);
      const double column = start * -std::expm1(-rise * t) / rise;
      const double depth =
        this->Uniform[k] * t + Fog[k] * (column + density * ScaleHeight / toSun.y);
      return depth < 700.0 ? (this->Uniform[k] + Fog[k] * density) * std::exp(-depth) : 0.0;
    };
    std::vector<long double> ends = { 0.0L };
    for (long double t = 1e-3L; t < 1e13L; t *= 1.5L)
    {
      ends.push_back(t);
    }
    return 3.0 * 0.25 / Pi * Integrate(integrand, ends, 1e-12);
  }

  vtkSmartPointer<vtkDataArray> Compute()
  {
    vtkNew<vtkAirlightReference> reference;
    reference->SetRenderer(this->Renderer);
    reference->SetSize(this->Width, this->Height);
    reference->AddMedium(this->Medium);
    reference->AddMedium(this->Second);
    reference->Update();
    return reference->GetOutput()->GetPointData()->GetArray("Airlight");
  }

  glm::dvec3 Uniform;
  vtkNew<vtkParticipatingMedium> Second;
};

void TestSun(const glm::dvec3& uniform)
{
  const std::string what = "sun, extinction " + std::to_string(uniform.z);
  Fogs scene(uniform);
  const glm::dvec3 toSun = glm::normalize(glm::dvec3(-0.6, 0.4, 0.7));
  scene.AddDirectionalLight(toSun);
  scene.Window->Render();
  vtkDataArray* drawn = scene.GetBuffer("Airlight")->GetPointData()->GetScalars();
  const vtkSmartPointer<vtkDataArray> computed = scene.Compute();
  double pass = 0.0;
  double reference = 0.0;
  for (int y = 1; y < scene.Height; y += 3)
  {
    for (int x = 1; x < scene.Width; x += 5)
    {
      const vtkIdType pixel = static_cast<vtkIdType>(y) * scene.Width + x;
      for (int k = 0; k < 3; ++k)
      {
        const double expected = scene.GetExpected(scene.GetRay(x + 0.5, y + 0.5), toSun, k);
        // NaN stays.
        const double size = std::max(expected, 1e-6);
        const double a = std::abs(drawn->GetComponent(pixel, k) - expected) / size;
        const double b = std::abs(computed->GetComponent(pixel, k) - expected) / size;
        pass = a <= pass ? pass : a;
        reference = b <= reference ? reference : b;
      }
    }
  }
  std::cout << what << ": largest relative error of the pass " << pass << ", of the reference "
            << reference << "\n";
  Check(pass <= 1e-4, what + ": the pass");
  Check(reference <= 1e-6, what + ": the reference");
}

void TestLamp(const glm::dvec3& up, bool parallel)
{
  const std::string what = std::string("lamp") + (parallel ? ", parallel projection" : "");
  Fogs scene({ 0.135, 1.9, 0.0 });
  scene.Second->SetUp(&up.x);
  scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
  scene.AddPointLight({ 1.0, -2.0, 0.5 });
  scene.Window->Render();
  int improper = 0;
  for (const char* name : { "Airlight", "Radiance", "ErrorBound" })
  {
    vtkDataArray* values = scene.GetBuffer(name)->GetPointData()->GetScalars();
    for (vtkIdType i = 0; i < values->GetNumberOfValues(); ++i)
    {
      improper += std::isfinite(values->GetVariantValue(i).ToDouble()) ? 0 : 1;
    }
  }
  const vtkSmartPointer<vtkDataArray> computed = scene.Compute();
  vtkDataArray* drawn = scene.GetBuffer("Airlight")->GetPointData()->GetScalars();
  double largest = 0.0;
  for (vtkIdType i = 0; i < drawn->GetNumberOfTuples(); ++i)
  {
    for (int k = 0; k < 3; ++k)
    {
      const double expected = computed->GetComponent(i, k);
      const double error =
        std::abs(drawn->GetComponent(i, k) - expected) / std::max(expected, 1e-6);
      largest = error <= largest ? largest : error;
    }
  }
  std::cout << what << ": " << improper
            << " improper values, largest difference from the reference " << largest << "\n";
  Check(improper == 0, what + ": all values are finite");
  Check(largest <= 1e-3, what + ": as the reference");
}
}

//------------------------------------------------------------------------------
int TestChannelScales(int, char*[])
{
  TestSun({ 0.0, 0.16, 0.16 });
  TestSun({ 1e-9, 0.16, 16.0 });
  for (const bool parallel : { false, true })
  {
    TestLamp({ 0.0, 1.0, 0.0 }, parallel);
    TestLamp({ -0.508, 0.641, -0.576 }, parallel);
  }
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
