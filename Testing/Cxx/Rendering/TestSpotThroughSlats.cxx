// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// A spot shines through the slats of a hanging louvre in thin fog: separate shafts, and stripes on
// the floor.

#include "AirlightTestSceneRays.h"

#include "vtkConeSource.h"

using namespace airlight_test;

namespace
{
const glm::dvec3 Lamp(-1.05, 5.3, 0.0);
const glm::dvec3 Aim(-0.3, 3.4, 0.0);
const glm::dvec3 Intensity(680.0, 600.0, 480.0);
constexpr double ConeAngle = 27.0; // half the opening

const glm::dvec3 SigmaS(0.085, 0.085, 0.09);
const glm::dvec3 SigmaA(0.005, 0.005, 0.004);
const glm::dvec3 AmbientRadiance(0.06, 0.075, 0.11);

// The louvre's slats lie along z.
constexpr int Slats = 8;
constexpr double Pitch = 0.4;
constexpr double SlatWidth = 0.2;
constexpr double FirstSlat = -1.8;
constexpr double Bottom = 3.4;
constexpr double Top = 3.45;
constexpr double SlatEnd = 1.25;

constexpr double AmbientLight = 0.9;
const glm::dvec3 FloorAlbedo(0.27, 0.26, 0.25);

//------------------------------------------------------------------------------
void AddLouvre(Scene& scene)
{
  const glm::dvec3 wood(0.5, 0.33, 0.2);
  for (int i = 0; i < Slats; ++i)
  {
    const double x = FirstSlat + i * Pitch;
    scene.AddBox({ x, Bottom, -SlatEnd }, { x + SlatWidth, Top, SlatEnd }, wood);
  }
  const double left = FirstSlat - 0.06;
  const double right = FirstSlat + (Slats - 1) * Pitch + SlatWidth + 0.06;
  for (const double z : { -SlatEnd, SlatEnd })
  {
    scene.AddBox({ left, 3.38, z - 0.03 }, { right, 3.47, z + 0.05 }, wood);
    for (const double x : { left, right })
    {
      scene.AddBox({ x - 0.015, 3.46, z - 0.015 }, { x + 0.015, 8.0, z + 0.015 }, glm::dvec3(0.2));
    }
  }
}

// Where the ray is inside the spot's cone: between the roots of
// (v.a)^2 = cos^2 (v.v), v = origin + t direction - lamp.
std::vector<Interval> ReachOfSpot(const Ray& ray, double end)
{
  const glm::dvec3 axis = glm::normalize(Aim - Lamp);
  const glm::dvec3 v = ray.Origin - Lamp;
  const double cosine = std::cos(glm::radians(ConeAngle));
  const double da = glm::dot(ray.Direction, axis);
  const double va = glm::dot(v, axis);
  const double c2 = cosine * cosine;
  const double a = da * da - c2;
  const double b = da * va - c2 * glm::dot(ray.Direction, v);
  const double c = va * va - c2 * glm::dot(v, v);
  std::vector<double> cuts = { 0.0, end };
  if (b * b > a * c)
  {
    cuts.push_back(glm::clamp((-b - std::sqrt(b * b - a * c)) / a, 0.0, end));
    cuts.push_back(glm::clamp((-b + std::sqrt(b * b - a * c)) / a, 0.0, end));
  }
  std::sort(cuts.begin(), cuts.end());
  std::vector<Interval> result;
  for (size_t i = 1; i < cuts.size(); ++i)
  {
    const glm::dvec3 x = v + 0.5 * (cuts[i - 1] + cuts[i]) * ray.Direction;
    if (cuts[i] > cuts[i - 1] && glm::dot(x, axis) > cosine * glm::length(x))
    {
      result.push_back({ cuts[i - 1], cuts[i] });
    }
  }
  return result;
}

Physics GetPhysics()
{
  Physics physics;
  physics.Reach = ReachOfSpot;
  physics.Scattered = [](const Ray& ray, double t, int k) {
    const double r = glm::length(Lamp - ray.Origin - t * ray.Direction);
    return SigmaS[k] * Intensity[k] / (4.0 * Pi * r * r) *
      std::exp(-(SigmaS[k] + SigmaA[k]) * (t + r));
  };
  physics.Ambient = [](const Ray&, double end, int k) {
    const double sigmaT = SigmaS[k] + SigmaA[k];
    return SigmaS[k] / sigmaT * AmbientRadiance[k] * (1.0 - std::exp(-sigmaT * end));
  };
  return physics;
}

//------------------------------------------------------------------------------
void Build(Scene& scene)
{
  scene.AmbientLight = AmbientLight;
  scene.Medium->SetScattering(&SigmaS.x);
  scene.Medium->SetAbsorption(&SigmaA.x);
  scene.Medium->SetAmbientRadiance(&AmbientRadiance.x);
  vtkLight* light = scene.AddPointLight(Lamp, Intensity);
  light->SetFocalPoint(Aim.x, Aim.y, Aim.z);
  light->SetConeAngle(ConeAngle);
  light->SetExponent(0.0);
  AddLouvre(scene);
  scene.AddBox({ -12, -0.2, -6 }, { 12, 0, 9 }, FloorAlbedo);
  scene.AddBox({ -12, -0.2, -6.2 }, { 12, 9, -6 }, { 0.4, 0.4, 0.42 });
  scene.AddBall({ 2.2, 0.6, 0.2 }, 0.6, { 0.3, 0.28, 0.27 });
  vtkNew<vtkConeSource> shade; // around the lamp, wider than its light
  shade->SetRadius(0.26);
  shade->SetHeight(0.45);
  shade->CappingOff();
  shade->SetResolution(48);
  const glm::dvec3 axis = glm::normalize(Aim - Lamp);
  const glm::dvec3 centre = Lamp + 0.145 * axis;
  shade->SetCenter(centre.x, centre.y, centre.z);
  shade->SetDirection(-axis.x, -axis.y, -axis.z);
  Scene::Paint(scene.Add(shade), { 0.25, 0.25, 0.28 }, 0.6);
  scene.Look({ 1.1, 3.3, 12.0 }, { 0.45, 2.35, 0.0 });
  scene.Renderer->GetActiveCamera()->SetViewAngle(33.0);
}

//------------------------------------------------------------------------------
// The light's way to height 0 has slope (x - Lamp.x)/(Lamp.y - y) = s. A gap lets through what
// passes right of the one slat's right edges and left of the next one's left edges.
struct Gap
{
  double From;
  double To;
};

Gap GetGap(int i)
{
  const double left = FirstSlat + i * Pitch + SlatWidth - Lamp.x;
  const double right = FirstSlat + (i + 1) * Pitch - Lamp.x;
  return { std::max(left / (Lamp.y - Bottom), left / (Lamp.y - Top)),
    std::min(right / (Lamp.y - Bottom), right / (Lamp.y - Top)) };
}

// Rays below the louvre and beside the ball, by the slats' shadow planes and the cone alone.
void CheckShafts(Scene& scene)
{
  for (const glm::dvec3& point :
    { glm::dvec3(-0.8, 1.7, 0.0), glm::dvec3(0.1, 1.5, 0.0), glm::dvec3(1.15, 2.0, 0.0) })
  {
    const glm::ivec2 pixel = scene.GetPixel(point);
    const Ray ray = scene.GetPixelRay(pixel);
    const double end = std::min((-6.0 - ray.Origin.z) / ray.Direction.z,
      ray.Direction.y < 0.0 ? -ray.Origin.y / ray.Direction.y : Infinity);
    double expected = 0.0;
    for (int i = 0; i + 1 < Slats; ++i)
    {
      const double t0 = CrossPlane(ray, Lamp, GetGap(i).From);
      const double t1 = CrossPlane(ray, Lamp, GetGap(i).To);
      for (const Interval& cone : ReachOfSpot(ray, end))
      {
        expected += std::max(
          0.0, std::min(std::max(t0, t1), cone.To) - std::max(std::min(t0, t1), cone.From));
      }
    }
    Check(expected > 0.1, "the ray crosses a shaft");
    CheckClose(
      GetValue(scene.GetBuffer("LitLength"), pixel.x, pixel.y), expected, 1e-4, "length in shafts");
    CheckClose(GetValue(scene.GetBuffer("Depth"), pixel.x, pixel.y), end, 1e-5, "depth");
  }
}

// The floor on a stripe and beside it: diffuse reflection of I cos(theta)/r^2, and ambient light.
void CheckStripes(Scene& scene)
{
  const auto at = [](double from, double to) {
    return glm::dvec3(Lamp.x + 0.5 * (from + to) * Lamp.y, 0.0, 0.0);
  };
  const auto direct = [](const glm::dvec3& point, int k) {
    const double r = glm::length(Lamp - point);
    return Intensity[k] / (Pi * r * r) * (Lamp.y / r) * std::exp(-(SigmaS[k] + SigmaA[k]) * r);
  };
  const auto passes = [](const Ray&, double t, int k) {
    return std::exp(-(SigmaS[k] + SigmaA[k]) * t);
  };
  // Gap 3, and the slat to its left.
  CheckFloor(scene, { FloorAlbedo, AmbientLight, direct, passes }, at(GetGap(3).From, GetGap(3).To),
    at(GetGap(2).To, GetGap(3).From), "floor on a stripe", "floor on a stripe and beside it");
}
}

//------------------------------------------------------------------------------
int TestSpotThroughSlats(int argc, char* argv[])
{
  Scene scene(640, 480);
  scene.SmoothEdges();
  Build(scene);
  scene.Window->Render();
  // The closed form in single precision; where little of a ray is lit, that part's ends show.
  CompareRays(scene, GetPhysics(), 1e-4, 1e-3);
  CheckShafts(scene);
  CheckStripes(scene);
  return scene.Finish(argc, argv);
}
