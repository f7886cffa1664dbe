// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Lengths of rays inside closed surfaces where they are hard to tell: through vertices, through
// edges, along faces and beside them, in double and in the shaders' single precision; and inside of
// round surfaces, whose meshes lie between two round bodies.
//
// What is compared is a bound from below and from above: a ray that grazes may be in or out.

#include "AirlightTestQuadrature.h"
#include "AirlightTestSurfaces.h"
#include "AirlightTestTools.h"
#include "Integration/AirlightMath.h"
#include "Region/AirlightSurfaceTree.h"

#include "vtkAirlight.h"
#include "vtkNew.h"
#include "vtkParticipatingMedium.h"
#include "vtkSphereSource.h"

#include <array>
#include <cstdlib>
#include <functional>
#include <memory>
#include <vector>

using namespace airlight;
using namespace airlight_test;

namespace
{
// A uniform medium of sigmaT 1 inside a mesh, as the shaders see it.
class Body
{
public:
  explicit Body(vtkPolyData* mesh)
  {
    this->Medium->SetScattering(1.0, 1.0, 1.0);
    this->Medium->SetAbsorption(0.0, 0.0, 0.0);
    this->Medium->SetSurface(mesh);
    this->Medium->SetRegionToSurface();
    this->Tree = this->Medium->GetSurfaceTree();
    for (const glm::dvec4& texel : this->Tree->GetTexels())
    {
      this->Texels.emplace_back(texel);
    }
  }

  // By vtkAirlight::Transmittance() on the ray's part up to l: no longer than 40, else there is
  // nothing left to take the logarithm of.
  double GetLength(const glm::dvec3& o, const glm::dvec3& d, double l)
  {
    const glm::dvec3 end = o + l * d;
    double rgb[3];
    vtkAirlight::Transmittance(this->Medium, &o.x, &end.x, rgb);
    return -std::log(rgb[0]);
  }

  // The same by the shader's function in single precision, from the ray's origin as the shader has
  // it.
  double GetShaderLength(const glm::dvec3& o, const glm::dvec3& d, double l)
  {
    airlight::f32::AirlightMedium medium{};
    medium.region.kind = AIRLIGHT_REGION_SURFACE;
    medium.region.boxMin = this->Tree->GetLeast() - o;
    medium.region.boxMax = this->Tree->GetGreatest() - o;
    medium.region.centre = this->Tree->GetCentre() - o;
    medium.region.data = this->Texels.data();
    medium.region.nodes = this->Tree->GetNodeCount();
    return airlight::f32::airlightPathDepth(
      medium, true, glm::vec3(0.0f), glm::normalize(glm::vec3(d)), static_cast<float>(l));
  }

  // Corner k of a random triangle.
  std::array<glm::dvec3, 3> TakeTriangle(Random& random) const
  {
    const int first = 2 * this->Tree->GetNodeCount();
    const int count = (static_cast<int>(this->Texels.size()) - first) / 3;
    const auto at = static_cast<size_t>(first) + 3 * random.Index(count);
    std::array<glm::dvec3, 3> triangle;
    for (size_t k = 0; k < 3; ++k)
    {
      triangle[k] = glm::dvec3(this->Tree->GetTexels()[at + k]) + this->Tree->GetCentre();
    }
    return triangle;
  }

  vtkNew<vtkParticipatingMedium> Medium;

private:
  std::shared_ptr<const airlight::SurfaceTree> Tree;
  std::vector<glm::vec4> Texels;
};

struct TestRay
{
  glm::dvec3 Origin;
  glm::dvec3 Direction;
};

TestRay Between(const glm::dvec3& a, const glm::dvec3& b) { return { a, glm::normalize(b - a) }; }

// What rays are aimed at.
enum Aim
{
  VERTEX,
  EDGE,
  ALONG_EDGE,
  ALONG_FACE,
  BESIDE_FACE, // by some 1e-7
  AIMS
};

const char* const AimNames[] = { "vertex", "edge", "along edge", "along face", "beside face" };

TestRay TakeRay(const Body& body, int aim, Random& random)
{
  const std::array<glm::dvec3, 3> t = body.TakeTriangle(random);
  const glm::dvec3 u = t[1] - t[0];
  const glm::dvec3 v = t[2] - t[0];
  const glm::dvec3 away = t[0] +
    random.LogUniform(0.5, 1000.0) *
      glm::dvec3(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
  const double share = random.Uniform(0.0, 1.0);
  switch (aim)
  {
    case VERTEX:
      return Between(away, t[0]);
    case EDGE:
      return Between(away, t[0] + share * u);
    case ALONG_EDGE:
      return Between(t[0] - random.Uniform(0.1, 9.0) * u, t[1]);
    default:
      break;
  }
  TestRay ray = Between(t[0] + random.Uniform(-9.0, 9.0) * u + random.Uniform(-9.0, 9.0) * v,
    t[0] + 0.5 * share * u + random.Uniform(0.0, 0.5) * v);
  if (aim == BESIDE_FACE)
  {
    ray.Origin +=
      1e-7 * glm::dvec3(random.Uniform(-1, 1), random.Uniform(-1, 1), random.Uniform(-1, 1));
  }
  return ray;
}

//------------------------------------------------------------------------------
// Bounds of a ray's length inside, with the body smaller and larger by `change`.
using Bounds = std::function<glm::dvec2(const TestRay&, double change)>;

// Points and roundings: 1e-9 in double precision; in single precision, whose unit is 1.2e-7, a
// millionth of the distances.
bool TestRays(const std::string& name, Body& body, const Bounds& bounds, Random& random)
{
  Comparison lengths(name + ", length beyond its bounds, double precision");
  Comparison shader(name + ", length beyond its bounds, single precision");
  for (int i = 0; i < 20000; ++i)
  {
    const TestRay ray = TakeRay(body, i % AIMS, random);
    const double reach = 4000.0;
    const auto test = [&](Comparison& comparison, double length, double change) {
      const glm::dvec2 range = bounds(ray, change);
      comparison.Add(std::max(range.x - length, length - range.y), change, [&] {
        return Text(AimNames[i % AIMS], ", origin ", Text3(&ray.Origin.x), ", direction ",
          Text3(&ray.Direction.x), ": expected ", range.x, " to ", range.y, ", got ", length);
      });
    };
    test(lengths, body.GetLength(ray.Origin, ray.Direction, reach), 1e-9);
    test(shader, body.GetShaderLength(ray.Origin, ray.Direction, reach),
      1e-6 * (10.0 + glm::length(ray.Origin)));
  }
  return AllOk({ &lengths, &shader });
}

//------------------------------------------------------------------------------
// With each box larger or smaller: what lies between is the solid.
glm::dvec2 BoundBoxes(const Solid& solid, const TestRay& ray, double change)
{
  const auto scaled = [&](const Box& box, double by) {
    Box result;
    for (int i = 0; i < 6; ++i)
    {
      result[i] = box[i] + (i % 2 ? by : -by);
    }
    return LengthInside({ result }, ray.Origin, ray.Direction, 4000.0);
  };
  glm::dvec2 range(0.0);
  for (size_t i = 0; i < solid.Boxes.size(); ++i)
  {
    const double least = scaled(solid.Boxes[i], -change);
    const double most = scaled(solid.Boxes[i], change);
    range += i > 0 && solid.Taken ? glm::dvec2(-most, -least) : glm::dvec2(least, most);
  }
  return { std::max(range.x, 0.0), range.y };
}

bool TestBoxes(Random& random)
{
  bool ok = true;
  for (const Solid& solid : MakeSolids())
  {
    Body body(solid.Surface);
    const Bounds bounds = [&](const TestRay& ray, double change) {
      return BoundBoxes(solid, ray, change);
    };
    ok = TestRays(solid.Name, body, bounds, random) && ok;
  }
  return ok;
}

//------------------------------------------------------------------------------
double LengthInBall(const TestRay& ray, double radius)
{
  const double foot = -glm::dot(ray.Origin, ray.Direction);
  const glm::dvec3 near = ray.Origin + foot * ray.Direction;
  const double half2 = radius * radius - glm::dot(near, near);
  const double half = std::sqrt(std::max(half2, 0.0));
  return std::max(foot + half, 0.0) - std::max(foot - half, 0.0);
}

// All corners are on the sphere, so that the mesh lies inside it, and every triangle lies outside
// of the ball that touches the plane of the largest circle of corners: of the triangle's
// circumradius c, at sqrt(R^2 - c^2) from the centre. Sides are at most R times the angles of the
// mesh, 2 pi/resolution, in a right angle: c <= R pi sqrt(2)/resolution. VTK's points are in
// single precision here: 2e-7 more.
bool TestSphere(int resolution, Random& random)
{
  constexpr double radius = 1.5;
  vtkNew<vtkSphereSource> source;
  source->SetRadius(radius);
  source->SetThetaResolution(resolution);
  source->SetPhiResolution(resolution);
  source->Update();
  Body body(source->GetOutput());
  const double c = radius * Pi * std::sqrt(2.0) / (resolution - 1);
  const double inner = std::sqrt(radius * radius - c * c) - 2e-7 * radius;
  const Bounds bounds = [&](const TestRay& ray, double change) {
    return glm::dvec2(
      LengthInBall(ray, inner - change), LengthInBall(ray, radius * (1.0 + 2e-7) + change));
  };
  return TestRays(Text("sphere of resolution ", resolution), body, bounds, random);
}

//------------------------------------------------------------------------------
// The real roots of a polynomial, c[0] + c[1] t + ..., in [low, high], rising: between those of its
// derivative it has at most one, by bisection.
std::vector<double> FindRoots(const std::vector<double>& c, double low, double high)
{
  std::vector<double> slope;
  for (size_t i = 1; i < c.size(); ++i)
  {
    slope.push_back(static_cast<double>(i) * c[i]);
  }
  std::vector<double> ends = { low };
  if (slope.size() > 1)
  {
    const std::vector<double> inner = FindRoots(slope, low, high);
    ends.insert(ends.end(), inner.begin(), inner.end());
  }
  ends.push_back(high);
  const auto value = [&](double t) {
    double sum = 0.0;
    for (size_t i = c.size(); i-- > 0;)
    {
      sum = sum * t + c[i];
    }
    return sum;
  };
  std::vector<double> roots;
  for (size_t i = 1; i < ends.size(); ++i)
  {
    double a = ends[i - 1];
    double b = ends[i];
    const bool rises = value(a) < 0.0;
    if (rises == (value(b) < 0.0))
    {
      continue;
    }
    for (int step = 0; step < 100; ++step)
    {
      const double middle = 0.5 * (a + b);
      ((value(middle) < 0.0) == rises ? a : b) = middle;
    }
    roots.push_back(0.5 * (a + b));
  }
  return roots;
}

// Points p of a torus about z, rings of radius 1 and tube: (p^2 + 1 - tube^2)^2 = 4 (x^2 + y^2).
// From the ray's nearest point to the centre, beyond 3 of which there is nothing.
double LengthInTorus(const TestRay& ray, double tube)
{
  const double foot = -glm::dot(ray.Origin, ray.Direction);
  const glm::dvec3 o = ray.Origin + foot * ray.Direction;
  const glm::dvec3& d = ray.Direction;
  const double k = glm::dot(o, o) + 1.0 - tube * tube;
  const double b = 2.0 * glm::dot(o, d);
  std::vector<double> ends =
    FindRoots({ k * k - 4.0 * (o.x * o.x + o.y * o.y), 2.0 * k * b - 8.0 * (o.x * d.x + o.y * d.y),
                b * b + 2.0 * k - 4.0 * (d.x * d.x + d.y * d.y), 2.0 * b, 1.0 },
      -3.0, 3.0);
  double sum = 0.0;
  for (size_t i = 0; i + 1 < ends.size(); i += 2)
  {
    sum += std::max(ends[i + 1] + foot, 0.0) - std::max(ends[i] + foot, 0.0);
  }
  return sum;
}

// A linear interpolant over a right triangle of parameters with sides du, dv is off a surface by at
// most (du^2 M1 + 2 du dv M2 + dv^2 M3)/8, M the largest second derivatives (Filip, Magedson and
// Markot 1986): about the axis 1 + tube, mixed tube, about the tube tube. So the mesh lies between
// the tori of that much thinner and thicker tubes.
bool TestTorus(int resolution, Random& random)
{
  constexpr double tube = 0.4;
  Body body(MakeTorus(tube, resolution));
  const double angle = 2.0 * Pi / resolution;
  const double off = angle * angle * (1.0 + tube + 2.0 * tube + tube) / 8.0;
  const Bounds bounds = [&](const TestRay& ray, double change) {
    return glm::dvec2(
      LengthInTorus(ray, tube - off - change), LengthInTorus(ray, tube + off + change));
  };
  return TestRays(Text("torus of resolution ", resolution), body, bounds, random);
}
}

//------------------------------------------------------------------------------
int TestClosedSurfaceRays(int, char*[])
{
  Random random(17);
  bool ok = TestBoxes(random);
  ok = TestSphere(64, random) && ok;
  ok = TestSphere(128, random) && ok;
  ok = TestTorus(64, random) && ok;
  ok = TestTorus(128, random) && ok;
  return ok ? EXIT_SUCCESS : EXIT_FAILURE;
}
