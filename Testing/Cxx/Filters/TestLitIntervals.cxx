// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkLitIntervalsFilter: lit parts of random lines through random triangles against brute force
// (see AirlightTestBruteForce.h), for all kinds of lights and regions.

#include "AirlightTestCheck.h"
#include "AirlightTestLines.h"

#include <cstdlib>
#include <functional>

using namespace airlight_test;

namespace
{
// The part of [0, length] where inside(t) is true, of a convex set: by samples and bisection.
Interval FindConvex(double length, const std::function<bool(double)>& inside)
{
  const int n = 4000;
  const auto bisect = [&](double out, double in) {
    for (int i = 0; i < 60; ++i)
    {
      const double middle = 0.5 * (out + in);
      (inside(middle) ? in : out) = middle;
    }
    return in;
  };
  int first = 0;
  while (first <= n && !inside(length * first / n))
  {
    ++first;
  }
  int last = n;
  while (last >= first && !inside(length * last / n))
  {
    --last;
  }
  if (first > last)
  {
    return { 0.0, 0.0 };
  }
  return { first > 0 ? bisect(length * (first - 1) / n, length * first / n) : 0.0,
    last < n ? bisect(length * (last + 1) / n, length * last / n) : length };
}

// The part of the ray inside the region and the cone.
Interval FindReach(vtkParticipatingMedium* medium, vtkLight* light, const Ray& ray, double length)
{
  const glm::dvec3 lamp(GetPosition(light));
  glm::dvec3 focus;
  light->GetFocalPoint(&focus.x);
  const glm::dvec3 axis = glm::normalize(focus - lamp);
  const double* b = medium->GetBounds();
  const bool isSpot = light->GetPositional() && light->GetConeAngle() < 90.0;
  const double cosCone = std::cos(light->GetConeAngle() * std::acos(-1.0) / 180.0);
  return FindConvex(length, [&](double t) {
    const glm::dvec3 x = ray.Origin + t * ray.Direction;
    bool inside = true;
    if (medium->GetRegion() == vtkParticipatingMedium::BOX)
    {
      inside = x.x > b[0] && x.x < b[1] && x.y > b[2] && x.y < b[3] && x.z > b[4] && x.z < b[5];
    }
    else if (medium->GetRegion() == vtkParticipatingMedium::SPHERE)
    {
      const double* c = medium->GetCenter();
      inside = glm::distance(x, glm::dvec3(c[0], c[1], c[2])) < medium->GetRadius();
    }
    return inside && (!isSpot || glm::dot(glm::normalize(x - lamp), axis) > cosCone);
  });
}

std::vector<Interval> Expect(const std::vector<Triangle>& triangles, vtkParticipatingMedium* medium,
  vtkLight* light, const Ray& ray, double length)
{
  std::vector<Interval> shadows;
  for (const Triangle& t : triangles)
  {
    Interval shadow;
    if (FindShadow(t, GetPosition(light), ray, shadow))
    {
      shadows.push_back(shadow);
    }
  }
  const Interval reach = FindReach(medium, light, ray, length);
  std::vector<Interval> lit;
  for (const Interval& part : Complement(shadows, length))
  {
    const Interval both{ std::max(part.From, reach.From), std::min(part.To, reach.To) };
    if (both.From < both.To)
    {
      lit.push_back(both);
    }
  }
  return lit;
}

//------------------------------------------------------------------------------
// `first` is the output's first cell of the line; returned is the one after its last.
vtkIdType CompareLine(Run& run, vtkLight* light, const std::vector<Triangle>& triangles,
  const Polyline& line, vtkIdType number, vtkIdType first, const std::string& name,
  Comparison& ends, Comparison& airlight)
{
  const double length = glm::distance(line[0], line[1]);
  const Ray ray{ line[0], (line[1] - line[0]) / length };
  const std::vector<Interval> expected = Expect(triangles, run.Medium, light, ray, length);
  vtkIdType last = first;
  while (last < run.Count() && run.Get("SourceCell", last) == number)
  {
    ++last;
  }
  const auto where = [&] { return Text(name, ", line ", number); };
  if (!Check(last - first == static_cast<vtkIdType>(expected.size()),
        Text(where(), ": ", last - first, " lit parts, not ", expected.size())))
  {
    return last;
  }
  for (size_t i = 0; i < expected.size(); ++i)
  {
    const vtkIdType cell = first + static_cast<vtkIdType>(i);
    const Interval& part = expected[i];
    ends.Add(std::abs(run.Get("Start", cell) - part.From), 1e-9, where);
    ends.Add(std::abs(run.Get("End", cell) - part.To), 1e-9, where);
    ends.Add(std::abs(run.Get("Length", cell) - (part.To - part.From)), 2e-9, where);
    glm::dvec3 rgb;
    vtkAirlight::Inscatter(
      run.Medium, light, &ray.Origin.x, &ray.Direction.x, part.From, part.To, &rgb.x);
    for (int c = 0; c < 3; ++c)
    {
      airlight.Add(std::abs(run.Get("Airlight", cell, c) - rgb[c]), 1e-9 * (1.0 + rgb[c]), where);
    }
  }
  return last;
}

void TestSoup()
{
  Random random(11);
  std::vector<Triangle> triangles;
  const vtkSmartPointer<vtkPolyData> soup = MakeRandomSoup(random, 150, triangles);
  std::vector<Polyline> lines;
  for (int i = 0; i < 10000; ++i)
  {
    lines.push_back({ RandomPoint(random, 1.5), RandomPoint(random, 1.5) });
  }
  const auto lights = MakeLights();
  Comparison ends("ends of lit parts");
  Comparison airlight("airlight of lit parts");
  for (size_t k = 0; k < lights.size(); ++k)
  {
    const std::vector<Polyline> some(lines.begin(), lines.begin() + (k == 0 ? 10000 : 700));
    for (int region = 0; region < (k == 0 ? 1 : 3); ++region)
    {
      Run run(some);
      run.Medium->SetRegion(region);
      run.Medium->SetBounds(-1.1, 0.9, -1.2, 1.4, -0.8, 1.3);
      run.Medium->SetCenter(0.2, -0.1, 0.1);
      run.Medium->SetRadius(1.1);
      run.Filter->SetLight(lights[k].second);
      run.Filter->AddOccluderData(soup);
      run.Filter->Update();
      vtkIdType cell = 0;
      for (size_t i = 0; i < some.size(); ++i)
      {
        cell = CompareLine(run, lights[k].second, triangles, some[i], static_cast<vtkIdType>(i),
          cell, Text(lights[k].first, ", region ", region), ends, airlight);
      }
      Check(cell == run.Count() && cell > 0, lights[k].first + ": all cells belong to lines");
    }
  }
  Check(ends.Report(), "ends");
  Check(airlight.Report(), "airlight");
}
}

//------------------------------------------------------------------------------
int TestLitIntervals(int, char*[])
{
  TestSoup();
  std::cout << Failures << " failures\n";
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
