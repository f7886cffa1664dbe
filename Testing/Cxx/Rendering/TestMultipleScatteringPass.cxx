// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkParticipatingMedium::SetMultipleScattering() in the pass: in the air before surfaces, on
// surfaces, before translucent ones and in shadow, beside vtkAirlight, which TestMultipleScattering
// compares with the exact solution.

#include "AirlightTestErrors.h"
#include "AirlightTestPixelScene.h"
#include "AirlightTestTools.h"

#include "vtkAirlight.h"
#include "vtkAirlightReference.h"
#include "vtkFloatArray.h"
#include "vtkMath.h"
#include "vtkPointData.h"
#include "vtkSphereSource.h"

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <string>
#include <vector>

using namespace airlight_test;

namespace
{
const glm::dvec3 Diffuse(0.9, 0.6, 0.3);
const double Intensity[3] = { 10.0, 20.0, 5.0 };
const double Lamp[3] = { 0.5, 0.3, 1.2 };

using Buffer = std::vector<float>;

// A plane z = 0, seen obliquely from z > 0 through fog with a lamp in it.
class FoggyPlane : public PixelScene
{
public:
  explicit FoggyPlane(int region)
  {
    this->AddBroadPlane(Diffuse);
    this->Medium->SetScattering(0.3, 0.2, 0.4);
    this->Medium->SetAbsorption(0.1, 0.0, 0.05);
    this->Medium->SetPhaseFunctionToHenyeyGreenstein();
    this->Medium->SetAnisotropy(0.4);
    this->Medium->SetBounds(-2.5, 3.0, -4.0, 3.5, -1.0, 6.0);
    this->Medium->SetCenter(0.0, 0.0, 1.0);
    this->Medium->SetRadius(3.0);
    this->Medium->SetRegion(region);
    vtkAirlight::SetRadiantIntensity(this->Light, Intensity);
    this->Light->SetPosition(Lamp);
    this->Renderer->AddLight(this->Light);
  }

  void AddBall(double x, double y, double z, double radius)
  {
    this->Ball->SetCenter(x, y, z);
    this->Ball->SetRadius(radius);
    this->Ball->SetThetaResolution(24);
    this->Ball->SetPhiResolution(16);
    this->BallMapper->SetInputConnection(this->Ball->GetOutputPort());
    this->BallActor->SetMapper(this->BallMapper);
    this->BallActor->GetProperty()->BackfaceCullingOn(); // translucent, in any order
    this->Renderer->AddActor(this->BallActor);
  }

  Buffer Render(const char* buffer, bool multiple)
  {
    this->Medium->SetMultipleScattering(multiple);
    this->RenderFitted();
    auto* values =
      vtkFloatArray::SafeDownCast(this->Pass->GetBuffer(buffer)->GetPointData()->GetScalars());
    return Buffer(values->GetPointer(0), values->GetPointer(0) + values->GetNumberOfValues());
  }

  vtkPointData* Trace()
  {
    this->Oracle->SetRenderer(this->Renderer);
    this->Oracle->AddMedium(this->Medium);
    this->Oracle->SetSize(Width, Height);
    this->Oracle->Update();
    return this->Oracle->GetOutput()->GetPointData();
  }

  vtkNew<vtkAirlightReference> Oracle;
  vtkNew<vtkSphereSource> Ball;
  vtkNew<vtkPolyDataMapper> BallMapper;
  vtkNew<vtkActor> BallActor;
};

template <typename Visitor>
void ForPixels(Visitor&& visit)
{
  for (int j = 2; j < PixelScene::Height; j += 5)
  {
    for (int i = 3; i < PixelScene::Width; i += 7)
    {
      for (int c = 0; c < 3; ++c)
      {
        visit(i, j, c, 3 * (j * PixelScene::Width + i) + c);
      }
    }
  }
}

//------------------------------------------------------------------------------
// What is added to the air and, as rho E/pi, to the plane.
bool TestPlane()
{
  Comparison air("added to the air, relative to all of it");
  Comparison surface("added to the plane, relative");
  for (const int region : { vtkParticipatingMedium::UNBOUNDED, vtkParticipatingMedium::BOX,
         vtkParticipatingMedium::SPHERE })
  {
    FoggyPlane scene(region);
    const Buffer airOff = scene.Render("Airlight", false);
    const Buffer surfaceOff = scene.Render("Surface", false);
    const Buffer airOn = scene.Render("Airlight", true);
    const Buffer surfaceOn = scene.Render("Surface", true);
    ForPixels([&](int i, int j, int c, int index) {
      const PixelRay ray = scene.GetRay(i, j);
      const double end = scene.GetEnd(i, j);
      double expected[3];
      vtkAirlight::MultipleScattering(
        scene.Medium, Lamp, Intensity, &ray.Origin.x, &ray.Direction.x, end, expected);
      const double added = static_cast<double>(airOn[index]) - airOff[index];
      air.Add(std::abs(added - expected[c]) / airOn[index], 2e-3, [&] {
        return Text("region ", region, ", pixel ", i, " ", j, ", channel ", c, ": added ", added,
          " for ", expected[c], ", once ", airOff[index]);
      });
      const glm::dvec3 point = ray.Origin + end * ray.Direction;
      const double normal[3] = { 0.0, 0.0, 1.0 };
      vtkAirlight::MultipleIrradiance(scene.Medium, Lamp, Intensity, &point.x, normal, expected);
      const float* passes = scene.GetPixel("Transmittance", i, j);
      const double lit =
        (surfaceOn[index] - surfaceOff[index]) / passes[c] * vtkMath::Pi() / Diffuse[c];
      surface.Add(std::abs(lit - expected[c]) / std::max(expected[c], 1e-3), 2e-3, [&] {
        return Text("region ", region, ", pixel ", i, " ", j, ", channel ", c, ": added ", lit,
          " for ", expected[c]);
      });
    });
  }
  return AllOk({ &air, &surface });
}

//------------------------------------------------------------------------------
// In shadow a share of it is left, by that of the light that is scattered once; beside the reference.
bool TestShadow()
{
  Comparison shares("in shadow, relative");
  Comparison reference("in shadow, beside the reference, relative");
  FoggyPlane scene(vtkParticipatingMedium::UNBOUNDED);
  scene.AddBall(-0.1, 0.3, 1.2, 0.3);
  scene.Pass->SetShadowTechnique(vtkAirlightPass::SHADOW_PLANES);
  const Buffer off = scene.Render("Airlight", false);
  const Buffer on = scene.Render("Airlight", true);
  auto* traced = scene.Trace()->GetArray("Airlight");
  int shadowed = 0;
  ForPixels([&](int i, int j, int c, int index) {
    const PixelRay ray = scene.GetRay(i, j);
    const double end = scene.GetEnd(i, j);
    double several[3];
    double once[3];
    vtkAirlight::MultipleScattering(
      scene.Medium, Lamp, Intensity, &ray.Origin.x, &ray.Direction.x, end, several);
    vtkAirlight::Inscatter(
      scene.Medium, Lamp, Intensity, &ray.Origin.x, &ray.Direction.x, 0.0, end, once);
    const double share = std::min(off[index] / once[c], 1.0);
    shadowed += share < 0.9 ? 1 : 0;
    const double around = 0.25 * (1.0 - 0.4 * 0.4); // g is 0.4
    const double expected = (around + (1.0 - around) * share) * several[c];
    shares.Add(std::abs(on[index] - off[index] - expected) / on[index], 1e-2, [&] {
      return Text("pixel ", i, " ", j, ", channel ", c, ": added ", on[index] - off[index], " for ",
        expected, ", share ", share);
    });
    const double found = traced->GetComponent(j * PixelScene::Width + i, c);
    reference.Add(std::abs(on[index] - found) / found, 2e-3,
      [&] { return Text("pixel ", i, " ", j, ", channel ", c, ": ", on[index], " for ", found); });
  });
  if (shadowed < 20)
  {
    std::cerr << "FAILED: only " << shadowed << " values are in shadow\n";
    return false;
  }
  return AllOk({ &shares, &reference });
}

//------------------------------------------------------------------------------
// A sun neither lights a lamp's shadow nor loses what it scatters onto surfaces: with both lights
// there is the sum of both.
bool TestSunBeside()
{
  FoggyPlane scene(vtkParticipatingMedium::BOX);
  scene.AddBall(-0.1, 0.3, 1.2, 0.3);
  scene.Pass->SetShadowTechnique(vtkAirlightPass::SHADOW_PLANES);
  scene.Pass->ScatteredSurfaceLightOn();
  vtkNew<vtkLight> sun;
  sun->SetPosition(-1.0, -2.0, 5.0);
  sun->SetFocalPoint(0.0, 0.0, 0.0);
  sun->SetIntensity(3.0);
  scene.Renderer->AddLight(sun);
  bool ok = true;
  for (const char* buffer : { "Airlight", "Surface" })
  {
    const Buffer both = scene.Render(buffer, true);
    scene.Light->SwitchOff();
    const Buffer sunlit = scene.Render(buffer, true);
    scene.Light->SwitchOn();
    sun->SwitchOff();
    const Buffer lamplit = scene.Render(buffer, true);
    sun->SwitchOn();
    Comparison comparison(Text("a sun and a lamp, ", buffer, ", relative"));
    ForPixels([&](int i, int j, int c, int index) {
      const double sum = static_cast<double>(sunlit[index]) + lamplit[index];
      comparison.Add(std::abs(both[index] - sum) / sum, 1e-3, [&] {
        return Text("pixel ", i, " ", j, ", channel ", c, ": ", both[index], " for ", sunlit[index],
          " + ", lamplit[index]);
      });
    });
    ok &= comparison.Report();
  }
  return ok;
}

//------------------------------------------------------------------------------
// The buffer of what is scattered more than once: the airlight without what is scattered once, 0
// where nothing else is.
bool CheckBuffer(FoggyPlane& scene, const Buffer& once, const Buffer& air, const std::string& name)
{
  const Buffer several = scene.Render("MultipleScattering", true);
  const Buffer none = scene.Render("MultipleScattering", false);
  Comparison comparison(Text(name, ", MultipleScattering, relative to the airlight"));
  for (size_t i = 0; i < air.size(); ++i)
  {
    comparison.Add(std::abs(once[i] + several[i] - air[i]) / air[i], 1e-6,
      [&] { return Text("value ", i, ": ", several[i], " for ", air[i], " - ", once[i]); });
  }
  const bool dark =
    std::all_of(none.begin(), none.end(), [](float value) { return value == 0.0f; });
  if (!dark || none.size() != air.size())
  {
    std::cerr << "FAILED: " << name << ", scattered once, has light that is scattered again\n";
  }
  return comparison.Report() && dark && none.size() == air.size();
}

//------------------------------------------------------------------------------
// Suns, spots, lamps outside and in fog that falls with height, in the air and on surfaces, with a
// caster: as the reference has it.
bool TestOtherLights()
{
  bool ok = true;
  for (const char* kind : { "sun in a box", "sun in fog", "lamp in fog", "spot", "lamp outside" })
  {
    const std::string name = kind;
    FoggyPlane scene(name == "sun in a box" ? vtkParticipatingMedium::BOX
        : name == "lamp outside"            ? vtkParticipatingMedium::SPHERE
                                            : vtkParticipatingMedium::UNBOUNDED);
    scene.AddBall(-0.1, 0.3, 1.2, 0.3);
    scene.Pass->SetShadowTechnique(vtkAirlightPass::SHADOW_PLANES);
    scene.Light->SetFocalPoint(0.0, 0.0, 0.0);
    scene.Light->SetPosition(name == "lamp outside" ? 4.0 : -1.0, -2.0, 5.0);
    if (name == "spot")
    {
      scene.Light->SetConeAngle(25.0);
    }
    else if (name != "lamp outside" && name != "lamp in fog")
    {
      vtkAirlight::SetIrradiance(scene.Light, Intensity);
    }
    if (name == "sun in fog" || name == "lamp in fog")
    {
      scene.Medium->SetDensityToExponentialHeight();
      scene.Medium->SetUp(0.0, 0.0, 1.0);
      scene.Medium->SetGround(name == "sun in fog");
    }
    ErrorListener messages(scene.Pass, vtkCommand::WarningEvent);
    const Buffer once = scene.Render("Airlight", false);
    const Buffer surfaceOnce = scene.Render("Surface", false);
    const Buffer air = scene.Render("Airlight", true);
    const Buffer surface = scene.Render("Surface", true);
    vtkPointData* traced = scene.Trace();
    Comparison comparison(Text(name, ", beside the reference, relative"));
    double more = 0.0;
    double moreOnSurfaces = 0.0;
    ForPixels([&](int i, int j, int c, int index) {
      const int pixel = j * PixelScene::Width + i;
      more = std::max<double>(more, air[index] - once[index]);
      moreOnSurfaces = std::max<double>(moreOnSurfaces, surface[index] - surfaceOnce[index]);
      const double whole = air[index] + surface[index];
      const double found = traced->GetArray("Airlight")->GetComponent(pixel, c) +
        traced->GetArray("Surface")->GetComponent(pixel, c);
      comparison.Add(std::abs(whole - found) / found, 2e-3,
        [&] { return Text("pixel ", i, " ", j, ", channel ", c, ": ", whole, " for ", found); });
    });
    ok &= comparison.Report() & CheckBuffer(scene, once, air, name);
    if (more < 1e-3 || moreOnSurfaces < 1e-3 || messages.Take() != 0)
    {
      std::cerr << "FAILED: " << name << " is scattered more than once: " << more << ", "
                << moreOnSurfaces << ", " << messages.GetText() << "\n";
      ok = false;
    }
  }
  return ok;
}

//------------------------------------------------------------------------------
// A surface that is nearly opaque looks as one that is.
bool TestTranslucent()
{
  Comparison comparison("a nearly opaque ball beside an opaque one");
  FoggyPlane scene(vtkParticipatingMedium::UNBOUNDED);
  scene.AddBall(-0.3, 0.0, 1.0, 0.6);
  scene.Pass->SetShadowTechniqueToNone();
  scene.BallActor->GetProperty()->SetDiffuse(0.2);
  const Buffer opaque = scene.Render("Radiance", true);
  scene.BallActor->GetProperty()->SetOpacity(0.9999);
  const Buffer translucent = scene.Render("Radiance", true);
  const Buffer once = scene.Render("Radiance", false);
  double more = 0.0;
  ForPixels([&](int i, int j, int c, int index) {
    more = std::max<double>(more, translucent[index] / once[index]);
    comparison.Add(std::abs(translucent[index] / opaque[index] - 1.0), 2e-3, [&] {
      return Text(
        "pixel ", i, " ", j, ", channel ", c, ": ", translucent[index], " for ", opaque[index]);
    });
  });
  if (more < 1.3)
  {
    std::cerr << "FAILED: multiple scattering adds only " << more << "\n";
    return false;
  }
  return comparison.Report();
}

//------------------------------------------------------------------------------
// Off, the picture is as before; where light is scattered forward a spotlight is scattered once,
// with a message.
bool TestLimits()
{
  FoggyPlane scene(vtkParticipatingMedium::UNBOUNDED);
  const Buffer before = scene.Render("Radiance", false);
  const Buffer on = scene.Render("Radiance", true);
  const Buffer after = scene.Render("Radiance", false);
  bool ok = before == after && on != before;
  if (!ok)
  {
    std::cerr << "FAILED: switched off, it leaves no trace\n";
  }
  ErrorListener messages(scene.Pass, vtkCommand::WarningEvent);
  scene.Medium->SetAnisotropy(0.8);
  scene.Light->SetConeAngle(30.0);
  scene.Light->SetFocalPoint(0.0, 0.0, 0.0);
  const Buffer spot = scene.Render("Radiance", false);
  scene.Render("Radiance", true);
  const Buffer same = scene.Render("Radiance", true);
  if (spot != same || messages.Take() != 1 ||
    messages.GetText().find("Multiple scattering leaves out 1 of the lights") == std::string::npos)
  {
    std::cerr << "FAILED: a spotlight is scattered once, with one message\n";
    ok = false;
  }
  return ok;
}

//------------------------------------------------------------------------------
// Of 18 lamps 16 are scattered more than once, with a message; the others are as without.
bool TestManyLamps()
{
  FoggyPlane scene(vtkParticipatingMedium::UNBOUNDED);
  std::vector<vtkSmartPointer<vtkLight>> lamps;
  const auto addLamp = [&](int i) {
    auto lamp = vtkSmartPointer<vtkLight>::New();
    const double intensity[3] = { 1.0 + i, 2.0, 3.0 };
    vtkAirlight::SetRadiantIntensity(lamp, intensity);
    lamp->SetPosition(0.3 * i - 2.0, 0.4 * (i % 3), 1.0);
    scene.Renderer->AddLight(lamp);
    lamps.push_back(lamp);
  };
  for (int i = 0; i < 15; ++i)
  {
    addLamp(i);
  }
  ErrorListener messages(scene.Pass, vtkCommand::WarningEvent);
  const Buffer sixteen = scene.Render("MultipleScattering", true);
  bool ok = messages.Take() == 0;
  addLamp(15);
  addLamp(16);
  const Buffer eighteen = scene.Render("MultipleScattering", true);
  ok &= messages.Take() == 1 &&
    messages.GetText().find("Multiple scattering leaves out 2 of the lights") != std::string::npos;
  if (!ok || sixteen != eighteen)
  {
    std::cerr << "FAILED: 2 of 18 lamps are left out, with one message: " << messages.GetText()
              << "\n";
  }
  return ok && sixteen == eighteen;
}
}

//------------------------------------------------------------------------------
int TestMultipleScatteringPass(int, char*[])
{
  const bool ok = TestPlane() & TestShadow() & TestSunBeside() & TestOtherLights() &
    TestTranslucent() & TestLimits() & TestManyLamps();
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
