// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Light of all orders by vtkAirlightReference: a lamp in an unbounded medium against the exact
// solution by moments, over a floor and in a box against another program, and what is 0 or the same
// with light of order 1 alone.

#include "AirlightTestPaths.h"

#include "vtkPlaneSource.h"
#include "vtkSphereSource.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
const glm::dvec3 Extinction(1.0, 2.0, 4.0);

//------------------------------------------------------------------------------
// A lamp of 1 W/sr half a unit from the eye, seen from 5, 30 and 90 degrees beside it; the colours
// have albedos of 0.5, 0.9 and 0.95 and see it at optical distances of 0.5, 1 and 2.
//
// Expected: L_single + L_ms of "Multiple scattering, analytic", by its moments on a turned contour
// (l up to 4 and 33, continued fractions from 1200) and 320 nodes a ray; times sigma_t^2, as they
// are for sigma_t = 1. Good to 1e-5.
struct Exact
{
  double Anisotropy;
  double Angle;
  double Radiance[3];
};

constexpr Exact Rays[] = {
  { 0.0, 5.0, { 1.677946, 1.128441, 0.3037342 } },
  { 0.0, 30.0, { 0.2309697, 0.2302051, 0.09301605 } },
  { 0.0, 90.0, { 0.05879223, 0.08145883, 0.04057883 } },
  { 0.5, 5.0, { 2.273444, 1.481506, 0.3900948 } },
  { 0.5, 30.0, { 0.2012471, 0.1894936, 0.07894782 } },
  { 0.5, 90.0, { 0.02192355, 0.03405951, 0.02024952 } },
};

void CheckUnbounded()
{
  for (const Exact& ray : Rays)
  {
    PathScene scene;
    scene.Look(glm::dvec3(0.0), { 0.0, 0.0, -1.0 });
    const double angle = glm::radians(ray.Angle);
    scene.AddLamp({ 0.5 * std::sin(angle), 0.0, -0.5 * std::cos(angle) });
    PathScene::SetMedium(scene.Medium, { 0.5, 0.9, 0.95 }, Extinction);
    if (ray.Anisotropy != 0.0)
    {
      scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
      scene.Medium->SetAnisotropy(ray.Anisotropy);
    }
    scene.Compute(100, 1);
    for (int c = 0; c < 3; ++c)
    {
      CheckMean(Text("unbounded, g ", ray.Anisotropy, ", ", ray.Angle, " degrees"), scene, c,
        ray.Radiance[c] * Extinction[c] * Extinction[c], 0.1);
    }
  }
}

//------------------------------------------------------------------------------
// A lamp of 1 W in a medium of extinction 1, albedo 0.9, 1 above a floor, and in a box of side 3
// without walls. Expected, with standard errors: a Monte Carlo program that shares nothing with
// ours, 6e5 to 1e6 paths a ray.
struct Traced
{
  glm::dvec3 Direction;
  double Radiance;
  double Error;
};

void CheckTraced(
  const std::string& what, PathScene& scene, const glm::dvec3& eye, const std::vector<Traced>& rays)
{
  for (const Traced& ray : rays)
  {
    scene.Look(eye, ray.Direction);
    scene.Compute(200, 2);
    CheckMean(what, scene, 1, ray.Radiance, 0.04, ray.Error);
  }
}

void AddFloor(PathScene& scene, double albedo)
{
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-50.0, -50.0, 0.0);
  floor->SetPoint1(50.0, -50.0, 0.0);
  floor->SetPoint2(-50.0, 50.0, 0.0);
  scene.AddSurface(floor, glm::dvec3(albedo));
}

constexpr double OneWatt = 1.0 / (4.0 * 3.14159265358979324);
const glm::dvec3 Rays3[3] = { { -2.0, 1.0, 0.0 }, { -0.8, 0.0, -0.6 }, { -0.6, 0.0, 0.8 } };

void CheckFloorsAndBox()
{
  PathScene isotropic;
  isotropic.AddLamp({ 0.0, 0.0, 1.0 }, OneWatt);
  PathScene::SetMedium(isotropic.Medium, glm::dvec3(0.9), glm::dvec3(1.0));
  AddFloor(isotropic, 0.5);
  CheckTraced("floor of 0.5", isotropic, { 3.0, 0.0, 1.5 },
    { { Rays3[0], 0.00224575, 8.9e-6 }, { Rays3[1], 0.00244125, 9.8e-6 },
      { Rays3[2], 0.00119322, 5.8e-6 } });

  PathScene forward;
  forward.AddLamp({ 0.0, 0.0, 1.0 }, OneWatt);
  PathScene::SetMedium(forward.Medium, glm::dvec3(0.9), glm::dvec3(1.0));
  forward.Medium->SetPhaseFunctionToHenyeyGreenstein();
  forward.Medium->SetAnisotropy(0.5);
  AddFloor(forward, 0.8);
  CheckTraced("floor of 0.8, g 0.5", forward, { 3.0, 0.0, 1.5 },
    { { Rays3[0], 0.0029082, 2.2e-5 }, { Rays3[1], 0.00410173, 2.8e-5 } });

  PathScene box;
  box.AddLamp({ 0.0, 0.0, 0.5 }, OneWatt);
  PathScene::SetMedium(box.Medium, glm::dvec3(0.9), glm::dvec3(1.0));
  box.Medium->SetRegionToBox();
  box.Medium->SetBounds(-1.5, 1.5, -1.5, 1.5, -1.5, 1.5);
  CheckTraced("box", box, { 3.0, 0.0, 0.5 }, { { Rays3[0], 0.00283663, 1.1e-5 } });
}

//------------------------------------------------------------------------------
// In a medium that scatters nothing, over a black floor, there is nothing to add.
void CheckWithoutScattering()
{
  PathScene scene;
  scene.AddLamp({ 0.0, 0.0, 1.0 });
  PathScene::SetMedium(scene.Medium, glm::dvec3(0.0), { 0.2, 0.5, 1.0 });
  vtkNew<vtkSphereSource> ball; // convex: nothing else is seen from it
  ball->SetThetaResolution(16);
  scene.AddSurface(ball, { 0.9, 0.5, 0.1 });
  scene.Look({ 3.0, 0.0, 1.5 }, { -3.0, 0.0, -1.5 }, 20.0);
  for (const bool layer : { false, true })
  {
    if (layer)
    {
      vtkNew<vtkPlaneSource> glass;
      glass->SetCenter(1.5, 0.0, 0.8);
      glass->SetNormal(1.0, 0.0, 0.5);
      scene.AddSurface(glass, glm::dvec3(0.5))->GetProperty()->SetOpacity(0.3);
    }
    scene.Reference->SetScatteringOrders(1);
    scene.Compute(16);
    Check(!scene.Get("StandardError"), "order 1 has no standard error");
    const vtkSmartPointer<vtkDataArray> single = scene.Get("Radiance");
    scene.Reference->SetScatteringOrders(0);
    scene.Compute(16);
    vtkDataArray* all = scene.Get("Radiance");
    double most = 0.0;
    bool same = true;
    for (vtkIdType i = 0; i < all->GetNumberOfValues(); ++i)
    {
      most = std::max(most, single->GetVariantValue(i).ToDouble());
      same = same && all->GetVariantValue(i) == single->GetVariantValue(i) &&
        scene.Get("StandardError")->GetVariantValue(i).ToDouble() == 0.0;
    }
    Check(most > 0.0 && same, "nothing scatters: the same as with order 1");
  }
}

//------------------------------------------------------------------------------
// A medium that shines: each order is c times the one before. sigma_s L_a on infinite rays gives
// c L_a, c^2 L_a and so on.
void CheckOrders()
{
  PathScene scene(4);
  scene.Look(glm::dvec3(0.0), { 0.0, 0.0, -1.0 });
  const glm::dvec3 c(0.3, 0.6, 0.8);
  PathScene::SetMedium(scene.Medium, c, { 1.0, 3.0, 0.5 });
  scene.Medium->SetAmbientRadiance(1.0, 1.0, 1.0);
  for (const int orders : { 2, 3, 6, 0 })
  {
    scene.Reference->SetScatteringOrders(orders);
    scene.Compute(400);
    for (int i = 0; i < 3; ++i)
    {
      const double all = c[i] / (1.0 - c[i]);
      const double expected = orders == 0 ? all : all * (1.0 - std::pow(c[i], orders));
      CheckMean(Text(orders, " orders"), scene, i, expected, 0.05);
    }
  }
}

//------------------------------------------------------------------------------
// In an infinite medium in equilibrium radiance is emission over absorption, whatever is scattered.
void CheckEmission()
{
  PathScene scene(4);
  scene.Look(glm::dvec3(0.0), { 0.0, 0.0, -1.0 });
  PathScene::SetMedium(scene.Medium, { 0.2, 0.5, 0.8 }, Extinction);
  scene.Medium->SetEmission(1.0, 2.0, 3.0);
  scene.Compute(400, 2);
  for (int c = 0; c < 3; ++c)
  {
    CheckMean("emission", scene, c,
      scene.Medium->GetEmission()[c] / scene.Medium->GetAbsorption()[c], 0.05);
  }
}
}

int TestPathTracer(int, char*[])
{
  CheckEmission();
  CheckUnbounded();
  CheckFloorsAndBox();
  CheckWithoutScattering();
  CheckOrders();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
