// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Lights in place of an emitting medium: their power is the medium's, and what they bring to places
// around the fire is what all of its points bring, by quadrature. They follow a fire that moves;
// media that have none give an error.

#include "AirlightTestCheck.h"
#include "AirlightTestErrors.h"
#include "AirlightTestQuadrature.h"
#include "AirlightTestTools.h"

#include "vtkAirlightLight.h"
#include "vtkDataArray.h"
#include "vtkEmissionLights.h"
#include "vtkFloatArray.h"
#include "vtkImageData.h"
#include "vtkLight.h"
#include "vtkLightCollection.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkPointData.h"
#include "vtkRenderer.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace airlight_test;

namespace
{
const glm::dvec3 Emission(3.0, 1.0, 0.2);

// A flame: wide below, narrow and bent above.
double GetDensity(const glm::dvec3& p, double bend)
{
  const double width = 0.45 - 0.12 * p.y;
  const double aside = std::hypot(p.x - bend * p.y * p.y, p.z);
  const double along = std::max(1.0 - std::abs(p.y - 0.8), 0.0);
  return std::exp(-aside * aside / (width * width)) * along;
}

vtkSmartPointer<vtkImageData> MakeFlame(double bend)
{
  auto image = vtkSmartPointer<vtkImageData>::New();
  image->SetDimensions(25, 31, 25);
  image->SetOrigin(-1.2, -0.3, -1.2);
  image->SetSpacing(0.1, 0.08, 0.1);
  image->AllocateScalars(VTK_DOUBLE, 1);
  vtkDataArray* values = image->GetPointData()->GetScalars();
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    const double* p = image->GetPoint(i);
    values->SetComponent(i, 0, GetDensity({ p[0], p[1], p[2] }, bend));
  }
  return image;
}

// Fluence per unit emission at a place, of the flame's points and of the lights.
double GetFromFlame(const glm::dvec3& place, double bend)
{
  double sum = 0.0;
  const int n = 60;
  const glm::dvec3 step = glm::dvec3(2.4, 2.4, 2.4) / static_cast<double>(n);
  for (int i = 0; i < n * n * n; ++i)
  {
    const glm::dvec3 p =
      glm::dvec3(-1.2, -0.3, -1.2) + (glm::dvec3(i % n, i / n % n, i / (n * n)) + 0.5) * step;
    sum += GetDensity(p, bend) / glm::dot(p - place, p - place) * step.x * step.y * step.z;
  }
  return sum;
}

double GetFromLights(vtkEmissionLights* lights, const glm::dvec3& place)
{
  double sum = 0.0;
  for (int i = 0; i < lights->GetLights()->GetNumberOfItems(); ++i)
  {
    auto* light = vtkLight::SafeDownCast(lights->GetLights()->GetItemAsObject(i));
    glm::dvec3 intensity;
    vtkAirlightLight::GetRadiantIntensity(light, &intensity.x);
    const double* at = light->GetPosition();
    const glm::dvec3 way = glm::dvec3(at[0], at[1], at[2]) - place;
    sum += light->GetSwitch() ? intensity.x / Emission.x / glm::dot(way, way) : 0.0;
  }
  return sum;
}

//------------------------------------------------------------------------------
void CompareWithFlame(vtkEmissionLights* lights, double bend, const std::string& name)
{
  const struct
  {
    glm::dvec3 Place;
    double Tolerance;
  } places[] = { { { 6, 0, 0 }, 0.01 }, { { -3, 1, 2 }, 0.02 }, { { 0, -1.5, 0 }, 0.05 },
    { { 1.2, 1.5, 0.5 }, 0.1 } };
  for (const auto& place : places)
  {
    const double expected = GetFromFlame(place.Place, bend);
    const double value = GetFromLights(lights, place.Place);
    const std::string text = Text(name, " at ", place.Place.x, " ", place.Place.y, " ",
      place.Place.z, ": ", value / expected - 1.0);
    std::cout << text << "\n";
    Check(std::abs(value / expected - 1.0) < place.Tolerance, text);
  }
}

void TestFlame()
{
  vtkNew<vtkParticipatingMedium> flame;
  flame->SetDensityImage(MakeFlame(0.2));
  flame->SetDensityToImage();
  flame->SetEmission(&Emission.x);
  vtkNew<vtkRenderer> renderer;
  vtkNew<vtkEmissionLights> lights;
  lights->SetMedium(flame);
  lights->AddLights(renderer);
  Check(lights->Update(), "lights are fitted");
  Check(renderer->GetLights()->GetNumberOfItems() == 8, "the renderer has them");
  CompareWithFlame(lights, 0.2, "8 lights");
  vtkLight* first = vtkLight::SafeDownCast(lights->GetLights()->GetItemAsObject(0));
  const glm::dvec3 before =
    glm::dvec3(first->GetPosition()[0], first->GetPosition()[1], first->GetPosition()[2]);
  flame->SetDensityImage(MakeFlame(0.25));
  Check(lights->Update(), "the flame moves");
  const glm::dvec3 after =
    glm::dvec3(first->GetPosition()[0], first->GetPosition()[1], first->GetPosition()[2]);
  Check(glm::length(after - before) < 0.15, Text("a light follows: ", glm::length(after - before)));
  CompareWithFlame(lights, 0.25, "moved");
  lights->SetNumberOfLights(3);
  Check(lights->Update() && renderer->GetLights()->GetNumberOfItems() == 3, "fewer lights");
  lights->RemoveLights(renderer);
  Check(renderer->GetLights()->GetNumberOfItems() == 0, "none are left");
}

//------------------------------------------------------------------------------
// Where the emission varies by an array, lights have the colour and the power of their places.
void TestColours()
{
  const vtkSmartPointer<vtkImageData> image = MakeFlame(0.2);
  vtkNew<vtkFloatArray> factors;
  factors->SetName("Factors");
  factors->SetNumberOfComponents(3);
  factors->SetNumberOfTuples(image->GetNumberOfPoints());
  glm::dvec3 expected(0.0);
  for (vtkIdType i = 0; i < image->GetNumberOfPoints(); ++i)
  {
    // Red below, blue above.
    const bool above = image->GetPoint(i)[1] > 0.8;
    const glm::dvec3 factor = above ? glm::dvec3(0.0, 0.0, 5.0) : glm::dvec3(2.0, 0.0, 0.0);
    factors->SetTuple(i, &factor.x);
    const double density = image->GetPointData()->GetScalars()->GetComponent(i, 0);
    expected += density * 0.1 * 0.08 * 0.1 * factor * Emission;
  }
  image->GetPointData()->AddArray(factors);
  vtkNew<vtkParticipatingMedium> flame;
  flame->SetDensityImage(image);
  flame->SetDensityToImage();
  flame->SetEmission(&Emission.x);
  flame->SetEmissionArrayName("Factors");
  vtkNew<vtkEmissionLights> lights;
  lights->SetMedium(flame);
  Check(lights->Update(), "lights of a flame of two colours");
  glm::dvec3 sum(0.0);
  glm::dvec3 lowest;
  glm::dvec3 highest;
  double low = 1.0;
  double high = 0.0;
  for (int i = 0; i < lights->GetLights()->GetNumberOfItems(); ++i)
  {
    auto* light = vtkLight::SafeDownCast(lights->GetLights()->GetItemAsObject(i));
    glm::dvec3 intensity;
    vtkAirlightLight::GetRadiantIntensity(light, &intensity.x);
    sum += intensity;
    const double height = light->GetPosition()[1];
    lowest = height < low ? intensity : lowest;
    highest = height > high ? intensity : highest;
    low = std::min(low, height);
    high = std::max(high, height);
  }
  Check(low < 0.8 && lowest.x > 0.0 && lowest.z < 0.01 * lowest.x,
    Text("the lowest light, at ", low, ", has ", lowest.x, " and ", lowest.z));
  Check(high > 0.8 && highest.z > 0.0 && highest.x < 0.01 * highest.z,
    Text("the highest light, at ", high, ", has ", highest.x, " and ", highest.z));
  // The image's own sum; its rim is empty.
  Check(std::abs(sum.x / expected.x - 1.0) < 1e-3 && std::abs(sum.z / expected.z - 1.0) < 1e-3,
    Text("their power: ", sum.x / expected.x, " and ", sum.z / expected.z));
  Check(sum.y == 0.0, "nothing is green");
}

//------------------------------------------------------------------------------
void TestSphere()
{
  vtkNew<vtkParticipatingMedium> glow;
  glow->SetRegionToSphere();
  glow->SetCenter(3, 4, 5);
  glow->SetRadius(2.0);
  glow->SetEmission(&Emission.x);
  vtkNew<vtkEmissionLights> lights;
  lights->SetMedium(glow);
  lights->SetNumberOfLights(1);
  Check(lights->Update(), "a sphere");
  auto* light = vtkLight::SafeDownCast(lights->GetLights()->GetItemAsObject(0));
  glm::dvec3 intensity;
  vtkAirlightLight::GetRadiantIntensity(light, &intensity.x);
  const double volume = 4.0 / 3.0 * Pi * 8.0;
  Check(std::abs(intensity.x / (Emission.x * volume) - 1.0) < 0.01,
    Text("its intensity: ", intensity.x / (Emission.x * volume)));
  Check(std::abs(vtkAirlightLight::GetRadius(light) - 2.0) < 0.05,
    Text("its radius: ", vtkAirlightLight::GetRadius(light)));
  Check(std::abs(light->GetPosition()[1] - 4.0) < 1e-6, "its place");
  glow->SetEmission(0.0, 0.0, 0.0);
  Check(lights->Update() && !light->GetSwitch(), "without emission the light is off");
}

//------------------------------------------------------------------------------
void TestErrors()
{
  vtkNew<vtkEmissionLights> lights;
  ErrorListener errors(lights);
  Check(!lights->Update() && errors.Take() == 1 &&
      errors.GetText().find("SetMedium()") != std::string::npos,
    "no medium");
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetAbsorption(1.0, 1.0, 1.0);
  medium->SetEmission(&Emission.x);
  lights->SetMedium(medium);
  Check(!lights->Update() && errors.Take() == 1 &&
      errors.GetText().find("unbounded") != std::string::npos,
    "an unbounded medium");
  lights->AddLights(nullptr);
  Check(errors.Take() == 1, "no renderer");
  lights->SetNumberOfLights(1000);
  Check(lights->GetNumberOfLights() == 64, "the number is clamped");
}
}

//------------------------------------------------------------------------------
int TestEmissionLights(int, char*[])
{
  TestFlame();
  TestColours();
  TestSphere();
  TestErrors();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
