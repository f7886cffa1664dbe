// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * The expected numbers of a ray of a scene. Its lit parts are cut out by the planes through the
 * light and the bodies' edges (AirlightTestBruteForce.h); its airlight is the quadrature over them
 * of what each test says is scattered, so that no expected number comes from the library.
 */

#ifndef AirlightTestSceneRays_h
#define AirlightTestSceneRays_h

#include "AirlightTestCompareScene.h"
#include "AirlightTestQuadrature.h"
#include "AirlightTestTools.h"

namespace airlight_test
{
// What a test knows of its own light and medium.
struct Physics
{
  // The parts of the ray, as far as `end`, that the light would reach if nothing stood in its way.
  std::function<std::vector<Interval>(const Ray&, double end)> Reach;

  // Light scattered towards the eye at t, per unit length, attenuated up to the eye.
  std::function<double(const Ray&, double t, int channel)> Scattered;

  // What the ambient radiance adds as far as `end`.
  std::function<double(const Ray&, double end, int channel)> Ambient;
};

struct Expected
{
  double Depth = Infinity;
  double LitLength = 0.0;
  glm::dvec3 Airlight{ 0.0 };
};

// Where the ray crosses the plane through the light and along z on which
// (x - light.x)/(light.y - y) = slope.
double CrossPlane(const Ray& ray, const glm::dvec3& light, double slope);

double GetEnd(const Scene& scene, const Ray& ray);

std::vector<Interval> GetLitParts(
  const Scene& scene, const Physics& physics, const Ray& ray, double end);

double Sum(const std::vector<Interval>& parts);

Expected GetExpected(const Scene& scene, const Physics& physics, const Ray& ray);

// Whether 0.02 pixels to either side the ray's lit length or depth is another by more than 1 %:
// the ray grazes an edge, and no rasteriser need decide as double precision does.
bool IsUnstable(Scene& scene, const Physics& physics, int x, int y, const Expected& expected);

// All rays of a grid over the picture, but those that graze edges, against the expected numbers:
// lit length to 1e-3 of itself or of 0.1; airlight, of itself or of a hundredth of the picture's
// 99th percentile, to `limit` on 99 % of the rays and to `outer` on all; light that leaks into
// full shadow to 1e-4 of the 99th percentile.
void CompareRays(Scene& scene, const Physics& physics, double limit, double outer);

// To `limit` of what is expected.
void CheckClose(double value, double expected, double limit, const std::string& what);

void CheckClose(
  const glm::dvec3& value, const glm::dvec3& expected, double limit, const std::string& what);

// A diffuse floor y = 0.
struct Floor
{
  glm::dvec3 Albedo;
  double Ambient;
  // What reaches a point of it that is in the light, over pi.
  std::function<double(const glm::dvec3& point, int channel)> Direct;
  // The transmittance from there to the eye.
  std::function<double(const Ray&, double t, int channel)> Passes;
};

// What the floor sends from a point in the light, and how much more than from one in the shadow:
// both to 1e-4.
void CheckFloor(Scene& scene, const Floor& floor, const glm::dvec3& lit, const glm::dvec3& dark,
  const std::string& what, const std::string& whatOfBoth);
}

#endif
