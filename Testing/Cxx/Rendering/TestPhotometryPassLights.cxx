// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Lamps with photometric files from frame to frame: a file that says nothing is a plain lamp; files
// set, replaced and removed on several lamps; a lamp that turns about its axis; lamps that move
// with the camera.

#include "AirlightTestErrors.h"
#include "AirlightTestGoniometry.h"
#include "AirlightTestScene.h"

#include "vtkPlaneSource.h"

#include <cstdlib>
#include <fstream>

using namespace airlight_test;

namespace
{
// A wall behind fog and two lamps. Nothing casts a shadow.
struct Stage : Scene
{
  Stage()
    : Scene(64, 48)
  {
    this->Pass->SetShadowTechniqueToNone();
    this->Pass->SetLightRadius(0.02); // a headlight is on all rays
    vtkNew<vtkPlaneSource> wall;
    wall->SetOrigin(-6.0, -5.0, -2.0);
    wall->SetPoint1(6.0, -5.0, -2.0);
    wall->SetPoint2(-6.0, 5.0, -2.0);
    this->Add(wall);
    this->AddPointLight({ -1.5, 0.5, 1.0 })->SetFocalPoint(-1.0, -1.0, -2.0);
    this->AddPointLight({ 1.0, 1.0, 0.5 })->SetFocalPoint(1.0, 0.0, 0.0);
  }

  Buffers Draw()
  {
    Buffers buffers = this->Render();
    for (const char* name : { "Airlight:0", "Airlight:1" })
    {
      buffers[name] = vtkSmartPointer<vtkImageData>::New();
      buffers[name]->DeepCopy(this->GetBuffer(name));
    }
    return buffers;
  }
};

// The largest difference of two buffers, relative to the second one's value.
double Difference(const Buffers& a, const Buffers& b, const char* name)
{
  double largest = 0.0;
  for (int pixel = 0; pixel < 64 * 48; ++pixel)
  {
    const int x = pixel % 64;
    const int y = pixel / 64;
    for (int k = 0; k < 3; ++k)
    {
      const double expected = GetValue(b.at(name), x, y, k);
      const double error = std::abs(GetValue(a.at(name), x, y, k) - expected);
      largest = std::max(largest, error / std::max(expected, 1e-6));
    }
  }
  return largest;
}

void CheckLike(const Buffers& a, const Buffers& b, const char* name, double limit)
{
  const double difference = Difference(a, b, name);
  std::cout << name << " differs by " << difference << ", limit " << limit << "\n";
  Check(difference <= limit, name);
}

std::string Write(const std::string& file, const LampTable& table)
{
  std::ofstream(file) << TableText(table);
  return file;
}

//------------------------------------------------------------------------------
// 7 candela in all directions. The plain lamp takes the closed form, this one quadrature.
void TestUniform(const std::string& folder)
{
  Stage stage;
  const Buffers plain = stage.Draw();
  const std::string file = Write(folder + "uniform.ies", { 1, { 0, 180 }, { 0 }, { 7, 7 } });
  Check(stage.Pass->SetLightPhotometry(stage.Lights[0], file.c_str()), "a uniform file is read");
  const Buffers uniform = stage.Draw();
  CheckLike(uniform, plain, "Airlight:0", 1e-3);
  CheckLike(uniform, plain, "Surface", 1e-5);
  Check(AreSame(uniform.at("Airlight:1"), plain.at("Airlight:1")), "the other lamp is as it was");

  // Twice the lamp's intensity is twice the light, whatever the file's candela.
  const Buffers single = stage.Draw();
  stage.Lights[0]->SetIntensity(2.0 * stage.Lights[0]->GetIntensity());
  const Buffers twice = stage.Draw();
  for (int k = 0; k < 3; ++k)
  {
    const double ratio =
      GetValue(twice.at("Airlight:0"), 20, 20, k) / GetValue(single.at("Airlight:0"), 20, 20, k);
    Check(std::abs(ratio - 2.0) < 1e-5, "twice the intensity is twice the light");
  }
}

//------------------------------------------------------------------------------
// Whatever came before, the same settings make the same picture.
void TestFiles(const std::string& data)
{
  const std::string down = data + "downlight.ies";
  const std::string street = data + "streetlight.ies";
  Stage stage;
  vtkAirlightPass* pass = stage.Pass;
  vtkLight* a = stage.Lights[0];
  vtkLight* b = stage.Lights[1];
  Check(!pass->GetLightPhotometry(a) && pass->GetLightPhotometryMaximum(a) == 0.0, "no file yet");
  const Buffers plain = stage.Draw();

  vtkMTimeType time = pass->GetMTime();
  Check(pass->SetLightPhotometry(a, down.c_str()), "a file on one lamp");
  Check(pass->GetMTime() > time, "a file modifies the pass");
  Check(pass->GetLightPhotometry(a) == down, "the file's name");
  Check(pass->GetLightPhotometryMaximum(a) == 2490.0, "the file's candela");
  const Buffers one = stage.Draw();
  Check(AreSame(one.at("Airlight:1"), plain.at("Airlight:1")), "the plain lamp stays");
  Check(Difference(one, plain, "Airlight:0") > 0.1, "the lamp with the file does not");

  // Two tables in one buffer: each lamp finds its own.
  Check(pass->SetLightPhotometry(b, street.c_str()), "another file on the other lamp");
  const Buffers two = stage.Draw();
  CheckLike(two, one, "Airlight:0", 1e-6);
  Check(Difference(two, plain, "Airlight:1") > 0.1, "the other lamp shines by its file");

  Check(pass->SetLightPhotometry(a, street.c_str()), "a file is replaced");
  const Buffers replaced = stage.Draw();
  Check(Difference(replaced, two, "Airlight:0") > 0.1, "the new file counts");
  CheckLike(replaced, two, "Airlight:1", 1e-6);
  Check(pass->SetLightPhotometry(a, down.c_str()), "the first file again");
  CheckSame(stage.Draw(), two, "the first file again");

  time = pass->GetMTime();
  Check(pass->SetLightPhotometry(a, nullptr), "the file is removed");
  Check(pass->SetLightPhotometry(b, ""), "the other one, too");
  Check(pass->GetMTime() > time, "removal modifies the pass");
  Check(!pass->GetLightPhotometry(a) && pass->GetLightPhotometryMaximum(b) == 0.0, "no file left");
  CheckSame(stage.Draw(), plain, "without files");
}

//------------------------------------------------------------------------------
// A lamp that aims along -z and shines to its `up` side alone, less and less towards its sides.
const LampTable HalfLit{ 1, { 0, 90 }, { 0, 90, 180 }, { 9, 6, 6, 3, 3, 0 } };

TestGoniometricLamp MakeLamp(vtkLight* light, const glm::dvec3& up)
{
  TestGoniometricLamp lamp;
  lamp.Table = HalfLit;
  glm::dvec3 focus;
  light->GetTransformedPosition(&lamp.Position.x);
  light->GetTransformedFocalPoint(&focus.x);
  lamp.Intensity = { 40.0, 30.0, 20.0 };
  lamp.Aim(focus - lamp.Position, up);
  lamp.Radius = 0.02;
  return lamp;
}

// The airlight of lamp `index` on some rays; `up` in the world.
void CheckLamp(Stage& stage, int index, const glm::dvec3& up, Comparison& comparison)
{
  TestFog fog;
  fog.SigmaS = { 0.05, 0.07, 0.1 };
  fog.SigmaT = { 0.07, 0.09, 0.11 };
  const auto lamp = MakeLamp(stage.Lights[index], up);
  vtkImageData* buffer = stage.GetBuffer(index == 0 ? "Airlight:0" : "Airlight:1");
  for (int pixel = 31; pixel < 64 * 48; pixel += 211)
  {
    const int x = pixel % 64;
    const int y = pixel / 64;
    const Ray ray = stage.GetRay(x + 0.5, y + 0.5);
    const double end = GetValue(stage.GetBuffer("Depth"), x, y);
    const double expected =
      GoniometricAirlight(fog, lamp, ray.Origin, ray.Direction, 0.0, end >= 0.0 ? end : 1e9, 1);
    const double value = GetValue(buffer, x, y, 1);
    comparison.Add(std::abs(value - expected) / std::max(expected, 1e-5), 1e-3,
      [&] { return Text("pixel ", x, " ", y, ": ", value, ", expected ", expected); });
  }
}

void TestRotation(const std::string& folder)
{
  Stage stage;
  vtkAirlightPass* pass = stage.Pass;
  vtkLight* lamp = stage.Lights[0];
  lamp->SetFocalPoint(-1.5, 0.5, -4.0);
  Write(folder + "half.ies", HalfLit);
  pass->SetLightPhotometry(lamp, (folder + "half.ies").c_str());
  Comparison turned("a lamp that turns about its axis");
  for (int step = 0; step < 8; ++step)
  {
    const double angle = glm::radians(45.0 * step + 10.0);
    // What lies along the axis does not matter, nor does the length.
    const glm::dvec3 up(3.0 * std::cos(angle), 3.0 * std::sin(angle), 1.0);
    const vtkMTimeType time = pass->GetMTime();
    pass->SetLightPhotometryUp(lamp, up.x, up.y, up.z);
    Check(pass->GetMTime() > time, "another up modifies the pass");
    glm::dvec3 got;
    pass->GetLightPhotometryUp(lamp, &got.x);
    Check(got == up, "the up that was set");
    stage.Window->Render();
    CheckLamp(stage, 0, up, turned);
  }
  Check(turned.Report(), "a lamp that turns about its axis");

  // Along the axis, the header says, (0, 0, 1); where that is no good either, any other.
  Comparison along("up along the axis");
  pass->SetLightPhotometryUp(lamp, 0.0, -1.0, 0.0);
  lamp->SetFocalPoint(-1.5, -3.0, 1.0);
  stage.Window->Render();
  CheckLamp(stage, 0, { 0.0, 0.0, 1.0 }, along);
  Check(along.Report(), "up along the axis");
  lamp->SetFocalPoint(-1.5, 0.5, -4.0);
  pass->SetLightPhotometryUp(lamp, 0.0, 0.0, 2.0);
  CheckFinite(stage.Render(), "up along z");
}

//------------------------------------------------------------------------------
// A headlight and a camera light turn with the camera, their up as well.
void TestCameraLights(const std::string& folder)
{
  Comparison comparison("lamps that move with the camera");
  for (const int type : { VTK_LIGHT_TYPE_HEADLIGHT, VTK_LIGHT_TYPE_CAMERA_LIGHT })
  {
    Stage stage;
    vtkLight* lamp = stage.Lights[1];
    lamp->SetLightType(type);
    stage.Pass->SetLightScatters(lamp, true);
    if (type == VTK_LIGHT_TYPE_CAMERA_LIGHT)
    {
      lamp->SetPosition(0.3, 0.1, 0.8);
      lamp->SetFocalPoint(0.1, 0.0, 0.0);
    }
    stage.Pass->SetLightPhotometry(lamp, (folder + "half.ies").c_str());
    stage.Pass->SetLightPhotometryUp(lamp, 1.0, 1.0, 0.0);
    vtkCamera* camera = stage.Renderer->GetActiveCamera();
    for (const double roll : { 0.0, 70.0 })
    {
      camera->SetPosition(2.0, 1.0, 9.0);
      camera->SetFocalPoint(0.2, 0.1, 0.0);
      camera->SetViewUp(std::sin(glm::radians(roll)), std::cos(glm::radians(roll)), 0.0);
      stage.Window->Render();
      glm::dvec3 viewUp;
      camera->GetViewUp(&viewUp.x);
      const glm::dvec3 forward = glm::normalize(glm::dvec3(-1.8, -0.9, -9.0));
      const glm::dvec3 right = glm::normalize(glm::cross(forward, viewUp));
      CheckLamp(stage, 1, right + glm::cross(right, forward), comparison);
    }
  }
  Check(comparison.Report(), "lamps that move with the camera");
}
}

//------------------------------------------------------------------------------
int TestPhotometryPassLights(int argc, char* argv[])
{
  const std::string folder = GetTemporaryFile(argc, argv, "TestPhotometryPassLights-");
  TestUniform(folder);
  TestFiles(GetPhotometricFile(argc, argv));
  TestRotation(folder);
  TestCameraLights(folder);
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
