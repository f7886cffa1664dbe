// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightLight::SetVisible() of a sun: a disc in the sky of its irradiance over its solid angle,
// behind everything, fogged by the whole ray.

#include "AirlightTestErrors.h"
#include "AirlightTestScene.h"
#include "AirlightTestTools.h"

#include "vtkAirlightLight.h"
#include "vtkCommand.h"
#include "vtkCubeSource.h"
#include "vtkLight.h"

#include <cmath>
#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int Side = 101;
constexpr int Middle = Side / 2;
const glm::dvec3 Irradiance(4.0, 2.0, 1.0);

// A sun in the middle of the picture, and fog between 1 and 3 before the camera.
class SunScene : public Scene
{
public:
  explicit SunScene(double degrees = 5.0)
    : Scene(Side, Side)
    , Degrees(degrees)
  {
    this->Look({ 0, 0, 6 }, { 0, 0, 0 });
    this->Sun = this->AddDirectionalLight({ 0, 0, -1 }, Irradiance);
    vtkAirlightLight::SetAngularDiameter(this->Sun, degrees);
    vtkAirlightLight::SetVisible(this->Sun, true);
    this->Medium->SetScattering(0.05, 0.05, 0.05);
    this->Medium->SetAbsorption(0.02, 0.02, 0.02);
    this->Medium->SetRegionToBox();
    const double box[6] = { -50, 50, -50, 50, 3, 5 };
    this->Medium->SetBounds(box);
  }

  // Radiance of the disc without what is between.
  glm::dvec3 GetRadiance() const
  {
    return Irradiance / (2.0 * Pi * (1.0 - std::cos(0.5 * glm::radians(this->Degrees))));
  }

  vtkLight* Sun;
  double Degrees;
};

// What a picture shows beside the airlight.
double GetSky(const Buffers& buffers, int x, int y, int channel = 0)
{
  return GetValue(buffers.at("Radiance"), x, y, channel) -
    GetValue(buffers.at("Airlight"), x, y, channel);
}

int CountBright(const Buffers& buffers)
{
  int count = 0;
  for (int i = 0; i < Side * Side; ++i)
  {
    count += GetSky(buffers, i % Side, i / Side) > 1.0 ? 1 : 0;
  }
  return count;
}

//------------------------------------------------------------------------------
void TestRadiance()
{
  for (const double degrees : { 0.53, 5.0, 60.0 })
  {
    SunScene scene(degrees);
    const Buffers buffers = scene.Render();
    const glm::dvec3 expected = std::exp(-0.07 * 2.0) * scene.GetRadiance();
    for (int c = 0; c < 3; ++c)
    {
      Check(std::abs(GetSky(buffers, Middle, Middle, c) / expected[c] - 1.0) < 1e-4,
        Text(degrees, " degrees: ", GetSky(buffers, Middle, Middle, c), " for ", expected[c]));
    }
    Check(GetValue(buffers.at("Depth"), Middle, Middle) < 0.0, "it is of the background");
    Check(GetValue(buffers.at("Airlight"), Middle, Middle) > 0.0, "behind the air's light");
  }
}

//------------------------------------------------------------------------------
void TestSize()
{
  SunScene scene;
  const double pixel = 2.0 * std::tan(0.5 * glm::radians(30.0)) / Side;
  scene.Renderer->GetActiveCamera()->SetViewAngle(30.0);
  const double radius = std::tan(glm::radians(2.5)) / pixel;
  const int count = CountBright(scene.Render());
  Check(std::abs(count / (Pi * radius * radius) - 1.0) < 0.05, Text("the disc covers ", count));
  // Its light's matrix turns it: 5 degrees up.
  vtkNew<vtkMatrix4x4> matrix;
  const double angle = glm::radians(-5.0);
  matrix->SetElement(1, 1, std::cos(angle));
  matrix->SetElement(1, 2, std::sin(angle));
  matrix->SetElement(2, 1, -std::sin(angle));
  matrix->SetElement(2, 2, std::cos(angle));
  scene.Sun->SetTransformMatrix(matrix);
  const Buffers turned = scene.Render();
  const int up = Middle + static_cast<int>(std::lround(std::tan(glm::radians(5.0)) / pixel));
  Check(GetSky(turned, Middle, up) > 1.0 && GetSky(turned, Middle, Middle) < 1.0,
    "the light's matrix turns it");
}

//------------------------------------------------------------------------------
// Bodies hide it; an unbounded medium does; each frame of a mean shows it in its middle place.
void TestNeighbours()
{
  SunScene scene;
  const double one = GetSky(scene.Render(), Middle, Middle);
  scene.Pass->SetSubpixelFrames(8);
  const double mean = GetSky(scene.Render(), Middle, Middle);
  Check(std::abs(mean / one - 1.0) < 1e-5, Text("the mean of frames: ", mean / one));
  scene.Pass->SetSubpixelFrames(1);
  vtkNew<vtkCubeSource> cube;
  vtkActor* body = scene.Add(cube);
  Check(CountBright(scene.Render()) == 0, "a body hides it");
  body->GetProperty()->SetOpacity(0.5);
  const double through = GetSky(scene.Render(), Middle, Middle);
  Check(
    std::abs(through / one - 0.25) < 0.01, Text("a quarter through two panes: ", through / one));
  body->VisibilityOff();
  scene.Medium->SetRegionToUnbounded();
  Check(CountBright(scene.Render()) == 0, "endless fog hides it");
  scene.Medium->SetScattering(0.0, 0.0, 0.0);
  scene.Medium->SetAbsorption(0.0, 0.0, 0.0);
  scene.Pass->RecordBuffersOff(); // or the pass would draw clear air, too
  const Picture clear = Capture(scene.Window);
  Check(clear[3 * (Side * Middle + Middle)] == 255, "in clear air");
  scene.Renderer->SetBackgroundAlpha(0.0);
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  Check(Capture(scene.Window)[3 * (Side * Middle + Middle)] == 0, "not in a parallel projection");
}

//------------------------------------------------------------------------------
// A sun that is set to be visible and is not: one warning for each reason, with the remedy.
void TestUnseen()
{
  SunScene scene;
  ErrorListener warnings(scene.Pass, vtkCommand::WarningEvent);
  const auto check = [&](const std::string& name, const std::string& remedy) {
    scene.Render();
    scene.Render();
    const int count = warnings.Take();
    const std::string text = warnings.GetText();
    Check(count == 1 && text.find(remedy) != std::string::npos, Text(name, ": ", count, " ", text));
    Check(text.find("light 0 (") != std::string::npos, name + ": the light");
  };
  scene.Medium->SetRegionToUnbounded();
  check("unbounded", "SetRegionToBox()");
  scene.Renderer->GetActiveCamera()->ParallelProjectionOn();
  check("parallel", "ParallelProjectionOff()");
  scene.Renderer->GetActiveCamera()->ParallelProjectionOff();
  scene.Sun->SetLightTypeToCameraLight();
  vtkAirlightLight::SetScatters(scene.Sun, false);
  check("camera light", "SetLightTypeToSceneLight()");
  SunScene seen;
  ErrorListener others(seen.Pass, vtkCommand::WarningEvent);
  seen.Medium->SetRegionToUnbounded();
  seen.Medium->SetUp(0.0, 0.0, -1.0);
  seen.Medium->SetDensityToExponentialHeight();
  seen.Medium->SetScaleHeight(2.0);
  seen.Render();
  seen.Medium->SetUp(0.0, 0.0, 1.0);
  Check(others.Take() == 0, "none where height fog ends: " + others.GetText());
  seen.Render();
  Check(others.Take() == 1, "but where it grows denser");
  seen.Medium->SetRegionToBox();
  for (std::size_t i = 1; i < 16; ++i)
  {
    vtkLight* light = seen.AddDirectionalLight({ 0, 0, -1 }, Irradiance);
    vtkAirlightLight::SetAngularDiameter(light, 5.0);
    vtkAirlightLight::SetVisible(light, true);
  }
  seen.Render();
  Check(others.Take() == 0, "none of sixteen suns: " + others.GetText());
  vtkLight* last = seen.AddDirectionalLight({ 0, 0, -1 }, Irradiance);
  vtkAirlightLight::SetAngularDiameter(last, 5.0);
  vtkAirlightLight::SetVisible(last, true);
  seen.Render();
  Check(others.Take() == 1 && others.GetText().find("light 16 (") != std::string::npos,
    "of the seventeenth: " + others.GetText());
}

//------------------------------------------------------------------------------
void TestErrors()
{
  SunScene scene;
  ErrorListener warnings(scene.Pass, vtkCommand::WarningEvent);
  scene.Render();
  Check(warnings.Take() == 0, "no warning of a disc");
  vtkAirlightLight::SetAngularDiameter(scene.Sun, 0.0);
  scene.Render();
  CheckFinite(scene.Render(), "no diameter");
  Check(warnings.Take() == 1 && warnings.GetText().find("SetAngularDiameter") != std::string::npos,
    "one warning of a sun without a diameter");
  vtkAirlightLight::SetAngularDiameter(scene.Sun, 1e-9);
  scene.Pass->SetSubpixelFrames(4);
  CheckFinite(scene.Render(), "the smallest disc");
  scene.Sun->SetFocalPoint(scene.Sun->GetPosition());
  vtkAirlightLight::SetAngularDiameter(scene.Sun, 5.0);
  CheckFinite(scene.Render(), "no direction");
  for (int i = 0; i < 40; ++i)
  {
    vtkLight* light = scene.AddDirectionalLight({ 0, 0, -1 }, Irradiance);
    vtkAirlightLight::SetAngularDiameter(light, 5.0);
    vtkAirlightLight::SetVisible(light, true);
  }
  CheckFinite(scene.Render(), "many suns");
}
}

//------------------------------------------------------------------------------
int TestSunDiscs(int, char*[])
{
  TestRadiance();
  TestSize();
  TestNeighbours();
  TestUnseen();
  TestErrors();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
