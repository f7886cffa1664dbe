// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightLight::SetVisible(): a lamp is seen where it is, as bright as its intensity and area
// say, in fog and behind what hides it, and takes no light away.

#include "AirlightTestErrors.h"
#include "AirlightTestScene.h"
#include "AirlightTestTools.h"

#include "vtkAirlightLight.h"
#include "vtkCommand.h"
#include "vtkCubeSource.h"
#include "vtkLight.h"
#include "vtkPropPicker.h"

#include <cmath>
#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr double Pi = 3.14159265358979323846;
constexpr int Side = 101;
constexpr int Middle = Side / 2;

// A lamp in the middle of the picture, 6 before the camera.
class LampScene : public Scene
{
public:
  LampScene()
    : Scene(Side, Side)
  {
    this->Look({ 0, 0, 6 }, { 0, 0, 0 });
    this->Lamp = this->AddPointLight({ 0, 0, 0 }, { 4.0, 2.0, 1.0 });
    this->Medium->SetScattering(0.05, 0.05, 0.05);
    this->Medium->SetAbsorption(0.02, 0.02, 0.02);
  }

  vtkLight* Lamp;
};

void CheckLamp(const std::string& name, LampScene& scene, double area, double distance)
{
  vtkAirlightLight::SetVisible(scene.Lamp, true);
  const Buffers buffers = scene.Render();
  const double expected[] = { 4.0 / area, 2.0 / area, 1.0 / area };
  const double transmittance = std::exp(-0.07 * distance);
  for (int c = 0; c < 3; ++c)
  {
    const double surface = GetValue(buffers.at("Surface"), Middle, Middle, c);
    const double radiance = GetValue(buffers.at("Radiance"), Middle, Middle, c);
    const double airlight = GetValue(buffers.at("Airlight"), Middle, Middle, c);
    Check(std::abs(surface / (transmittance * expected[c]) - 1.0) < 1e-5,
      Text(name, ": its radiance in fog is ", surface));
    Check(std::abs(radiance / (surface + airlight) - 1.0) < 1e-5 && airlight > 0.0,
      name + ": with the airlight before it");
  }
  const double depth = GetValue(buffers.at("Depth"), Middle, Middle);
  Check(std::abs(depth - distance) < 2e-3, Text(name, ": it is where it is: ", depth));
}

//------------------------------------------------------------------------------
void TestKinds()
{
  LampScene ball;
  vtkAirlightLight::SetRadius(ball.Lamp, 0.5);
  CheckLamp("ball", ball, Pi * 0.25, 5.5);
  LampScene sheet;
  sheet.Lamp->SetFocalPoint(0, 0, 1);
  vtkAirlightLight::SetSize(sheet.Lamp, 2.0, 0.5);
  CheckLamp("rectangle", sheet, 1.0, 6.0);
  LampScene spot;
  spot.Lamp->SetFocalPoint(0, 0, 1);
  spot.Lamp->SetConeAngle(50.0);
  spot.Lamp->SetExponent(0.0);
  vtkAirlightLight::SetRadius(spot.Lamp, 0.4);
  CheckLamp("disc", spot, Pi * 0.16, 6.0);
  spot.Lamp->SetFocalPoint(0, 0, -1);
  Check(GetValue(spot.Render().at("Depth"), Middle, Middle) < 0.0, "a spot is dark from behind");
}

//------------------------------------------------------------------------------
// How many pixels a shape covers: those of its solid angle.
int CountPixels(vtkImageData* depths)
{
  int count = 0;
  for (int i = 0; i < Side * Side; ++i)
  {
    count += GetValue(depths, i % Side, i / Side) > 0.0 ? 1 : 0;
  }
  return count;
}

void TestSize()
{
  LampScene scene;
  scene.Renderer->GetActiveCamera()->SetViewAngle(30.0);
  vtkAirlightLight::SetVisible(scene.Lamp, true);
  vtkAirlightLight::SetRadius(scene.Lamp, 0.5);
  const double pixel = 2.0 * std::tan(Pi / 12.0) / Side;
  const double radius = std::tan(std::asin(0.5 / 6.0)) / pixel;
  const int ball = CountPixels(scene.Render().at("Depth"));
  Check(std::abs(ball / (Pi * radius * radius) - 1.0) < 0.03, Text("a ball covers ", ball));
  scene.Lamp->SetFocalPoint(0, 0, 1);
  vtkAirlightLight::SetSize(scene.Lamp, 1.2, 1.0);
  const int sheet = CountPixels(scene.Render().at("Depth"));
  Check(std::abs(sheet * pixel * pixel * 36.0 / 1.2 - 1.0) < 0.05, Text("a sheet ", sheet));
  vtkAirlightLight::SetVisible(scene.Lamp, false);
  Check(CountPixels(scene.Render().at("Depth")) == 0, "nothing if it is not visible");
}

//------------------------------------------------------------------------------
// It casts no shadow, is hidden by bodies, and is no prop.
void TestNeighbours()
{
  LampScene scene;
  vtkNew<vtkCubeSource> floor;
  floor->SetBounds(-4, 4, -2, -1.8, -4, 4);
  scene.Add(floor);
  vtkAirlightLight::SetRadius(scene.Lamp, 0.5);
  const Buffers without = scene.Render();
  vtkAirlightLight::SetVisible(scene.Lamp, true);
  const Buffers with = scene.Render();
  int lit = 0;
  for (int x = 0; x < Side; ++x)
  {
    const double before = GetValue(without.at("Radiance"), x, 20);
    lit += std::abs(GetValue(with.at("Radiance"), x, 20) / before - 1.0) < 1e-5 ? 1 : 0;
  }
  Check(lit == Side, Text("the floor is as bright: ", lit));
  vtkNew<vtkPropPicker> picker;
  Check(picker->Pick(Middle, Middle, 0.0, scene.Renderer) == 0, "a lamp is not picked");
  vtkNew<vtkCubeSource> cube;
  scene.Add(cube, [](vtkActor* actor) { actor->SetPosition(0, 0, 2); });
  Check(
    std::abs(GetValue(scene.Render().at("Depth"), Middle, Middle) - 3.5) < 1e-3, "a body hides it");
}

//------------------------------------------------------------------------------
// Each frame of a mean shows it in its place; clear air shows it, too.
void TestPictures()
{
  LampScene scene;
  vtkAirlightLight::SetRadius(scene.Lamp, 0.5);
  vtkAirlightLight::SetVisible(scene.Lamp, true);
  const double one = GetValue(scene.Render().at("Surface"), Middle, Middle);
  scene.Pass->SetSubpixelFrames(8);
  const double mean = GetValue(scene.Render().at("Surface"), Middle, Middle);
  // But for the ball's facets, which are up to R/800 inside of it.
  Check(std::abs(mean / one - 1.0) < 0.07 * 0.5 / 400.0, Text("the mean of frames: ", mean / one));
  scene.Pass->SetSubpixelFrames(1);
  scene.Pass->SetLinearInput(false);
  Check(std::abs(GetValue(scene.Render().at("Surface"), Middle, Middle) / one - 1.0) < 1e-4,
    "encoded colours are decoded");
  scene.Pass->SetLinearInput(true);
  scene.Medium->SetScattering(0.0, 0.0, 0.0);
  scene.Medium->SetAbsorption(0.0, 0.0, 0.0);
  scene.Pass->RecordBuffersOff(); // or the pass would draw clear air, too
  const Picture clear = Capture(scene.Window);
  Check(clear[3 * (Side * Middle + Middle)] == 255, "in clear air");
}

//------------------------------------------------------------------------------
// Where the renderer draws its own props; beyond its clipping range; moved by a matrix.
void TestPlaces()
{
  LampScene scene;
  vtkNew<vtkCubeSource> floor;
  floor->SetBounds(-4, 4, -2, -1.8, -4, 4);
  scene.Add(floor);
  vtkAirlightLight::SetRadius(scene.Lamp, 0.5);
  vtkAirlightLight::SetVisible(scene.Lamp, true);
  const double expected = GetValue(scene.Render().at("Surface"), Middle, Middle);
  scene.Renderer->UseHiddenLineRemovalOn();
  const double lines = GetValue(scene.Render().at("Surface"), Middle, Middle);
  Check(std::abs(lines / expected - 1.0) < 1e-5, Text("with hidden lines removed: ", lines));
  scene.Renderer->UseHiddenLineRemovalOff();
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  for (const glm::dvec2 range : { glm::dvec2(0.1, 3.0), glm::dvec2(8.0, 20.0) })
  {
    camera->SetClippingRange(range.x, range.y);
    const double beyond = GetValue(scene.Render().at("Surface"), Middle, Middle);
    Check(std::abs(beyond / expected - 1.0) < 1e-4, Text("beyond the clipping range: ", beyond));
    double after[2];
    camera->GetClippingRange(after);
    Check(after[0] == range.x && after[1] == range.y, "which stays the camera's");
  }
  scene.Renderer->ResetCameraClippingRange();
  vtkNew<vtkMatrix4x4> matrix;
  matrix->SetElement(2, 3, 1.0);
  scene.Lamp->SetTransformMatrix(matrix);
  const double depth = GetValue(scene.Render().at("Depth"), Middle, Middle);
  Check(std::abs(depth - 4.5) < 2e-3, Text("the light's matrix moves it: ", depth));
}

//------------------------------------------------------------------------------
void TestErrors()
{
  LampScene scene;
  ErrorListener warnings(scene.Pass, vtkCommand::WarningEvent);
  vtkAirlightLight::SetVisible(scene.Lamp, true);
  scene.Render();
  scene.Render();
  Check(warnings.Take() == 1 && warnings.GetText().find("SetRadius") != std::string::npos,
    "one warning of a point");
  vtkAirlightLight::SetSize(scene.Lamp, 1.0, 0.0);
  CheckFinite(scene.Render(), "a line");
  vtkAirlightLight::SetRadius(scene.Lamp, 0.5);
  vtkAirlightLight::SetSize(scene.Lamp, 1.0, 0.0);
  CheckFinite(scene.Render(), "a line and a radius, without an axis");
  vtkAirlightLight::SetSize(scene.Lamp, 0.0, 0.0);
  vtkAirlightLight::SetRadius(scene.Lamp, 7.0);
  Check(CountPixels(scene.Render().at("Depth")) == 0, "the eye inside sees no shape");
  vtkNew<vtkLight> light;
  Check(!vtkAirlightLight::GetVisible(light), "not visible by default");
}
}

//------------------------------------------------------------------------------
int TestLampShapes(int, char*[])
{
  TestKinds();
  TestSize();
  TestNeighbours();
  TestPictures();
  TestPlaces();
  TestErrors();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
