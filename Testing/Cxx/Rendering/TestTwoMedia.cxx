// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Two coloured media, a box and a sphere that overlap, under one lamp outside of both. The
// shadows of a frame run through both, and onto the floor: its boards point to the camera, so that
// their shadows are seen edge-on.

#include "AirlightTestSceneRays.h"

using namespace airlight_test;

namespace
{
const glm::dvec3 Lamp(-0.2, 5.4, 0.0);
const glm::dvec3 Intensity(330.0, 320.0, 310.0);

struct Part
{
  glm::dvec3 SigmaS;
  glm::dvec3 SigmaA;
};
const Part Amber{ { 0.2, 0.07, 0.02 }, { 0.01, 0.03, 0.05 } };
const Part Azure{ { 0.02, 0.08, 0.24 }, { 0.05, 0.03, 0.01 } };

const glm::dvec3 Low(-2.8, 0.55, -1.0);
const glm::dvec3 High(0.7, 2.55, 1.0);
const glm::dvec3 Centre(1.0, 1.65, 0.0);
constexpr double Radius = 1.55;

// The boards of the frame that casts the shadows.
const double Boards[] = { -0.85, 0.3 };
constexpr double BoardWidth = 0.22;
constexpr double BoardBottom = 3.5;
constexpr double BoardTop = 3.54;
constexpr double BoardEnd = 0.9;

const glm::dvec3 FloorAlbedo(0.13, 0.13, 0.13);

//------------------------------------------------------------------------------
// Where the ray is in the box and in the sphere; From >= To where it is not.
Interval InBox(const Ray& ray, const Interval& part) { return ClipToBox(part, ray, Low, High); }

Interval InSphere(const Ray& ray, const Interval& part)
{
  const double middle = glm::dot(Centre - ray.Origin, ray.Direction);
  const glm::dvec3 foot = ray.Origin + middle * ray.Direction - Centre;
  const double half2 = Radius * Radius - glm::dot(foot, foot);
  if (half2 <= 0.0)
  {
    return { part.To, part.To };
  }
  const double half = std::sqrt(half2);
  return { std::max(part.From, middle - half), std::min(part.To, middle + half) };
}

double Length(const Interval& part) { return std::max(part.To - part.From, 0.0); }

// Optical depth of a part of the ray: both media's depths add.
double Depth(const Ray& ray, const Interval& part, int k)
{
  return (Amber.SigmaS[k] + Amber.SigmaA[k]) * Length(InBox(ray, part)) +
    (Azure.SigmaS[k] + Azure.SigmaA[k]) * Length(InSphere(ray, part));
}

double DepthToLamp(const glm::dvec3& point, int k)
{
  const double r = glm::length(Lamp - point);
  return Depth({ point, (Lamp - point) / r }, { 0.0, r }, k);
}

//------------------------------------------------------------------------------
// The parts of the ray in either medium.
std::vector<Interval> ReachOfMedia(const Ray& ray, double end)
{
  Interval a = InBox(ray, { 0.0, end });
  Interval b = InSphere(ray, { 0.0, end });
  std::vector<Interval> result;
  if (Length(a) > 0.0 && Length(b) > 0.0 && a.From <= b.To && b.From <= a.To)
  {
    return { { std::min(a.From, b.From), std::max(a.To, b.To) } };
  }
  for (const Interval& part : { a, b })
  {
    if (Length(part) > 0.0)
    {
      result.push_back(part);
    }
  }
  return result;
}

Physics GetPhysics()
{
  Physics physics;
  physics.Reach = ReachOfMedia;
  physics.Scattered = [](const Ray& ray, double t, int k) {
    const glm::dvec3 point = ray.Origin + t * ray.Direction;
    const glm::dvec3 low = point - Low;
    const glm::dvec3 high = High - point;
    const bool inBox = std::min({ low.x, low.y, low.z, high.x, high.y, high.z }) > 0.0;
    const bool inSphere = glm::length(point - Centre) < Radius;
    const double r = glm::length(Lamp - point);
    return ((inBox ? Amber.SigmaS[k] : 0.0) + (inSphere ? Azure.SigmaS[k] : 0.0)) * Intensity[k] /
      (4.0 * Pi * r * r) * std::exp(-Depth(ray, { 0.0, t }, k) - DepthToLamp(point, k));
  };
  physics.Ambient = [](const Ray&, double, int) { return 0.0; };
  return physics;
}

//------------------------------------------------------------------------------
// Lies flat below the lamp: two boards that point to the camera and two thin bars.
void AddFrame(Scene& scene)
{
  const glm::dvec3 metal(0.05);
  for (const double x : Boards)
  {
    scene.AddBox({ x, BoardBottom, -BoardEnd }, { x + BoardWidth, BoardTop, BoardEnd }, metal);
  }
  for (const double z : { -BoardEnd, BoardEnd - 0.04 })
  {
    scene.AddBox({ Boards[0], BoardBottom, z }, { Boards[1], BoardTop, z + 0.04 }, metal);
  }
}

void Build(Scene& scene)
{
  scene.AmbientLight = 0.3;
  scene.Medium->SetScattering(&Amber.SigmaS.x);
  scene.Medium->SetAbsorption(&Amber.SigmaA.x);
  scene.Medium->SetRegionToBox();
  scene.Medium->SetBounds(Low.x, High.x, Low.y, High.y, Low.z, High.z);
  vtkNew<vtkParticipatingMedium> azure;
  azure->SetScattering(&Azure.SigmaS.x);
  azure->SetAbsorption(&Azure.SigmaA.x);
  azure->SetRegionToSphere();
  azure->SetCenter(&Centre.x);
  azure->SetRadius(Radius);
  scene.Pass->AddMedium(azure);
  scene.AddPointLight(Lamp, Intensity);
  scene.AddBox({ -9, -0.2, -5 }, { 9, 0, 8 }, FloorAlbedo);
  scene.AddBox({ -9, -0.2, -5.2 }, { 9, 9, -5 }, { 0.05, 0.05, 0.055 });
  AddFrame(scene);
  scene.Look({ 0.4, 2.9, 9.5 }, { -0.3, 1.75, 0.0 });
  scene.Renderer->GetActiveCamera()->SetViewAngle(32.0);
}

//------------------------------------------------------------------------------
// Through the overlap both media's transmittances multiply.
void CheckTransmittance(Scene& scene)
{
  for (const glm::dvec3& point : { glm::dvec3(0.2, 1.9, 0.0), glm::dvec3(0.4, 1.3, 0.0) })
  {
    const glm::ivec2 pixel = scene.GetPixel(point);
    const Ray ray = scene.GetPixelRay(pixel);
    const double inBox = Length(InBox(ray, { 0.0, Infinity }));
    const double inSphere = Length(InSphere(ray, { 0.0, Infinity }));
    Check(inBox > 1.0 && inSphere > 1.0, "the ray crosses both media");
    glm::dvec3 expected;
    for (int k = 0; k < 3; ++k)
    {
      expected[k] = std::exp(-(Amber.SigmaS[k] + Amber.SigmaA[k]) * inBox) *
        std::exp(-(Azure.SigmaS[k] + Azure.SigmaA[k]) * inSphere);
    }
    CheckClose(GetColour(scene.GetBuffer("Transmittance"), pixel.x, pixel.y), expected, 1e-5,
      "transmittance of both media");
  }
}

// The slope (x - Lamp.x)/(Lamp.y - y) of the plane through the lamp and a board's edge that bounds
// its shadow: the upper and the lower edge compared.
double GetSlope(double x, bool largest)
{
  const double a = (x - Lamp.x) / (Lamp.y - BoardBottom);
  const double b = (x - Lamp.x) / (Lamp.y - BoardTop);
  return largest ? std::max(a, b) : std::min(a, b);
}

// A ray in the box of which a board's shadow takes a part. The boards are so long that their ends'
// shadows lie outside of the box.
void CheckBoardShadow(Scene& scene)
{
  const glm::ivec2 pixel = scene.GetPixel({ -1.15, 1.5, 0.0 });
  const Ray ray = scene.GetPixelRay(pixel);
  const Interval inBox = InBox(ray, { 0.0, Infinity });
  const double t0 = CrossPlane(ray, Lamp, GetSlope(Boards[0], false));
  const double t1 = CrossPlane(ray, Lamp, GetSlope(Boards[0] + BoardWidth, true));
  const double shadow =
    std::min(std::max(t0, t1), inBox.To) - std::max(std::min(t0, t1), inBox.From);
  Check(shadow > 0.1 && Length(inBox) - shadow > 0.1, "a part of the ray is in shadow");
  CheckClose(GetValue(scene.GetBuffer("LitLength"), pixel.x, pixel.y), Length(inBox) - shadow, 1e-4,
    "lit length in the box");
}

// A ray whose whole way through the sphere is in a board's shadow.
void CheckFullShadow(Scene& scene)
{
  const double s = 0.5 * (GetSlope(Boards[1], false) + GetSlope(Boards[1] + BoardWidth, true));
  const glm::ivec2 pixel = scene.GetPixel({ Lamp.x + s * (Lamp.y - Centre.y), Centre.y, 0.0 });
  const Interval inSphere = InSphere(scene.GetPixelRay(pixel), { 0.0, Infinity });
  Check(Length(inSphere) > 1.0, "the ray crosses the sphere");
  Check(GetValue(scene.GetBuffer("LitLength"), pixel.x, pixel.y) == 0.0, "nothing of it is lit");
  const glm::dvec3 airlight = GetColour(scene.GetBuffer("Airlight"), pixel.x, pixel.y);
  std::cout << "airlight in full shadow " << airlight.x << " " << airlight.y << " " << airlight.z
            << "\n";
  Check(
    std::max({ airlight.x, airlight.y, airlight.z }) <= 1e-4 * scene.GetPercentile99("Airlight"),
    "no light leaks into full shadow");
}
}

//------------------------------------------------------------------------------
int TestTwoMedia(int argc, char* argv[])
{
  Scene scene(640, 480);
  scene.SmoothEdges();
  Build(scene);
  scene.Window->Render();
  // The pass states 1e-3 for lights outside of bounded media, and some 1e-3 where the way to the
  // light grazes a face.
  CompareRays(scene, GetPhysics(), 1e-3, 1e-3);
  CheckTransmittance(scene);
  CheckBoardShadow(scene);
  CheckFullShadow(scene);
  return scene.Finish(argc, argv);
}
