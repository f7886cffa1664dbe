// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// The sun slants through the windows of a dark, dusty room: the dust fills the room as a box, the
// camera stands in the room's own shadow.

#include "AirlightTestSceneRays.h"

using namespace airlight_test;

namespace
{
const glm::dvec3 ToSun = glm::normalize(glm::dvec3(-1.0, 0.72, -0.28));
const glm::dvec3 Irradiance(30.0, 26.0, 20.5);

const glm::dvec3 SigmaS(0.1, 0.098, 0.094);
const glm::dvec3 SigmaA(0.006, 0.007, 0.008);
constexpr double Anisotropy = 0.5;
const glm::dvec3 AmbientRadiance(0.08, 0.088, 0.11);

// The room inside its walls.
const glm::dvec3 Low(-4.0, 0.0, -7.0);
const glm::dvec3 High(4.0, 4.0, 7.0);
constexpr double Thickness = 0.25;

// Windows in the wall x = -4, with bars of a cross in the wall's middle.
constexpr double Sill = 1.0;
constexpr double Lintel = 3.3;
constexpr double WindowWidth = 1.4;
const double WindowStart[] = { -6.2, -3.6, -1.0, 1.6 };
constexpr double Bar = 0.04; // half
constexpr double BarHeight = 2.45;

constexpr double AmbientLight = 0.5;
const glm::dvec3 FloorAlbedo(0.26, 0.21, 0.165);

//------------------------------------------------------------------------------
void AddWindowWall(Scene& scene)
{
  const glm::dvec3 plaster(0.5, 0.48, 0.44);
  const double out = Low.x - Thickness;
  const auto add = [&](double y0, double y1, double z0, double z1) {
    scene.AddBox({ out, y0, z0 }, { Low.x, y1, z1 }, plaster);
  };
  add(-Thickness, Sill, Low.z - Thickness, High.z + Thickness);
  add(Lintel, High.y + Thickness, Low.z - Thickness, High.z + Thickness);
  double from = Low.z - Thickness;
  for (const double start : WindowStart)
  {
    add(Sill - 0.1, Lintel + 0.1, from, start);
    from = start + WindowWidth;
    const glm::dvec3 dark(0.2, 0.16, 0.13);
    const double middle = Low.x - 0.5 * Thickness;
    const double z = start + 0.5 * WindowWidth;
    scene.AddBox({ middle - Bar, Sill, z - Bar }, { middle + Bar, Lintel, z + Bar }, dark);
    scene.AddBox({ middle - Bar, BarHeight - Bar, start },
      { middle + Bar, BarHeight + Bar, start + WindowWidth }, dark);
  }
  add(Sill - 0.1, Lintel + 0.1, from, High.z + Thickness);
}

void AddRoom(Scene& scene)
{
  const glm::dvec3 t(Thickness);
  const glm::dvec3 plaster(0.5, 0.48, 0.44);
  const glm::dvec3 low = Low - t;
  const glm::dvec3 high = High + t;
  scene.AddBox(low, { high.x, Low.y, high.z }, FloorAlbedo);
  scene.AddBox({ low.x, High.y, low.z }, high, { 0.45, 0.45, 0.45 });
  scene.AddBox({ High.x, low.y, low.z }, high, plaster);
  scene.AddBox(low, { high.x, high.y, Low.z }, plaster);
  scene.AddBox({ low.x, low.y, High.z }, high, plaster);
  AddWindowWall(scene);
}

void AddTable(Scene& scene)
{
  const glm::dvec3 wood(0.42, 0.24, 0.13);
  scene.AddBox({ -3.4, 0.86, -3.6 }, { -2.0, 0.92, -1.4 }, wood);
  for (const double x : { -3.35, -2.13 })
  {
    for (const double z : { -3.5, -1.58 })
    {
      scene.AddBox({ x, 0.0, z }, { x + 0.08, 0.9, z + 0.08 }, wood);
    }
  }
  scene.AddBall({ -2.55, 1.22, -2.1 }, 0.3, { 0.35, 0.5, 0.55 });
}

//------------------------------------------------------------------------------
double ToWindows(const glm::dvec3& point) { return (Low.x - point.x) / ToSun.x; }

// The way inside the room, from a point in it.
double ToWalls(const Ray& ray) { return ClipToBox({ 0.0, Infinity }, ray, Low, High).To; }

// The dust ends at the walls. Sunlight comes in through the wall x = -4 alone.
Physics GetPhysics()
{
  Physics physics;
  physics.Reach = [](const Ray& ray, double end) {
    return std::vector<Interval>{ { 0.0, std::min(end, ToWalls(ray)) } };
  };
  physics.Scattered = [](const Ray& ray, double t, int k) {
    // Light travels along -ToSun, and the eye sees what goes along -Direction.
    const double cosine = glm::dot(ToSun, ray.Direction);
    const HenyeyGreensteinPhase phase{ Anisotropy };
    const double depth = t + ToWindows(ray.Origin + t * ray.Direction);
    return SigmaS[k] * Irradiance[k] * phase(1.0 - cosine, 1.0 + cosine) *
      std::exp(-(SigmaS[k] + SigmaA[k]) * depth);
  };
  physics.Ambient = [](const Ray& ray, double end, int k) {
    const double sigmaT = SigmaS[k] + SigmaA[k];
    const double inside = std::min(end, ToWalls(ray));
    return SigmaS[k] / sigmaT * AmbientRadiance[k] * (1.0 - std::exp(-sigmaT * inside));
  };
  return physics;
}

void Build(Scene& scene)
{
  scene.AmbientLight = AmbientLight;
  scene.Medium->SetScattering(&SigmaS.x);
  scene.Medium->SetAbsorption(&SigmaA.x);
  scene.Medium->SetAmbientRadiance(&AmbientRadiance.x);
  scene.Medium->SetPhaseFunctionToHenyeyGreenstein();
  scene.Medium->SetAnisotropy(Anisotropy);
  scene.Medium->SetRegionToBox();
  scene.Medium->SetBounds(Low.x, High.x, Low.y, High.y, Low.z, High.z);
  scene.AddDirectionalLight(ToSun, Irradiance);
  scene.Renderer->SetBackground(0.75, 0.85, 0.95); // the sky, seen through the windows alone
  AddRoom(scene);
  AddTable(scene);
  scene.Look({ 3.1, 1.8, 6.0 }, { -2.3, 1.5, -2.5 });
  scene.Renderer->GetActiveCamera()->SetViewAngle(52.0);
}

//------------------------------------------------------------------------------
// Keeps the part of the ray that sees the sun through a rectangle of the plane x = const.
void ClipToRectangle(
  Interval& part, const Ray& ray, double x, const glm::dvec2& y, const glm::dvec2& z)
{
  const glm::dvec3 overY(-ToSun.y / ToSun.x, 1.0, 0.0); // both are normal to the sun's direction
  const glm::dvec3 overZ(-ToSun.z / ToSun.x, 0.0, 1.0);
  Clip(part, ray, overY, { x, y[0], 0.0 });
  Clip(part, ray, -overY, { x, y[1], 0.0 });
  Clip(part, ray, overZ, { x, 0.0, z[0] });
  Clip(part, ray, -overZ, { x, 0.0, z[1] });
}

// The length of the ray that sees the sun through the panes, by their edges alone: a window's at
// both faces of the wall, the bars' at both of theirs.
double LengthInShafts(const Ray& ray, double end)
{
  const double middle = Low.x - 0.5 * Thickness;
  double sum = 0.0;
  for (const double start : WindowStart)
  {
    const glm::dvec2 wholeY(Sill, Lintel);
    const glm::dvec2 wholeZ(start, start + WindowWidth);
    const double bar = start + 0.5 * WindowWidth;
    for (int pane = 0; pane < 4; ++pane)
    {
      const glm::dvec2 y =
        pane % 2 ? glm::dvec2(Sill, BarHeight - Bar) : glm::dvec2(BarHeight + Bar, Lintel);
      const glm::dvec2 z =
        pane / 2 ? glm::dvec2(start, bar - Bar) : glm::dvec2(bar + Bar, start + WindowWidth);
      Interval part{ 0.0, end };
      ClipToRectangle(part, ray, Low.x, wholeY, wholeZ);
      ClipToRectangle(part, ray, Low.x - Thickness, wholeY, wholeZ);
      ClipToRectangle(part, ray, middle - Bar, y, z);
      ClipToRectangle(part, ray, middle + Bar, y, z);
      sum += std::max(part.To - part.From, 0.0);
    }
  }
  return sum;
}

// Rays that meet the floor or the wall this side of the table.
void CheckShafts(Scene& scene)
{
  for (const glm::dvec3& point :
    { glm::dvec3(-1.7, 0.0, 2.0), glm::dvec3(-1.8, 0.0, 0.9), glm::dvec3(Low.x, 1.3, 0.9) })
  {
    const glm::ivec2 pixel = scene.GetPixel(point);
    const Ray ray = scene.GetPixelRay(pixel);
    const double end = ToWalls(ray);
    const double expected = LengthInShafts(ray, end);
    Check(expected > 0.1, "the ray crosses a shaft");
    CheckClose(
      GetValue(scene.GetBuffer("LitLength"), pixel.x, pixel.y), expected, 1e-4, "length in shafts");
    CheckClose(GetValue(scene.GetBuffer("Depth"), pixel.x, pixel.y), end, 1e-5, "depth");
  }
}

// The floor in a patch of light and behind the wall beside it.
void CheckPatch(Scene& scene)
{
  const auto at = [](double along) {
    const glm::dvec3 onWall(Low.x, 1.7, WindowStart[2] + along);
    return onWall - onWall.y / ToSun.y * ToSun;
  };
  const auto direct = [](const glm::dvec3& point, int k) {
    return Irradiance[k] / Pi * ToSun.y * std::exp(-(SigmaS[k] + SigmaA[k]) * ToWindows(point));
  };
  const auto passes = [](const Ray&, double t, int k) {
    return std::exp(-(SigmaS[k] + SigmaA[k]) * t);
  };
  CheckFloor(scene, { FloorAlbedo, AmbientLight, direct, passes }, at(0.35), at(WindowWidth + 0.6),
    "floor in a patch", "floor in a patch and beside it");
}
}

//------------------------------------------------------------------------------
int TestSunThroughWindows(int argc, char* argv[])
{
  Scene scene(640, 480);
  scene.SmoothEdges();
  Build(scene);
  scene.Window->Render();
  const double limit = 1e-4 + scene.Medium->GetPhaseErrorBound();
  // Where little of a ray is lit, the single precision of that part's ends shows.
  CompareRays(scene, GetPhysics(), limit, 1e-3);
  CheckShafts(scene);
  CheckPatch(scene);
  return scene.Finish(argc, argv);
}
