// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// A low sun behind towers in ground fog that thins out exponentially with height, without bounds:
// the towers' shadows run through the fog towards the eye, which stands in one of them.

#include "AirlightTestSceneRays.h"

#include "vtkConeSource.h"

using namespace airlight_test;

namespace
{
const glm::dvec3 ToSun = glm::normalize(glm::dvec3(-0.16, 0.2, -1.0));
const glm::dvec3 Irradiance(10.5, 8.7, 6.4);

// At the ground, y = 0.
const glm::dvec3 SigmaS(0.052, 0.056, 0.062);
const glm::dvec3 SigmaA(0.004, 0.004, 0.005);
constexpr double ScaleHeight = 2.2;
constexpr double Anisotropy = 0.2;
const glm::dvec3 AmbientRadiance(0.08, 0.11, 0.17);

constexpr double AmbientLight = 0.2;
const glm::dvec3 GroundAlbedo(0.2, 0.2, 0.17);

// The tower in whose shadow the eye stands.
constexpr double TowerX = -1.2;
constexpr double TowerZ = -6.0;
constexpr double TowerWidth = 2.0;

//------------------------------------------------------------------------------
void AddTower(Scene& scene, double x, double z, double width, double height, double roof)
{
  const glm::dvec3 stone(0.32, 0.3, 0.28);
  const double half = 0.5 * width;
  scene.AddBox({ x - half, -0.1, z - half }, { x + half, height, z + half }, stone);
  scene.AddBox({ x - half - 0.12, height - 0.35, z - half - 0.12 },
    { x + half + 0.12, height, z + half + 0.12 }, stone);
  if (roof > 0.0)
  {
    vtkNew<vtkConeSource> cone;
    cone->SetDirection(0.0, 1.0, 0.0);
    cone->SetCenter(x, height + 0.5 * roof, z);
    cone->SetHeight(roof);
    cone->SetRadius(half + 0.25);
    cone->SetResolution(8);
    Scene::Paint(scene.Add(cone), { 0.3, 0.16, 0.12 }, scene.AmbientLight);
  }
}

void AddCastle(Scene& scene)
{
  const glm::dvec3 stone(0.32, 0.3, 0.28);
  AddTower(scene, TowerX, TowerZ, TowerWidth, 5.6, 2.4);
  AddTower(scene, -6.2, -8.5, 1.5, 4.2, 1.8);
  AddTower(scene, 3.4, -7.5, 1.4, 3.9, 1.6);
  AddTower(scene, 7.4, -11.0, 1.6, 4.6, 0.0);
  AddTower(scene, -11.5, -13.0, 1.6, 4.8, 0.0);
  AddTower(scene, 12.5, -16.0, 1.8, 5.5, 2.2);
  scene.AddBox({ -6.0, -0.1, -8.2 }, { -1.6, 1.9, -7.7 }, stone);
  scene.AddBox({ -0.8, -0.1, -7.2 }, { 3.2, 1.7, -6.7 }, stone);
}

//------------------------------------------------------------------------------
// Optical depth per unit extinction at y = 0, from a to b: the integral of exp(-y/H) along a
// straight way.
double Depth(const glm::dvec3& a, const glm::dvec3& b)
{
  const double length = glm::length(b - a);
  const double rise = (b.y - a.y) / ScaleHeight;
  const double mean = std::abs(rise) < 1e-12 ? 1.0 : -std::expm1(-rise) / rise;
  return length * std::exp(-a.y / ScaleHeight) * mean;
}

Physics GetPhysics()
{
  Physics physics;
  physics.Reach = [](const Ray&, double end) { return std::vector<Interval>{ { 0.0, end } }; };
  physics.Scattered = [](const Ray& ray, double t, int k) {
    const double cosine = glm::dot(ToSun, ray.Direction);
    const HenyeyGreensteinPhase phase{ Anisotropy };
    const glm::dvec3 point = ray.Origin + t * ray.Direction;
    const double density = std::exp(-point.y / ScaleHeight);
    const double depth = Depth(ray.Origin, point) + density * ScaleHeight / ToSun.y;
    return SigmaS[k] * density * Irradiance[k] * phase(1.0 - cosine, 1.0 + cosine) *
      std::exp(-(SigmaS[k] + SigmaA[k]) * depth);
  };
  physics.Ambient = [](const Ray& ray, double end, int k) {
    const double sigmaT = SigmaS[k] + SigmaA[k];
    const double far = std::min(end, 1e4);
    return SigmaS[k] / sigmaT * AmbientRadiance[k] *
      -std::expm1(-sigmaT * Depth(ray.Origin, ray.Origin + far * ray.Direction));
  };
  return physics;
}

void Build(Scene& scene)
{
  scene.AmbientLight = AmbientLight;
  scene.Renderer->SetBackground(0.03, 0.05, 0.09);
  scene.Medium->SetScattering(&SigmaS.x);
  scene.Medium->SetAbsorption(&SigmaA.x);
  scene.Medium->SetAmbientRadiance(&AmbientRadiance.x);
  scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
  scene.Medium->SetAnisotropy(Anisotropy);
  scene.Medium->SetDensityToExponentialHeight();
  scene.Medium->SetScaleHeight(ScaleHeight);
  scene.AddDirectionalLight(ToSun, Irradiance);
  scene.AddBox({ -400, -1, -400 }, { 400, 0, 100 }, GroundAlbedo);
  AddCastle(scene);
  scene.Look({ 0.9, 2.0, 12.0 }, { 1.0, 3.1, -6.0 });
  scene.Renderer->GetActiveCamera()->SetViewAngle(42.0);
  scene.Renderer->GetActiveCamera()->SetClippingRange(0.1, 1000.0);
}

//------------------------------------------------------------------------------
// A ray to the ground that leaves the first tower's shadow on its way. Along the sun's direction
// x - a z stays, a = 0.16, so that the shadow's side is where that equals its value at the tower's
// far right edge; the ray is below the shadow of the tower's cornice and above that of the wall.
// On the lit part, with D(t) the depth from the eye to t and on to the sun,
// dD/dt = sigmaT exp(-y/H) (1 - m/mu), m and mu the rises of ray and sun: the integral is closed.
void CheckLitGround(Scene& scene)
{
  const double a = ToSun.x / ToSun.z;
  const glm::ivec2 pixel = scene.GetPixel({ 2.6, 0.0, 3.5 });
  const Ray ray = scene.GetPixelRay(pixel);
  const double end = -ray.Origin.y / ray.Direction.y;
  const double side = TowerX + 0.5 * TowerWidth - a * (TowerZ - 0.5 * TowerWidth);
  const double from =
    (side - ray.Origin.x + a * ray.Origin.z) / (ray.Direction.x - a * ray.Direction.z);
  CheckClose(GetValue(scene.GetBuffer("LitLength"), pixel.x, pixel.y), end - from, 1e-4,
    "length beside the tower's shadow");
  const HenyeyGreensteinPhase phase{ Anisotropy };
  const double cosine = glm::dot(ToSun, ray.Direction);
  glm::dvec3 expected;
  for (int k = 0; k < 3; ++k)
  {
    const double sigmaT = SigmaS[k] + SigmaA[k];
    const auto passes = [&](double t) {
      const glm::dvec3 point = ray.Origin + t * ray.Direction;
      const double toSun = std::exp(-point.y / ScaleHeight) * ScaleHeight / ToSun.y;
      return std::exp(-sigmaT * (Depth(ray.Origin, point) + toSun));
    };
    const double ambient = AmbientRadiance[k] *
      -std::expm1(-sigmaT * Depth(ray.Origin, ray.Origin + end * ray.Direction));
    expected[k] = SigmaS[k] / sigmaT *
      (ambient +
        Irradiance[k] * phase(1.0 - cosine, 1.0 + cosine) * (passes(from) - passes(end)) /
          (1.0 - ray.Direction.y / ToSun.y));
  }
  CheckClose(GetColour(scene.GetBuffer("Airlight"), pixel.x, pixel.y), expected,
    1e-4 + scene.Medium->GetPhaseErrorBound(), "airlight beside the tower's shadow");
}

// The ground in the sun and in the tower's shadow.
void CheckGround(Scene& scene)
{
  const auto direct = [](const glm::dvec3&, int k) {
    return Irradiance[k] / Pi * ToSun.y *
      std::exp(-(SigmaS[k] + SigmaA[k]) * ScaleHeight / ToSun.y);
  };
  const auto passes = [](const Ray& ray, double t, int k) {
    const glm::dvec3 point = ray.Origin + t * ray.Direction;
    return std::exp(-(SigmaS[k] + SigmaA[k]) * Depth(ray.Origin, point));
  };
  CheckFloor(scene, { GroundAlbedo, AmbientLight, direct, passes }, { 2.6, 0.0, 3.5 },
    { 0.3, 0.0, 3.0 }, "ground in the sun", "ground in the sun and in shadow");
}
}

//------------------------------------------------------------------------------
int TestHeightFogSun(int argc, char* argv[])
{
  Scene scene(640, 480);
  scene.SmoothEdges();
  Build(scene);
  scene.Window->Render();
  const double limit = 1e-4 + scene.Medium->GetPhaseErrorBound();
  // Where little of a ray is lit, the single precision of that part's ends shows.
  CompareRays(scene, GetPhysics(), limit, 1e-3);
  CheckLitGround(scene);
  CheckGround(scene);
  return scene.Finish(argc, argv);
}
