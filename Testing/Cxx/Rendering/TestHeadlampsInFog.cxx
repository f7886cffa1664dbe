// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The low beams of a car on a road at night, by a photometric file, in fog: seen from beside, sharp
// cut-offs above the beams, and shadows behind a pedestrian, a post and a box.

#include "AirlightTestGoniometry.h"
#include "AirlightTestSceneRays.h"

using namespace airlight_test;

namespace
{
const glm::dvec3 Intensity(15000.0, 14400.0, 13000.0); // of the brightest direction
const glm::dvec3 RoadAlbedo(0.09, 0.09, 0.095);
constexpr double LampHeight = 0.65;
constexpr double LampPlace = 0.62; // to the left and right of the car's middle

TestFog MakeFog()
{
  TestFog fog;
  fog.SigmaS = glm::dvec3(0.055, 0.055, 0.056);
  fog.SigmaT = fog.SigmaS + glm::dvec3(0.002);
  fog.G = 0.6;
  return fog;
}

//------------------------------------------------------------------------------
// The car drives towards -z.
std::vector<TestGoniometricLamp> AddLamps(Scene& scene, const std::string& file)
{
  std::vector<TestGoniometricLamp> lamps;
  for (const double x : { -LampPlace, LampPlace })
  {
    TestGoniometricLamp lamp;
    lamp.Table = ReadTable(file);
    lamp.Position = { x, LampHeight, 0.0 };
    lamp.Intensity = Intensity;
    lamp.Aim({ 0.0, 0.0, -1.0 }, { 0.0, 1.0, 0.0 });
    lamps.push_back(lamp);
    vtkLight* light = scene.AddPointLight(lamp.Position, Intensity);
    light->SetFocalPoint(x, LampHeight, -1.0);
    Check(scene.Pass->SetLightPhotometry(light, file.c_str()), "the file is read");
  }
  return lamps;
}

void Build(Scene& scene)
{
  const TestFog fog = MakeFog();
  const glm::dvec3 sigmaA = fog.SigmaT - fog.SigmaS;
  scene.Medium->SetScattering(&fog.SigmaS.x);
  scene.Medium->SetAbsorption(&sigmaA.x);
  scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
  scene.Medium->SetAnisotropy(fog.G);
  scene.Medium->SetPhaseTolerance(1e-5);
  scene.AddBox({ -60, -0.2, -150 }, { 60, 0, 30 }, RoadAlbedo);
  for (const double x : { -1.95, 1.75 }) // the lane's edges
  {
    scene.AddBox({ x, -0.1, -120 }, { x + 0.12, 0.004, 20 }, { 0.45, 0.45, 0.43 });
  }
  // A pedestrian from the left, a post on the right, a box on the lane.
  scene.AddBox({ -1.35, 0.0, -7.2 }, { -0.95, 1.45, -6.95 }, { 0.25, 0.2, 0.2 });
  scene.AddBall({ -1.15, 1.62, -7.1 }, 0.14, { 0.4, 0.3, 0.25 });
  scene.AddBox({ 1.3, 0.0, -5.6 }, { 1.44, 1.3, -5.46 }, { 0.5, 0.5, 0.5 });
  scene.AddBox({ 0.0, 0.0, -9.6 }, { 0.7, 0.4, -9.0 }, { 0.35, 0.25, 0.12 });
  // The car's front, behind the lamps.
  scene.AddBox({ -0.88, 0.22, 0.06 }, { 0.88, 0.95, 1.3 }, { 0.1, 0.1, 0.12 });
  scene.Look({ 6.0, 4.6, 3.2 }, { -0.3, 0.3, -7.5 });
  scene.Renderer->GetActiveCamera()->SetViewAngle(36.0);
  scene.Renderer->GetActiveCamera()->SetClippingRange(0.5, 300.0);
}

//------------------------------------------------------------------------------
// What a ray sees of one lamp.
std::vector<Interval> GetLit(const Scene& scene, const Ray& ray, size_t lamp, double end)
{
  std::vector<Interval> shadows;
  for (const Triangle& t : scene.Triangles)
  {
    Interval shadow;
    if (FindShadow(t, GetPosition(scene.Lights[lamp]), ray, shadow))
    {
      shadows.push_back(shadow);
    }
  }
  return Complement(shadows, end);
}

// Whether the ray grazes an edge: 0.02 pixels beside it more than 1 % is different.
bool Grazes(Scene& scene, int x, int y, double end, const std::vector<double>& lengths)
{
  for (int i = 0; i < 4; ++i)
  {
    const Ray ray = scene.GetRay(x + (i % 2 == 0 ? 0.48 : 0.52), y + (i < 2 ? 0.48 : 0.52));
    const double other = GetEnd(scene, ray);
    bool grazes = Differ(other, end, 0.0);
    for (size_t lamp = 0; lamp < lengths.size(); ++lamp)
    {
      grazes = grazes || Differ(Sum(GetLit(scene, ray, lamp, other)), lengths[lamp], 0.1);
    }
    if (grazes)
    {
      return true;
    }
  }
  return false;
}

glm::dvec3 GetNormal(const Scene& scene, const Ray& ray, double end)
{
  for (const Triangle& t : scene.Triangles)
  {
    if (Hit(t, ray) == end)
    {
      return glm::normalize(glm::cross(t.B - t.A, t.C - t.A));
    }
  }
  return glm::dvec3(0.0);
}

//------------------------------------------------------------------------------
struct Comparisons
{
  Comparison Lengths{ "lit length, relative" };
  Comparison Airlight{ "airlight of each lamp, relative" };
  Comparison Surface{ "surfaces, relative" };
  int Rays = 0;
  int Grazing = 0;
  int Shadowed = 0;
};

// Airlight and surfaces to 1e-3 of themselves or of a hundredth of the picture's 99th percentile.
void CheckRay(Scene& scene, const std::vector<TestGoniometricLamp>& lamps, int x, int y,
  const glm::dvec2& floors, Comparisons& found)
{
  const TestFog fog = MakeFog();
  const int k = (x + y) % 3;
  const Ray ray = scene.GetPixelRay({ x, y });
  const double end = GetEnd(scene, ray);
  const auto describe = [&] { return Text("pixel ", x, " ", y, ", channel ", k, ", end ", end); };
  std::vector<double> lengths;
  for (size_t i = 0; i < lamps.size(); ++i)
  {
    lengths.push_back(Sum(GetLit(scene, ray, i, end)));
  }
  ++found.Rays;
  if (Grazes(scene, x, y, end, lengths))
  {
    ++found.Grazing;
    return;
  }
  double shine = 0.0;
  for (size_t i = 0; i < lamps.size(); ++i)
  {
    const std::vector<Interval> parts = GetLit(scene, ray, i, end);
    double expected = 0.0;
    for (const Interval& part : parts)
    {
      expected +=
        GoniometricAirlight(fog, lamps[i], ray.Origin, ray.Direction, part.From, part.To, k);
    }
    const double value = GetValue(scene.GetBuffer(i == 0 ? "Airlight:0" : "Airlight:1"), x, y, k);
    found.Airlight.Add(std::abs(value - expected) / std::max(expected, floors.x), 1e-3, describe);
    if (end < Infinity && !parts.empty() && parts.back().To > end * (1.0 - 1e-9))
    {
      shine += GoniometricSurface(
        fog, lamps[i], ray.Origin, ray.Direction, end, GetNormal(scene, ray, end), k);
    }
    found.Shadowed += lengths[i] < 0.95 * end;
  }
  const glm::dvec3 point = ray.Origin + std::min(end, 1e9) * ray.Direction;
  if (end < Infinity)
  {
    const double sum = lengths[0] + lengths[1];
    const double length = GetValue(scene.GetBuffer("LitLength"), x, y);
    found.Lengths.Add(std::abs(length - sum) / std::max(sum, 0.1), 1e-3, describe);
  }
  // Surfaces one by one in the colours of Build(): here the road's. The ball is smoothly shaded.
  if (end < Infinity && std::abs(point.y) < 1e-6)
  {
    const double value = GetValue(scene.GetBuffer("Surface"), x, y, k);
    const double expected = RoadAlbedo[k] * shine;
    found.Surface.Add(std::abs(value - expected) / std::max(expected, floors.y), 1e-3, describe);
  }
}

void CheckRays(Scene& scene, const std::vector<TestGoniometricLamp>& lamps)
{
  Comparisons found;
  const glm::dvec2 floors(
    0.01 * scene.GetPercentile99("Airlight"), 0.01 * scene.GetPercentile99("Surface"));
  for (int pixel = 5; pixel < scene.Width * scene.Height; pixel += 97)
  {
    CheckRay(scene, lamps, pixel % scene.Width, pixel / scene.Width, floors, found);
  }
  std::cout << found.Rays << " rays, " << found.Grazing << " graze, " << found.Shadowed
            << " in shadow; 99th percentiles " << 100.0 * floors.x << " " << 100.0 * floors.y
            << "\n";
  Check(found.Lengths.Report(), "lit lengths");
  Check(found.Airlight.Report(), "airlight");
  Check(found.Surface.Report(), "surfaces");
  Check(20 * found.Grazing < found.Rays && found.Shadowed > 20,
    "few rays graze edges, many are in shadow");
}
}

//------------------------------------------------------------------------------
int TestHeadlampsInFog(int argc, char* argv[])
{
  Scene scene(320, 180);
  scene.SmoothEdges();
  const auto lamps = AddLamps(scene, GetPhotometricFile(argc, argv, "lowbeam.ies"));
  Build(scene);
  scene.Window->Render();
  CheckRays(scene, lamps);
  return scene.Finish(argc, argv);
}
