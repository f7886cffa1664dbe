// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlightPass::SetScatteredSurfaceLight(): what the pass adds to a plane, against brute force
// (see AirlightTestIrradiance.h), and what must stay as it is. The mathematics is in
// TestScatteredIrradiance.

#include "AirlightTestIrradiance.h"
#include "AirlightTestPixelScene.h"
#include "AirlightTestTools.h"

#include "vtkFloatArray.h"
#include "vtkPointData.h"

#include <cstdlib>
#include <functional>

using namespace airlight_test;

namespace
{
const glm::dvec3 Diffuse(0.9, 0.6, 0.3);

// A plane z = 0, seen obliquely from z > 0 through fog.
class LitPlane : public PixelScene
{
public:
  LitPlane()
  {
    this->AddBroadPlane(Diffuse);
    this->Medium->SetScattering(0.3, 0.2, 0.4);
    this->Medium->SetAbsorption(0.1, 0.0, 0.0);
    this->Medium->SetBounds(-2.5, 3.0, -4.0, 3.5, 0.0, 6.0);
    this->Renderer->GetActiveCamera()->SetViewUp(0.2, 1.0, 0.3);
    const double intensity[3] = { 10.0, 20.0, 5.0 };
    vtkAirlight::SetRadiantIntensity(this->Light, intensity);
    this->Light->SetExponent(0.0);
    this->Light->SetPosition(0.5, 0.3, 1.2);
    this->Light->SetFocalPoint(0.3, 1.2, 0.3);
    this->Renderer->AddLight(this->Light);
  }

  vtkSmartPointer<vtkFloatArray> Render(const char* buffer, bool scattered)
  {
    this->Pass->SetScatteredSurfaceLight(scattered);
    this->RenderFitted();
    auto copy = vtkSmartPointer<vtkFloatArray>::New();
    copy->DeepCopy(this->Pass->GetBuffer(buffer)->GetPointData()->GetScalars());
    return copy;
  }
};

bool AreSame(vtkFloatArray* a, vtkFloatArray* b)
{
  return std::equal(a->Begin(), a->End(), b->Begin(), b->End());
}

//------------------------------------------------------------------------------
// (on - off)/transmittance = rho E/pi.
void ComparePlane(LitPlane& plane, const std::string& name, double limit, Comparison& comparison)
{
  PixelScene& scene = plane;
  const auto off = plane.Render("Surface", false);
  const auto on = plane.Render("Surface", true);
  for (int k = 0; k < 12; ++k)
  {
    const int i = 5 + 17 * (k % 4) + k / 4;
    const int j = 6 + 16 * (k / 4);
    const PixelRay ray = scene.GetRay(i, j);
    const glm::dvec3 point = ray.Origin - ray.Origin.z / ray.Direction.z * ray.Direction;
    const glm::dvec3 expected =
      Hemisphere(scene.Medium, plane.Light, point, glm::dvec3(0.0, 0.0, 1.0)).Irradiance(1);
    const float* passes = scene.GetPixel("Transmittance", i, j);
    for (int c = 0; c < 3; ++c)
    {
      const int index = 3 * (j * PixelScene::Width + i) + c;
      const double added = (on->GetValue(index) - off->GetValue(index)) / passes[c];
      comparison.Add(std::abs(added * Pi / (Diffuse[c] * expected[c]) - 1.0), limit, [&] {
        return Text(name, ", pixel ", i, " ", j, ", channel ", c, ": added ", added, ", E ",
          expected[c], ", direct ", off->GetValue(index) / passes[c]);
      });
    }
  }
}

bool TestPlane()
{
  Comparison round("added to a plane, unbounded, relative");
  Comparison cone("added to a plane by a spot, relative");
  Comparison box("added to a plane, box, relative");
  Comparison sun("added to a plane by a directional light, box, relative");
  for (const double g : { 0.0, 0.7 })
  {
    for (const int region : { vtkParticipatingMedium::UNBOUNDED, vtkParticipatingMedium::BOX })
    {
      const bool unbounded = region == vtkParticipatingMedium::UNBOUNDED;
      LitPlane plane;
      plane.Medium->SetRegion(region);
      plane.Medium->SetPhaseFunctionToHenyeyGreenstein();
      plane.Medium->SetAnisotropy(g);
      plane.Renderer->GetActiveCamera()->SetParallelProjection(g > 0.0);
      plane.Renderer->GetActiveCamera()->SetParallelScale(2.5);
      const std::string where = Text("g ", g, unbounded ? ", unbounded" : ", box");
      ComparePlane(
        plane, "point light, " + where, unbounded ? 0.003 : 0.01, unbounded ? round : box);
      plane.Light->SetConeAngle(40.0);
      ComparePlane(plane, "spot, " + where, 0.01, cone);
      plane.Light->SetConeAngle(90.0);
      plane.Light->PositionalOff();
      plane.Light->SetAttenuationValues(1.0, 0.0, 0.0);
      ComparePlane(
        plane, "directional light, " + where, unbounded ? 0.003 : 0.03, unbounded ? round : sun);
    }
  }
  return AllOk({ &round, &cone, &box, &sun });
}

//------------------------------------------------------------------------------
// VTK's physically based shading has a diffuse part of albedo/pi and gamma-corrects: a light of
// colour E/pi, head on, adds (1 - metallic) albedo E/pi^2 before that.
bool TestPhysicallyBased()
{
  Comparison comparison("added to a physically based material, relative");
  for (const double metallic : { 0.0, 0.75 })
  {
    LitPlane plane;
    plane.Actor->GetProperty()->SetInterpolationToPBR();
    plane.Actor->GetProperty()->SetMetallic(metallic);
    const auto off = plane.Render("Surface", false);
    const auto on = plane.Render("Surface", true);
    const int i = 30;
    const int j = 20;
    const PixelRay ray = plane.GetRay(i, j);
    const glm::dvec3 point = ray.Origin - ray.Origin.z / ray.Direction.z * ray.Direction;
    const glm::dvec3 expected =
      Hemisphere(plane.Medium, plane.Light, point, glm::dvec3(0.0, 0.0, 1.0)).Irradiance(1);
    for (int c = 0; c < 3; ++c)
    {
      const int index = 3 * (j * PixelScene::Width + i) + c;
      const float passes = plane.GetPixel("Transmittance", i, j)[c];
      const double added =
        std::pow(on->GetValue(index) / passes, 2.2) - std::pow(off->GetValue(index) / passes, 2.2);
      const double right = (1.0 - metallic) * Diffuse[c] * expected[c] / (Pi * Pi);
      comparison.Add(std::abs(added / right - 1.0), 0.003, [&] {
        return Text("metallic ", metallic, ", channel ", c, ": ", added, ", expected ", right);
      });
    }
  }
  return AllOk({ &comparison });
}

//------------------------------------------------------------------------------
// Whether the option must leave the picture as it is, to the last bit, or must not.
bool TestWhatChanges()
{
  Comparison comparison("pictures that stay (0) or change (1)");
  const auto check = [&](
                       const char* name, bool changes, const std::function<void(LitPlane&)>& set) {
    LitPlane plane;
    set(plane);
    const auto before = plane.Render("Radiance", false);
    const bool changed = !AreSame(before, plane.Render("Radiance", true));
    const bool returns = AreSame(before, plane.Render("Radiance", false));
    LitPlane fresh;
    set(fresh);
    const bool freshSame = AreSame(before, fresh.Render("Radiance", false));
    comparison.Add(changed == changes && returns && freshSame ? 0.0 : 1.0, 0.5, [&] {
      return Text(
        name, ": changes ", changed, ", returns ", returns, ", as a fresh pass's ", freshSame);
    });
  };
  check("fog", true, [](LitPlane&) {});
  // Fogged as what lies behind: fog without end would hide it.
  check("translucent", true, [](LitPlane& p) {
    p.Actor->GetProperty()->SetOpacity(0.5);
    p.Medium->SetRegionToBox();
  });
  check("no medium", false, [](LitPlane& p) { p.Pass->RemoveAllMedia(); });
  check("clear medium", false, [](LitPlane& p) {
    p.Medium->SetScattering(0.0, 0.0, 0.0);
    p.Medium->SetAbsorption(0.0, 0.0, 0.0);
  });
  check("absorption only", false, [](LitPlane& p) { p.Medium->SetScattering(0, 0, 0); });
  check("lighting off", false, [](LitPlane& p) { p.Actor->GetProperty()->LightingOff(); });
  check("light switched off", false, [](LitPlane& p) { p.Light->SwitchOff(); });
  check("black light", false, [](LitPlane& p) { p.Light->SetIntensity(0.0); });
  check(
    "light not scattered", false, [](LitPlane& p) { p.Pass->SetLightScatters(p.Light, false); });
  check("metal", false, [](LitPlane& p) {
    p.Actor->GetProperty()->SetInterpolationToPBR();
    p.Actor->GetProperty()->SetMetallic(1.0);
  });
  return AllOk({ &comparison });
}

// Two lights of different kinds add what each adds alone.
bool TestTwoLights()
{
  Comparison comparison("two lights against their sum, relative");
  LitPlane plane;
  vtkNew<vtkLight> sun;
  const double irradiance[3] = { 1.0, 2.0, 3.0 };
  vtkAirlight::SetIrradiance(sun, irradiance);
  sun->SetPosition(1.0, 2.0, 1.0);
  plane.Renderer->AddLight(sun);
  const auto added = [&](bool first, bool second) {
    plane.Light->SetSwitch(first);
    sun->SetSwitch(second);
    const auto off = plane.Render("Surface", false);
    const auto on = plane.Render("Surface", true);
    const int index = 3 * (20 * PixelScene::Width + 30) + 1;
    return static_cast<double>(on->GetValue(index)) - off->GetValue(index);
  };
  const double sum = added(true, false) + added(false, true);
  const double both = added(true, true);
  comparison.Add(
    std::abs(both / sum - 1.0), 1e-5, [&] { return Text("sum ", sum, ", both ", both); });
  return AllOk({ &comparison });
}

//------------------------------------------------------------------------------
// Finite whatever the light's place; and not less than without.
bool TestFinite()
{
  Comparison comparison("values, finite (0) or not (1)");
  LitPlane plane;
  const PixelRay ray = plane.GetRay(30, 20);
  const glm::dvec3 seen = ray.Origin - ray.Origin.z / ray.Direction.z * ray.Direction;
  const glm::dvec3 places[] = { seen, seen + glm::dvec3(0.0, 0.0, 1e-7), { 0.0, 0.0, -1.0 },
    ray.Origin, { 1e6, 0.0, 0.0 }, { 0.0, 0.0, 6.0 } };
  for (int region = 0; region < 3; ++region)
  {
    plane.Medium->SetRegion(region);
    for (int kind = 0; kind < 3; ++kind)
    {
      plane.Light->SetConeAngle(kind == 1 ? 30.0 : 90.0);
      plane.Light->SetExponent(kind == 1 ? 2.0 : 0.0);
      plane.Light->SetPositional(kind != 2);
      // Every other combination, for the time that they take.
      for (int k = (region + kind) % 2; k < 6; k += 2)
      {
        const glm::dvec3& place = places[k];
        plane.Light->SetPosition(&place.x);
        plane.Light->SetFocalPoint(place.x, place.y + 0.1, place.z - 1.0);
        const auto off = plane.Render("Radiance", false);
        const auto on = plane.Render("Radiance", true);
        for (vtkIdType i = 0; i < on->GetNumberOfValues(); ++i)
        {
          const bool ok = std::isfinite(on->GetValue(i)) && on->GetValue(i) >= off->GetValue(i);
          comparison.Add(ok ? 0.0 : 1.0, 0.5, [&] {
            return Text("region ", region, ", kind ", kind, ", light ", Text3(&place.x), ", value ",
              i, ": ", on->GetValue(i), " from ", off->GetValue(i));
          });
        }
      }
    }
  }
  return AllOk({ &comparison });
}
}

//------------------------------------------------------------------------------
int TestScatteredSurfaceLight(int, char*[])
{
  bool ok = TestPlane();
  ok = TestPhysicallyBased() && ok;
  ok = TestWhatChanges() && ok;
  ok = TestTwoLights() && ok;
  return TestFinite() && ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
