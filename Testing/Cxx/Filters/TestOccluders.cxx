// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Queries of airlight::Occluders against loops over all triangles (see AirlightTestBruteForce.h),
// on random triangles and on closed meshes, through whose seams nothing may leak.

#include "AirlightTestCheck.h"
#include "AirlightTestSoup.h"
#include "Occlusion/AirlightOccluders.h"

#include "vtkCellArray.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkSphereSource.h"

#include <cstdlib>

using airlight::Occluders;
using airlight_test::Check;
using airlight_test::Failures;
using airlight_test::Infinity;
using airlight_test::Random;
using airlight_test::RandomPoint;
using airlight_test::Ray;
using airlight_test::Text;
using airlight_test::Triangle;

namespace
{
Ray RandomRay(Random& random)
{
  const glm::dvec3 origin = RandomPoint(random, 2.0);
  return { origin, glm::normalize(RandomPoint(random, 1.0) - origin) };
}

// At a place, at infinity, or on the ray.
glm::dvec4 RandomLight(Random& random, const Ray& ray)
{
  if (random.Index(4) == 0)
  {
    return glm::dvec4(ray.Origin + random.Uniform(-2.0, 4.0) * ray.Direction, 1.0);
  }
  return random.Index(2) ? glm::dvec4(RandomPoint(random, 3.0), 1.0)
                         : glm::dvec4(glm::normalize(RandomPoint(random, 1.0)), 0.0);
}

//------------------------------------------------------------------------------
void CheckFirstHit(
  const Occluders& occluders, const std::vector<Triangle>& triangles, Random& random)
{
  int hits = 0;
  for (int k = 0; k < 3000; ++k)
  {
    const Ray ray = RandomRay(random);
    double expected = Infinity;
    for (const Triangle& t : triangles)
    {
      expected = std::min(expected, airlight_test::Hit(t, ray));
    }
    Occluders::Hit hit{};
    const bool found = occluders.FirstHit(ray.Origin, ray.Direction, 0.0, Infinity, hit);
    hits += found ? 1 : 0;
    Check(found == (expected < Infinity), Text("ray ", k, " hits"));
    Check(!found || std::abs(hit.T - expected) < 1e-9, Text("ray ", k, ": distance ", hit.T));
    const glm::dvec3 end = ray.Origin + 2.5 * ray.Direction;
    const bool blocked = occluders.Blocked(ray.Origin, glm::dvec4(end, 1.0));
    Check(blocked == (expected < 2.5), Text("ray ", k, " is blocked before its end"));
    if (found)
    {
      Occluders::Hit next{};
      const bool behind = occluders.FirstHit(ray.Origin, ray.Direction, 0.0, Infinity, next,
        [&](int triangle) { return triangle == hit.Triangle; });
      Check(!behind || next.T >= hit.T, Text("ray ", k, " without its first triangle"));
      Check(!behind || next.Triangle != hit.Triangle, Text("ray ", k, " skips"));
    }
  }
  Check(hits > 500 && hits < 2900, Text("rays that hit and rays that do not: ", hits));
}

//------------------------------------------------------------------------------
void CheckShadows(
  const Occluders& occluders, const std::vector<Triangle>& triangles, Random& random)
{
  long count = 0;
  for (int k = 0; k < 3000; ++k)
  {
    const Ray ray = RandomRay(random);
    const glm::dvec4 light = RandomLight(random, ray);
    const double t0 = random.Index(2) ? random.Uniform(0.0, 1.0) : 0.0;
    const double t1 = random.Index(2) ? random.Uniform(1.0, 5.0) : Infinity;
    std::vector<Occluders::Shadow> shadows;
    occluders.FindShadows(light, ray.Origin, ray.Direction, t0, t1, shadows);
    std::vector<double> from(triangles.size(), Infinity);
    std::vector<double> to(triangles.size(), -Infinity);
    for (const Occluders::Shadow& shadow : shadows)
    {
      from[shadow.Triangle] = shadow.From;
      to[shadow.Triangle] = shadow.To;
    }
    for (size_t i = 0; i < triangles.size(); ++i)
    {
      airlight_test::Interval part{ 0.0, 0.0 };
      airlight_test::FindShadow(triangles[i], light, ray, part);
      part.From = std::max(part.From, t0);
      part.To = std::min(part.To, t1);
      const bool expected = part.To - part.From > 1e-9;
      const bool found = to[i] - from[i] > 1e-9;
      count += expected ? 1 : 0;
      Check(found == expected, Text("ray ", k, ": shadow of triangle ", i));
      const bool alike = std::abs(from[i] - part.From) < 1e-7 * (1.0 + part.From) &&
        (to[i] == part.To || std::abs(to[i] - part.To) < 1e-7 * (1.0 + part.To));
      Check(!expected || alike,
        Text("ray ", k, ": triangle ", i, " shades [", from[i], ", ", to[i], "], not [", part.From,
          ", ", part.To, "]"));
    }
  }
  Check(count > 10000, Text("shadows compared: ", count));
}

//------------------------------------------------------------------------------
// A ray that looks through the middle of a closed sphere from outside, lit from outside, has one
// shadow without a crack; and every ray from inside hits it, those through its seams, too.
void CheckSeams(Random& random)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetThetaResolution(64);
  sphere->SetPhiResolution(48);
  sphere->SetOutputPointsPrecision(vtkAlgorithm::DOUBLE_PRECISION);
  sphere->Update();
  vtkNew<vtkMatrix4x4> matrix; // far from the origin, where rounding is larger
  matrix->SetElement(0, 3, 1000.0);
  Occluders occluders;
  occluders.Add(sphere->GetOutput(), matrix, 5);
  occluders.Build();
  const glm::dvec3 centre(1000.0, 0.0, 0.0);
  for (int k = 0; k < 2000; ++k)
  {
    const glm::dvec3 side = glm::normalize(RandomPoint(random, 1.0));
    const glm::dvec3 origin = centre + 2.0 * side;
    const glm::dvec4 light = random.Index(2)
      ? glm::dvec4(centre + 3.0 * glm::normalize(RandomPoint(random, 1.0)), 1.0)
      : glm::dvec4(glm::normalize(RandomPoint(random, 1.0)), 0.0);
    std::vector<Occluders::Shadow> shadows;
    std::vector<Occluders::Interval> lit;
    occluders.FindShadows(light, origin, -side, 0.0, 4.0, shadows);
    Occluders::LitIntervals(shadows, 0.0, 4.0, lit, occluders.GetGap(light, origin));
    double dark = 4.0;
    for (const Occluders::Interval& part : lit)
    {
      dark -= part.To - part.From;
    }
    Check(lit.size() <= 2 && dark > 0.9, Text("sphere, ray ", k, ": ", lit.size(), " lit parts"));

    double p[3];
    sphere->GetOutput()->GetPoint(random.Index(sphere->GetOutput()->GetNumberOfPoints()), p);
    double q[3];
    sphere->GetOutput()->GetPoint(random.Index(sphere->GetOutput()->GetNumberOfPoints()), q);
    const glm::dvec3 through = 0.5 * (glm::dvec3(p[0], p[1], p[2]) + glm::dvec3(q[0], q[1], q[2]));
    Occluders::Hit hit{};
    const glm::dvec3 target = k % 2 ? glm::dvec3(p[0], p[1], p[2]) : through;
    if (glm::length(target) > 0.01)
    {
      const bool found = occluders.FirstHit(centre, glm::normalize(target), 0.0, Infinity, hit);
      Check(found && std::abs(hit.T - 0.5) < 0.01, Text("from inside, ray ", k, " hits"));
    }
  }
  Check(occluders.GetTriangles().front().Caster == 5, "the caster's number");
}

//------------------------------------------------------------------------------
// Cells of other kinds, and what is no triangle.
void CheckCells()
{
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double corners[7][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 0, 1, 0 }, { nan, 0, 0 },
    { 1e60, 0, 0 }, { 2, 0, 0 } };
  for (const double* p : corners)
  {
    points->InsertNextPoint(p);
  }
  vtkNew<vtkCellArray> polygons;
  const vtkIdType flat[3] = { 0, 1, 6 };
  const vtkIdType bad[3] = { 0, 1, 4 };
  const vtkIdType far[3] = { 0, 3, 5 };
  const vtkIdType quad[4] = { 0, 1, 2, 3 };
  polygons->InsertNextCell(3, flat);
  polygons->InsertNextCell(3, bad);
  polygons->InsertNextCell(3, far);
  polygons->InsertNextCell(4, quad);
  vtkNew<vtkCellArray> strips;
  const vtkIdType strip[4] = { 0, 1, 3, 2 };
  strips->InsertNextCell(4, strip);
  vtkNew<vtkCellArray> lines;
  lines->InsertNextCell(2, flat);
  vtkNew<vtkPolyData> data;
  data->SetPoints(points);
  data->SetLines(lines);
  data->SetPolys(polygons);
  data->SetStrips(strips);
  Occluders occluders;
  occluders.Add(data, nullptr, 1);
  occluders.Add(nullptr, nullptr, 2);
  occluders.Build();
  const auto& triangles = occluders.GetTriangles();
  Check(triangles.size() == 4, Text("triangles of a quad and a strip: ", triangles.size()));
  for (size_t i = 0; i < triangles.size(); ++i)
  {
    // Cells are counted lines first: 0 the line, 1 to 4 the polygons, 5 the strip.
    Check(triangles[i].Cell == (i < 2 ? 4 : 5), Text("cell ", triangles[i].Cell));
  }
  Occluders empty;
  empty.Build();
  Occluders::Hit hit{};
  std::vector<Occluders::Shadow> shadows;
  empty.FindShadows({ 0, 1, 0, 1 }, { 0, 0, 0 }, { 1, 0, 0 }, 0.0, Infinity, shadows);
  Check(shadows.empty() && !empty.FirstHit({ 0, 0, 0 }, { 1, 0, 0 }, 0.0, Infinity, hit),
    "nothing in an empty set");
}
}

//------------------------------------------------------------------------------
int TestOccluders(int, char*[])
{
  Random random(4);
  for (int count : { 1, 2, 3, 300 })
  {
    std::vector<Triangle> triangles;
    const vtkSmartPointer<vtkPolyData> soup =
      airlight_test::MakeRandomSoup(random, count, triangles);
    Occluders occluders;
    occluders.Add(soup, nullptr, 0);
    occluders.Build();
    if (count == 300)
    {
      CheckFirstHit(occluders, triangles, random);
      CheckShadows(occluders, triangles, random);
      continue;
    }
    Occluders::Hit hit{};
    const glm::dvec3 middle = (triangles[0].A + triangles[0].B + triangles[0].C) / 3.0;
    const glm::dvec3 origin = middle + glm::dvec3(0.0, 0.0, 10.0);
    Check(occluders.FirstHit(origin, { 0, 0, -1 }, 0.0, 10.1, hit), "few triangles are hit");
  }
  CheckSeams(random);
  CheckCells();
  std::cout << Failures << " failures\n";
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
