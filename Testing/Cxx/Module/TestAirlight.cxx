// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlight: transmittance and ambient light against their formulae, point lights in a box and
// outside it against quadrature of the integrand in space.

#include "AirlightTestSpace.h"

#include "vtkAirlight.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"

#include <glm/glm.hpp>

#include <cstdlib>
#include <limits>

using namespace airlight_test;

namespace
{
constexpr double inf = std::numeric_limits<double>::infinity();

//------------------------------------------------------------------------------
bool TestTransmittance()
{
  Comparison unbounded("transmittance, unbounded, relative");
  Comparison box("transmittance, box, relative");
  Random random(11);
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(0.1, 0.5, 0.0);
  medium->SetAbsorption(0.2, 0.0, 0.0);
  const auto compare = [&](
                         const glm::dvec3& a, const glm::dvec3& b, double inside, Comparison& to) {
    const double expected[3] = { std::exp(-0.3 * inside), std::exp(-0.5 * inside), 1.0 };
    double rgb[3] = { 7.0, 7.0, 7.0 };
    vtkAirlight::Transmittance(medium, &a.x, &b.x, rgb);
    for (int i = 0; i < 3; ++i)
    {
      to.Add(std::abs(rgb[i] / expected[i] - 1.0), 1e-13,
        [&] { return Text("a ", Text3(&a.x), ", b ", Text3(&b.x), ", channel ", i); });
    }
  };
  compare({ 1, 2, 3 }, { 1, 2, 3 }, 0.0, unbounded);
  compare({ 1, 2, 3 }, { 3, 5, 9 }, 7.0, unbounded);
  medium->SetBounds(-1, 1, -1, 1, -1, 1);
  medium->SetRegionToBox();
  compare({ 0, 0, 0 }, { 0.5, 0, 0 }, 0.5, box);                   // all inside
  compare({ 0, 0, 0 }, { 5, 0, 0 }, 1.0, box);                     // leaves
  compare({ 0, -4, 0 }, { 0, 0.25, 0 }, 1.25, box);                // enters
  compare({ -3, -3, -3 }, { 4, 4, 4 }, 2.0 * std::sqrt(3.0), box); // through the corners
  compare({ -3, 0.5, 0 }, { -1.5, 0.5, 0 }, 0.0, box);             // ends before it
  compare({ 2, 0, 0 }, { 5, 0, 0 }, 0.0, box);                     // starts behind it
  compare({ -3, 1.5, 0 }, { 3, 1.5, 0 }, 0.0, box);                // misses, parallel to a face
  compare({ -3, 0, 0 }, { 0, 3, 0 }, 0.0, box);                    // misses, oblique
  for (int i = 0; i < 2000; ++i)
  {
    const glm::dvec3 a = RandomPoint(random, 3.0);
    const glm::dvec3 b = RandomPoint(random, 3.0);
    compare(a, b, InsideLength(medium, a, b), box);
  }
  return AllOk({ &unbounded, &box });
}

//------------------------------------------------------------------------------
// albedo L (1 - transmittance), in a channel with absorption, one without, one that is clear, and
// its limit sigmaS L length for small extinction.
bool TestAmbient()
{
  Comparison comparison("ambient, relative");
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(0.1, 0.5, 1e-12);
  medium->SetAbsorption(0.3, 0.0, 0.0);
  medium->SetAmbientRadiance(2.0, 3.0, 4.0);
  const auto compare = [&](double x, double t1, double inside) {
    const double origin[3] = { x, 0.0, 0.0 };
    const double direction[3] = { 10.0, 0.0, 0.0 };
    const double expected[3] = { 0.25 * 2.0 * -std::expm1(-0.4 * inside),
      3.0 * -std::expm1(-0.5 * inside), 4.0 * -std::expm1(-1e-12 * inside) };
    double rgb[3] = { 7.0, 7.0, 7.0 };
    vtkAirlight::Ambient(medium, origin, direction, t1, rgb);
    for (int i = 0; i < 3; ++i)
    {
      comparison.Add(std::abs(rgb[i] - expected[i]), 1e-13 * expected[i] + 1e-300,
        [&] { return Text("x ", x, ", t1 ", t1, ", channel ", i, ", got ", rgb[i]); });
    }
  };
  for (double t1 : { -1.0, 0.0, 1e-9, 0.04, 0.2, 1.0, 30.0, inf })
  {
    medium->SetRegionToUnbounded();
    compare(0.3, t1, std::max(t1, 0.0));
    medium->SetRegionToBox(); // -1 to 1
    compare(-3.0, t1, std::clamp(t1 - 2.0, 0.0, 2.0));
    compare(0.0, t1, std::clamp(t1, 0.0, 1.0));
    compare(3.0, t1, 0.0);
  }
  return AllOk({ &comparison });
}

//------------------------------------------------------------------------------
// A box, the light in it (closed form) and outside it (quadrature), the camera anywhere.
bool TestBox()
{
  Comparison inside("light in the box, relative");
  Comparison outside("light outside the box, relative");
  Comparison missed("rays that miss the box, absolute");
  Random random(12);
  const double intensity[3] = { 1.0, 5.0, 20.0 };
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetBounds(-1, 2, -1.5, 1, -2, 2.5);
  medium->SetRegionToBox();
  const auto isIn = [](const glm::dvec3& p) {
    return p.x > -1 && p.x < 2 && p.y > -1.5 && p.y < 1 && p.z > -2 && p.z < 2.5;
  };
  for (int i = 0; i < 1200; ++i)
  {
    SetRandomMedium(medium, random, i);
    PointCase c;
    do
    {
      c.Light = RandomPoint(random, 3.0);
    } while (isIn(c.Light) != (i % 2 == 0));
    c.Attenuation = { 0.0, 0.0, 1.0 };
    c.Origin = RandomPoint(random, i % 3 == 0 ? 1.0 : 8.0);
    c.Direction = glm::normalize(RandomPoint(random, 1.5) - c.Origin);
    c.T0 = i % 4 == 0 ? random.Uniform(0.0, 6.0) : 0.0;
    c.T1 = i % 3 == 0 ? inf : c.T0 + random.Uniform(0.0, 10.0);
    double rgb[3];
    vtkAirlight::Inscatter(
      medium, &c.Light.x, intensity, &c.Origin.x, &c.Direction.x, c.T0, c.T1, rgb);
    const glm::dvec2 range = InsideRange(medium, c);
    if (range.y - range.x > 1e-3)
    {
      const bool in = isIn(c.Light);
      ComparePoint(medium, c, rgb, intensity, in ? 1e-9 : 1e-6, in ? inside : outside);
    }
    else if (range.y == range.x)
    {
      missed.Add(rgb[0] + rgb[1] + rgb[2], 1e-300, [&] { return c.Describe(); });
    }
  }
  return AllOk({ &inside, &outside, &missed });
}

//------------------------------------------------------------------------------
// The box seen from far away through vacuum, where coordinates have fewer digits after the point:
// the airlight is what it is from close by.
bool TestFarBox()
{
  Comparison comparison("box seen from far away, light outside, relative");
  Random random(15);
  const double intensity[3] = { 1.0, 1.0, 1.0 };
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetRegionToBox(); // -1 to 1
  for (int i = 0; i < 300; ++i)
  {
    SetRandomMedium(medium, random, i);
    PointCase c;
    c.Attenuation = { 0.0, 0.0, 1.0 };
    c.Light = RandomPoint(random, 1.5);
    c.Light.y = random.Uniform(1.01, 2.0);
    const glm::dvec3 target = RandomPoint(random, 0.8);
    c.Direction = glm::normalize(RandomPoint(random, 1.0));
    c.Origin = target - 5.0 * c.Direction;
    c.T0 = 0.0;
    c.T1 = inf;
    const double distance = random.LogUniform(1e2, 1e6);
    const glm::dvec3 far = target - distance * c.Direction;
    double rgb[3];
    vtkAirlight::Inscatter(medium, &c.Light.x, intensity, &far.x, &c.Direction.x, c.T0, c.T1, rgb);
    ComparePoint(medium, c, rgb, intensity, 1e-6, comparison);
  }
  return AllOk({ &comparison });
}

//------------------------------------------------------------------------------
// Fog on the ground and a lamp just above it: the light that reaches a flat ray comes from a thin
// film at the ray's entry, which a quadrature of few samples misses.
bool TestFogLayer()
{
  Comparison comparison("fog layer, light above it, relative");
  Random random(17);
  const double intensity[3] = { 1.0, 1.0, 1.0 };
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetBounds(-50, 50, 0, 2, -50, 50);
  medium->SetRegionToBox();
  for (int i = 0; i < 300; ++i)
  {
    const double sigma = random.LogUniform(1e-2, 100.0);
    medium->SetScattering(sigma, 0.5 * sigma, 2.0 * sigma);
    PointCase c;
    c.Attenuation = { 0.0, 0.0, 1.0 };
    c.Light = { 0.0, 2.0 + random.LogUniform(1e-3, 3.0), random.Uniform(-20.0, 0.0) };
    c.Origin = { 0.0, 2.0 + random.LogUniform(1e-2, 3.0), 0.0 };
    c.Direction =
      glm::normalize(glm::dvec3(random.Uniform(-0.5, 0.5), -random.LogUniform(1e-2, 1.0), -1.0));
    c.T0 = 0.0;
    c.T1 = inf;
    double rgb[3];
    vtkAirlight::Inscatter(
      medium, &c.Light.x, intensity, &c.Origin.x, &c.Direction.x, c.T0, c.T1, rgb);
    const glm::dvec2 range = InsideRange(medium, c);
    if (range.y - range.x > 1e-3)
    {
      ComparePoint(medium, c, rgb, intensity, 1e-6, comparison);
    }
  }
  return AllOk({ &comparison });
}

//------------------------------------------------------------------------------
// A box so dense that hardly a number is left of a light outside it, or none: the answer is finite
// and comes at once. No way from the light to the ray's entry is longer inside than `inside`, and
// p/r^2 is at most 1/4pi/0.01^2 per unit sigmaS: that bounds the answer from above.
bool TestOpaqueBox()
{
  Comparison comparison("airlight of an opaque box, finite and small");
  Random random(16);
  const double intensity[3] = { 1.0, 1.0, 1.0 };
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetRegionToBox(); // -1 to 1
  for (int i = 0; i < 300; ++i)
  {
    const double sigma = random.LogUniform(100.0, 1e4);
    medium->SetScattering(sigma, sigma, sigma);
    // Into the face at z = 1, close to it; the light is behind the opposite face.
    const glm::dvec3 origin = { random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0), 2.0 };
    const glm::dvec3 direction = { 0.0, 0.0, -1.0 };
    const glm::dvec3 light = { 0.5 * origin.x, 0.5 * origin.y, random.Uniform(-3.0, -1.01) };
    const double t1 = i % 2 == 0 ? inf : random.Uniform(1.01, 1.5);
    double rgb[3];
    vtkAirlight::Inscatter(medium, &light.x, intensity, &origin.x, &direction.x, 0.0, t1, rgb);
    // View leg and light leg together are at least the thickness of the box, 2.
    const double bound = 2.0 * sigma * std::exp(-2.0 * sigma) / (4.0 * Pi * 1e-4);
    comparison.Add(rgb[0] >= 0.0 ? rgb[0] : inf, bound + 1e-300,
      [&] { return Text("sigma ", sigma, ", light ", Text3(&light.x), ", t1 ", t1); });
  }
  return AllOk({ &comparison });
}
}

//------------------------------------------------------------------------------
int TestAirlight(int, char*[])
{
  bool ok = TestTransmittance();
  ok = TestAmbient() && ok;
  ok = TestBox() && ok;
  ok = TestFarBox() && ok;
  ok = TestFogLayer() && ok;
  ok = TestOpaqueBox() && ok;
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
