// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "AirlightTestSceneRays.h"

namespace airlight_test
{
//------------------------------------------------------------------------------
double CrossPlane(const Ray& ray, const glm::dvec3& light, double slope)
{
  return (light.x - ray.Origin.x + slope * (light.y - ray.Origin.y)) /
    (ray.Direction.x + slope * ray.Direction.y);
}

//------------------------------------------------------------------------------
double GetEnd(const Scene& scene, const Ray& ray)
{
  double end = Infinity;
  for (const Triangle& t : scene.Triangles)
  {
    end = std::min(end, Hit(t, ray));
  }
  return end;
}

//------------------------------------------------------------------------------
std::vector<Interval> GetLitParts(
  const Scene& scene, const Physics& physics, const Ray& ray, double end)
{
  std::vector<Interval> shadows;
  for (const Triangle& t : scene.Triangles)
  {
    Interval shadow;
    if (FindShadow(t, GetPosition(scene.Lights[0]), ray, shadow))
    {
      shadows.push_back(shadow);
    }
  }
  std::vector<Interval> result;
  for (const Interval& part : Complement(shadows, end))
  {
    for (const Interval& reach : physics.Reach(ray, end))
    {
      const Interval both{ std::max(part.From, reach.From), std::min(part.To, reach.To) };
      if (both.From < both.To)
      {
        result.push_back(both);
      }
    }
  }
  return result;
}

//------------------------------------------------------------------------------
double Sum(const std::vector<Interval>& parts)
{
  double sum = 0.0;
  for (const Interval& part : parts)
  {
    sum += part.To - part.From;
  }
  return sum;
}

//------------------------------------------------------------------------------
Expected GetExpected(const Scene& scene, const Physics& physics, const Ray& ray)
{
  Expected expected;
  expected.Depth = GetEnd(scene, ray);
  const std::vector<Interval> parts = GetLitParts(scene, physics, ray, expected.Depth);
  expected.LitLength = Sum(parts);
  for (int k = 0; k < 3; ++k)
  {
    expected.Airlight[k] = physics.Ambient(ray, expected.Depth, k);
    for (const Interval& part : parts)
    {
      // Unbounded fog lets nothing through from beyond; the panels grow with distance.
      const double to = std::min(part.To, part.From + 2e3);
      std::vector<long double> ends = { part.From };
      for (double step = 0.1; part.From + step < to; step *= 2.0)
      {
        ends.push_back(part.From + step);
      }
      ends.push_back(to);
      expected.Airlight[k] +=
        Integrate([&](double t) { return physics.Scattered(ray, t, k); }, ends, 1e-10);
    }
  }
  return expected;
}

//------------------------------------------------------------------------------
bool IsUnstable(Scene& scene, const Physics& physics, int x, int y, const Expected& expected)
{
  for (int i = 0; i < 4; ++i)
  {
    const Ray ray = scene.GetRay(x + (i % 2 == 0 ? 0.48 : 0.52), y + (i < 2 ? 0.48 : 0.52));
    const double depth = GetEnd(scene, ray);
    const double litLength = Sum(GetLitParts(scene, physics, ray, depth));
    if (Differ(depth, expected.Depth, 0.0) || Differ(litLength, expected.LitLength, 0.1))
    {
      return true;
    }
  }
  return false;
}

//------------------------------------------------------------------------------
void CompareRays(Scene& scene, const Physics& physics, double limit, double outer)
{
  Comparison lengths("lit length, relative");
  Comparison airlight("airlight, relative");
  Comparison leak("light that leaks into full shadow, of the 99th percentile");
  const double percentile99 = scene.GetPercentile99("Airlight");
  constexpr int step = 16;
  int used = 0;
  int far = 0;
  int excluded = 0;
  for (int y = step / 2; y < scene.Height; y += step)
  {
    for (int x = step / 2; x < scene.Width; x += step)
    {
      const Ray ray = scene.GetPixelRay({ x, y });
      const Expected expected = GetExpected(scene, physics, ray);
      if (IsUnstable(scene, physics, x, y, expected))
      {
        ++excluded;
        continue;
      }
      const auto describe = [&] {
        return Text("pixel ", x, " ", y, ": expected lit length ", expected.LitLength,
          ", airlight ", Text3(&expected.Airlight.x));
      };
      if (expected.LitLength < Infinity)
      {
        const double error =
          std::abs(GetValue(scene.GetBuffer("LitLength"), x, y) - expected.LitLength);
        lengths.Add(error / std::max(expected.LitLength, 0.1), 1e-3, describe);
      }
      double largest = 0.0;
      for (int k = 0; k < 3; ++k)
      {
        const double error =
          std::abs(GetValue(scene.GetBuffer("Airlight"), x, y, k) - expected.Airlight[k]);
        const double relative = error / std::max(expected.Airlight[k], 0.01 * percentile99);
        airlight.Add(relative, outer, describe);
        largest = std::max(largest, relative);
        if (expected.LitLength == 0.0)
        {
          leak.Add(error / percentile99, 1e-4, describe);
        }
      }
      ++used;
      far += largest > limit;
    }
  }
  Check(lengths.Report(), "lit lengths");
  Check(airlight.Report(), "airlight");
  Check(leak.Report(), "full shadow is as dark as the ambient radiance");
  std::cout << far << " of " << used << " rays differ by more than " << limit << "; " << excluded
            << " more graze an edge\n";
  Check(100 * far <= used, "airlight of 99 % of the rays");
  Check(20 * excluded < used, "few rays graze an edge");
}

//------------------------------------------------------------------------------
void CheckClose(double value, double expected, double limit, const std::string& what)
{
  std::cout << what << ": " << value << ", expected " << expected << "\n";
  Check(std::abs(value - expected) <= limit * std::abs(expected), what);
}

//------------------------------------------------------------------------------
void CheckClose(
  const glm::dvec3& value, const glm::dvec3& expected, double limit, const std::string& what)
{
  for (int k = 0; k < 3; ++k)
  {
    CheckClose(value[k], expected[k], limit, what + ", channel " + std::to_string(k));
  }
}

//------------------------------------------------------------------------------
void CheckFloor(Scene& scene, const Floor& floor, const glm::dvec3& lit, const glm::dvec3& dark,
  const std::string& what, const std::string& whatOfBoth)
{
  glm::dvec3 seen[2];
  glm::dvec3 expected[2];
  for (const bool isLit : { false, true })
  {
    const glm::ivec2 pixel = scene.GetPixel(isLit ? lit : dark);
    const Ray ray = scene.GetPixelRay(pixel);
    const double t = -ray.Origin.y / ray.Direction.y;
    for (int k = 0; k < 3; ++k)
    {
      const double direct = floor.Direct(ray.Origin + t * ray.Direction, k);
      expected[isLit][k] =
        floor.Albedo[k] * (floor.Ambient + (isLit ? direct : 0.0)) * floor.Passes(ray, t, k);
    }
    seen[isLit] = GetColour(scene.GetBuffer("Surface"), pixel.x, pixel.y);
  }
  CheckClose(seen[1], expected[1], 1e-4, what);
  CheckClose(seen[1] / seen[0], expected[1] / expected[0], 1e-4, whatOfBoth);
}
}
