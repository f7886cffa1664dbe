// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Where shadow planes lie in the picture, to 0.02 pixel: each ray has as many boundaries as it
// crosses planes, and is lit as far as brute force says. Of triangles above the picture, whose
// shadows fall through it; no surface is seen.

#include "AirlightTestScene.h"
#include "AirlightTestTools.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
constexpr double Reach = 0.02;     // how exact outlines are to be, in pixels
constexpr double NextReach = 0.05; // displaced by so much they are to be found

// Whether the ray meets the plane from the edge AB to infinity, away from the light: at
// light + a (A - light) + b (B - light) with a, b >= 0 and a + b >= 1. Of a light at infinity:
// A + b (B - A) - c light with 0 <= b <= 1 and c >= 0.
bool Meets(const Ray& ray, const glm::dvec3& a, const glm::dvec3& b, const glm::dvec4& light)
{
  const glm::dvec3 place(light);
  const bool isPoint = light.w != 0.0;
  const glm::dvec3 origin = isPoint ? place : a;
  const glm::dvec3 first = isPoint ? a - place : b - a;
  const glm::dvec3 second = isPoint ? b - place : -place;
  const glm::dvec3 found =
    glm::inverse(glm::dmat3(first, second, -ray.Direction)) * (ray.Origin - origin);
  const bool within = isPoint ? found.x + found.y >= 1.0 : found.x <= 1.0;
  return within && found.x >= 0.0 && found.y >= 0.0 && found.z >= 0.0;
}

int CountPlanes(Scene& scene, double px, double py)
{
  const Ray ray = scene.GetRay(px, py);
  const glm::dvec4 light = GetPosition(scene.Lights[0]);
  int count = 0;
  for (const Triangle& t : scene.Triangles)
  {
    count +=
      Meets(ray, t.A, t.B, light) + Meets(ray, t.B, t.C, light) + Meets(ray, t.C, t.A, light);
  }
  return count;
}

// Whether the count is the same up to so many pixels away.
bool IsEven(Scene& scene, double px, double py, int count, double reach)
{
  for (int i = 0; i < 8; ++i)
  {
    const double angle = 0.25 * 3.14159265358979323846 * i;
    if (CountPlanes(scene, px + reach * std::cos(angle), py + reach * std::sin(angle)) != count)
    {
      return false;
    }
  }
  return true;
}

//------------------------------------------------------------------------------
double GetLitLength(Scene& scene, double px, double py)
{
  const Ray ray = scene.GetRay(px, py);
  double length = 0.0;
  for (const LitPart& part :
    FindLitParts(scene.Triangles, GetPosition(scene.Lights[0]), ray, Infinity))
  {
    length += LengthInside(scene.Medium, ray, part.Where);
  }
  return length;
}

// The largest change of the lit length 0.02 pixel away.
double GetLengthChange(Scene& scene, double px, double py, double length)
{
  double most = 0.0;
  for (int i = 0; i < 8; ++i)
  {
    const double angle = 0.25 * 3.14159265358979323846 * i;
    const double other =
      GetLitLength(scene, px + Reach * std::cos(angle), py + Reach * std::sin(angle));
    most = std::max(most, std::abs(other - length));
  }
  return most;
}

//------------------------------------------------------------------------------
bool CompareOutlines(const std::string& name, Scene& scene)
{
  scene.Window->Render();
  Check(scene.Pass->GetEffectiveShadowTechnique() == vtkAirlightPass::SHADOW_PLANES,
    name + ": shadow planes");
  Comparison comparison(name + ": boundaries on a ray");
  Comparison lengths(name + ": lit length");
  int excluded = 0;
  int telling = 0;
  for (int i = 0; i < scene.Width * scene.Height; ++i)
  {
    const int x = i % scene.Width;
    const int y = i / scene.Width;
    const int count = CountPlanes(scene, x + 0.5, y + 0.5);
    if (!IsEven(scene, x + 0.5, y + 0.5, count, Reach))
    {
      ++excluded;
      continue;
    }
    telling += IsEven(scene, x + 0.5, y + 0.5, count, NextReach) ? 0 : 1;
    const double value = GetValue(scene.GetBuffer("BoundaryCount"), x, y);
    comparison.Add(std::abs(value - count), 0.5,
      [&] { return Text("pixel ", x, " ", y, ": ", value, ", expected ", count); });
    if (count > 0 && i % 5 == 0)
    {
      // Rounding to some units of the last place of distances up to 20 comes on top.
      const double length = GetLitLength(scene, x + 0.5, y + 0.5);
      const double limit = GetLengthChange(scene, x + 0.5, y + 0.5, length) + 1e-5;
      const double lit = GetValue(scene.GetBuffer("LitLength"), x, y);
      lengths.Add(std::abs(lit - length), limit,
        [&] { return Text("pixel ", x, " ", y, ": ", lit, ", expected ", length); });
    }
  }
  std::cout << name << ": " << excluded << " pixels excluded, " << telling
            << " are within 0.05 pixel of an outline\n";
  Check(excluded < 0.05 * scene.Width * scene.Height, name + ": too many pixels are excluded");
  Check(telling > 100, name + ": some pixels tell where outlines are");
  return AllOk({ &comparison, &lengths });
}

void AddTriangles(Scene& scene)
{
  std::vector<Triangle> triangles;
  Random random(29);
  const auto place = [&](double size) {
    const double x = random.Uniform(-size, size);
    const double y = random.Uniform(-size, size);
    return glm::dvec3(x, y, random.Uniform(-size, size));
  };
  for (int i = 0; i < 12; ++i)
  {
    const glm::dvec3 middle = glm::dvec3(0.0, 7.0, 0.0) + place(1.0);
    triangles.push_back({ middle + place(0.6), middle + place(0.6), middle + place(0.6) });
  }
  scene.Add(MakeSoup(triangles));
}
}

//------------------------------------------------------------------------------
int TestShadowOutlines(int, char*[])
{
  bool ok = true;
  for (const bool parallel : { false, true })
  {
    for (const bool sun : { false, true })
    {
      Scene scene;
      scene.Medium->SetRegionToBox();
      scene.Medium->SetBounds(-9, 9, -7, 12, -8, 8);
      sun ? scene.AddDirectionalLight({ 0.3, 1.0, 0.2 }) : scene.AddPointLight({ 0.4, 11, 0.3 });
      AddTriangles(scene);
      scene.Renderer->GetActiveCamera()->SetParallelProjection(parallel);
      scene.Renderer->GetActiveCamera()->SetParallelScale(4.0);
      ok =
        CompareOutlines(Text(sun ? "sun" : "point light", parallel ? ", parallel" : ""), scene) &&
        ok;
    }
  }
  return ok && Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
