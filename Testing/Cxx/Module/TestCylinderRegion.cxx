// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// vtkAirlight for media inside cylinders: the length of rays inside against the roots of the
// cylinder's equations in extended precision and against points along the ray, for rays along the
// axis, parallel to it, across it and in any direction; airlight against adaptive quadrature
// (AirlightTestMatrixReference.h) for every kind of light and density, with lights and eyes inside
// and outside. Bad input is in TestMediumErrors.

#include "AirlightTestCheck.h"
#include "AirlightTestMatrix.h"
#include "AirlightTestMatrixReference.h"
#include "Medium/AirlightConvert.h"

#include "vtkAirlight.h"
#include "vtkNew.h"

#include <algorithm>
#include <cstdlib>
#include <limits>

using namespace airlight_test;

namespace
{
constexpr double inf = std::numeric_limits<double>::infinity();

struct Cylinder
{
  glm::dvec3 Centre;
  glm::dvec3 Axis;
  double Radius;
  double Height;

  void Set(vtkParticipatingMedium* medium) const
  {
    medium->SetRegionToCylinder();
    medium->SetCenter(&this->Centre.x);
    medium->SetAxis(&this->Axis.x);
    medium->SetRadius(this->Radius);
    medium->SetHeight(this->Height);
  }
};

// Two unit vectors across a third one.
glm::dvec3 Across(const glm::dvec3& v)
{
  return glm::normalize(
    glm::cross(v, std::abs(v.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0)));
}

//------------------------------------------------------------------------------
// The length of [0, l] of a ray inside, in coordinates with the axis z, by the quadratic equation.
double LengthInside(
  const Cylinder& cylinder, const glm::dvec3& origin, const glm::dvec3& direction, double l)
{
  using Long = long double;
  const glm::dvec3 u = Across(cylinder.Axis);
  const glm::dvec3 v = glm::cross(cylinder.Axis, u);
  const glm::dvec3 w = origin - cylinder.Centre;
  const Long x = glm::dot(w, u);
  const Long y = glm::dot(w, v);
  const Long z = glm::dot(w, cylinder.Axis);
  const Long dx = glm::dot(direction, u);
  const Long dy = glm::dot(direction, v);
  const Long dz = glm::dot(direction, cylinder.Axis);
  Long from = 0;
  Long to = l;
  const Long half = 0.5L * cylinder.Height;
  if (std::abs(dz) > 1e-15L)
  {
    from = std::max(from, std::min((-half - z) / dz, (half - z) / dz));
    to = std::min(to, std::max((-half - z) / dz, (half - z) / dz));
  }
  else if (std::abs(z) > half)
  {
    return 0.0;
  }
  const Long a = dx * dx + dy * dy;
  const Long b = x * dx + y * dy;
  const Long c = x * x + y * y - static_cast<Long>(cylinder.Radius) * cylinder.Radius;
  if (a > 1e-30L)
  {
    const Long discriminant = b * b - a * c;
    if (discriminant <= 0)
    {
      return 0.0;
    }
    from = std::max(from, (-b - std::sqrt(discriminant)) / a);
    to = std::min(to, (-b + std::sqrt(discriminant)) / a);
  }
  else if (c > 0)
  {
    return 0.0;
  }
  return static_cast<double>(std::max<Long>(to - from, 0));
}

// By points along the ray: to within their distance at both ends.
double CountInside(
  const Cylinder& cylinder, const glm::dvec3& origin, const glm::dvec3& direction, double l)
{
  constexpr int count = 20000;
  int inside = 0;
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 w = origin + l * (i + 0.5) / count * direction - cylinder.Centre;
    const double along = glm::dot(w, cylinder.Axis);
    inside += std::abs(along) < 0.5 * cylinder.Height &&
        glm::distance(w, along * cylinder.Axis) < cylinder.Radius
      ? 1
      : 0;
  }
  return l * inside / count;
}

enum RayKind
{
  ANY,
  ON_AXIS,
  PARALLEL,        // to the axis, inside the wall
  PARALLEL_BESIDE, // outside
  ACROSS,
  NEARLY_PARALLEL,
  RAY_KINDS
};

void TestLengths()
{
  Comparison lengths("length inside, relative to the cylinder's size");
  Comparison counted("length inside, by points");
  Random random(51);
  int through = 0;
  for (int i = 0; i < 6000; ++i)
  {
    const int kind = i % RAY_KINDS;
    const Cylinder cylinder{ random.Uniform(0.0, 5.0) * RandomUnit(random),
      i / RAY_KINDS % 3 == 0 ? glm::dvec3(0.0, 1.0, 0.0) : RandomUnit(random),
      random.LogUniform(0.1, 10.0), random.LogUniform(0.1, 10.0) };
    const glm::dvec3 across = Across(cylinder.Axis);
    const double sign = random.Index(2) ? 1.0 : -1.0;
    // Inside, at the level of the ends, and far away.
    const double from = cylinder.Height * random.Uniform(-1.5, 0.4);
    glm::dvec3 direction = sign * cylinder.Axis;
    glm::dvec3 origin = cylinder.Centre + from * direction;
    if (kind == PARALLEL || kind == NEARLY_PARALLEL)
    {
      origin += random.Uniform(0.0, 0.99) * cylinder.Radius * across;
    }
    else if (kind == PARALLEL_BESIDE)
    {
      origin += random.Uniform(1.01, 3.0) * cylinder.Radius * across;
    }
    if (kind == NEARLY_PARALLEL)
    {
      direction = glm::normalize(direction + random.LogUniform(1e-13, 1e-2) * RandomUnit(random));
    }
    else if (kind == ACROSS)
    {
      direction = glm::cross(cylinder.Axis, across);
      origin += random.Uniform(-1.2, 1.2) * cylinder.Radius * across -
        random.Uniform(-1.0, 3.0) * cylinder.Radius * direction;
    }
    else if (kind == ANY)
    {
      const double size = cylinder.Radius + cylinder.Height;
      origin = cylinder.Centre + random.Uniform(0.0, 2.0) * size * RandomUnit(random);
      direction = glm::normalize(
        cylinder.Centre + random.Uniform(0.0, 0.6) * size * RandomUnit(random) - origin);
    }
    const double size = cylinder.Radius + cylinder.Height;
    const double l = random.Index(3) ? 10.0 * size : random.Uniform(0.01, 3.0) * size;

    vtkNew<vtkParticipatingMedium> medium;
    cylinder.Set(medium);
    medium->SetScattering(1.0 / size, 1.0 / size, 1.0 / size);
    const glm::dvec3 end = origin + l * direction;
    double passes[3];
    vtkAirlight::Transmittance(medium, &origin.x, &end.x, passes);
    const double length = -std::log(passes[0]);
    const double expected = LengthInside(cylinder, origin, direction, l) / size;
    through += expected > 0.0 ? 1 : 0;
    const auto describe = [&] {
      return Text("ray ", i, ", kind ", kind, ", origin ", Text3(&origin.x), ", direction ",
        Text3(&direction.x), ", l ", l, ", centre ", Text3(&cylinder.Centre.x), ", axis ",
        Text3(&cylinder.Axis.x), ", radius ", cylinder.Radius, ", height ", cylinder.Height,
        ": got ", length, ", expected ", expected);
    };
    lengths.Add(std::abs(length - expected), 1e-11, describe);
    if (i % 10 < RAY_KINDS)
    {
      const double points = CountInside(cylinder, origin, direction, l) / size;
      counted.Add(std::abs(length - points), 2.1e-4 * l / size, describe);
    }
  }
  Check(AllOk({ &lengths, &counted }), "lengths");
  Check(through > 3000, Text("rays that pass the cylinder: ", through));
}

//------------------------------------------------------------------------------
// Known lengths, to rounding.
void TestKnownLengths()
{
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetScattering(1.0, 1.0, 1.0);
  Cylinder{ { 1.0, 2.0, 3.0 }, { 0.0, 0.0, 1.0 }, 0.5, 4.0 }.Set(medium);
  const struct
  {
    const char* What;
    glm::dvec3 From;
    glm::dvec3 To;
    double Length;
  } rays[] = { { "along the axis", { 1, 2, -10 }, { 1, 2, 10 }, 4.0 },
    { "along the axis, from inside", { 1, 2, 3 }, { 1, 2, 10 }, 2.0 },
    { "parallel to it", { 1.3, 2, 10 }, { 1.3, 2, -10 }, 4.0 },
    { "parallel to it, outside", { 1.6, 2, 10 }, { 1.6, 2, -10 }, 0.0 },
    { "across the axis", { -9, 2, 4 }, { 9, 2, 4 }, 1.0 },
    { "across it, 3/5 of the radius away", { -9, 2.3, 4 }, { 9, 2.3, 4 }, 0.8 },
    { "beyond an end", { -9, 2, 5.1 }, { 9, 2, 5.1 }, 0.0 },
    { "at the wall", { 1.6, -9, 4 }, { 1.6, 9, 4 }, 0.0 },
    { "inside", { 1.1, 2.1, 2 }, { 0.9, 1.9, 4 }, std::sqrt(4.08) },
    // It enters at z = 5, x = 1.3 and leaves at x = 1.5: 0.2 of 3/5.
    { "from end to wall, 3 : 4", { 1, 2, 5.4 }, { 4, 2, 1.4 }, 1.0 / 3.0 } };
  for (const auto& ray : rays)
  {
    double passes[3];
    vtkAirlight::Transmittance(medium, &ray.From.x, &ray.To.x, passes);
    Check(std::abs(-std::log(passes[1]) - ray.Length) <= 1e-14 + 1e-14 * ray.Length,
      Text(ray.What, ": ", -std::log(passes[1]), ", expected ", ray.Length));
  }
  // With a radius of 0, no ray across passes a length.
  medium->SetRadius(0.0);
  double passes[3];
  vtkAirlight::Transmittance(medium, &rays[4].From.x, &rays[4].To.x, passes);
  Check(passes[0] == 1.0, "a ray across a line");
}

//------------------------------------------------------------------------------
// The cylinder holds all points up to 0.9 from the origin, and none of those from 8 on.
glm::dvec3 PlacePoint(bool inside, Random& random)
{
  return (inside ? random.Uniform(0.0, 0.9) : random.Uniform(8.0, 12.0)) * RandomUnit(random);
}

void RunCell(const MatrixCell& cell, int i, vtkParticipatingMedium* medium, Random& random,
  Comparison& closed, Comparison& quadrature)
{
  const Cylinder cylinder{ random.Uniform(0.0, 0.5) * RandomUnit(random), RandomUnit(random),
    random.Uniform(1.5, 4.0), random.Uniform(3.0, 8.0) };
  medium->SetScattering(
    random.Uniform(0.02, 0.5), random.Uniform(0.02, 0.5), random.Uniform(0.02, 0.5));
  medium->SetAbsorption(random.Uniform(0.0, 0.2), 0.0, random.Uniform(0.0, 0.2));
  cylinder.Set(medium);
  const glm::dvec3 up = RandomUnit(random);
  medium->SetUp(&up.x);
  medium->SetScaleHeight(random.Uniform(3.0, 6.0));
  vtkNew<vtkLight> light;
  cell.Apply(medium, light);
  glm::dvec3 position = PlacePoint(i % 2 == 0, random);
  glm::dvec3 origin = PlacePoint(i / 2 % 2 == 0, random);
  glm::dvec3 direction = glm::normalize(PlacePoint(true, random) - origin);
  if (i % 6 == 5) // along the axis
  {
    direction = cylinder.Axis;
    origin = cylinder.Centre - random.Uniform(-1.0, 9.0) * direction;
  }
  else if (i % 6 == 4) // parallel to it
  {
    direction = -cylinder.Axis;
    origin = cylinder.Centre - random.Uniform(-1.0, 9.0) * direction +
      random.Uniform(0.0, 1.4) * Across(cylinder.Axis);
  }
  glm::dvec3 focalPoint = origin + random.Uniform(0.5, 8.0) * direction;
  if (cell.Light == MATRIX_SUN)
  {
    focalPoint = position + RandomUnit(random);
  }
  light->SetPosition(&position.x);
  light->SetFocalPoint(&focalPoint.x);
  light->SetColor(4.0, 7.0, 2.0);
  if (cell.IsSpot())
  {
    light->SetConeAngle(random.Uniform(10.0, 60.0));
  }
  const double t0 = i % 3 == 2 ? random.Uniform(0.0, 2.0) : 0.0;
  const double t1 = i % 3 == 0 ? inf : t0 + random.Uniform(0.5, 15.0);
  const MatrixReference reference(medium, light);
  const bool isClosed = cell.HasClosedForm(reference.IsInside(position), medium);
  double rgb[3];
  vtkAirlight::Inscatter(medium, light, &origin.x, &direction.x, t0, t1, rgb);
  for (int k = 0; k < 3; ++k)
  {
    const double expected = reference.Airlight(k, origin, direction, t0, t1);
    const double limit = medium->GetPhaseErrorBound() + (isClosed ? 1e-9 : 1e-6);
    (isClosed ? closed : quadrature)
      .Add(std::abs(rgb[k] - expected), limit * expected + 1e-200, [&] {
        return Text(cell.Describe(), ", ray ", i, ", channel ", k, ": expected ", expected,
          ", got ", rgb[k], ", relative ", rgb[k] / expected - 1.0, "; light ", Text3(&position.x),
          " to ", Text3(&focalPoint.x), ", origin ", Text3(&origin.x), ", direction ",
          Text3(&direction.x), ", [", t0, ", ", t1, "], centre ", Text3(&cylinder.Centre.x),
          ", axis ", Text3(&cylinder.Axis.x), ", radius ", cylinder.Radius, ", height ",
          cylinder.Height, ", up ", Text3(&up.x));
      });
  }
}

bool TestCells()
{
  Comparison closed("closed form, cylinders");
  Comparison quadrature("quadrature, cylinders");
  Random random(52);
  vtkNew<vtkParticipatingMedium> medium;
  medium->SetPhaseTolerance(1e-6);
  for (const int phase : { MATRIX_ISOTROPIC, MATRIX_FORWARD, MATRIX_RAYLEIGH, MATRIX_MIE_HAZY })
  {
    for (int light = 0; light < MATRIX_LIGHTS; ++light)
    {
      for (int density = 0; density < 2; ++density)
      {
        const MatrixCell cell{ light, vtkParticipatingMedium::CYLINDER, density, phase };
        for (int i = 0; i < 24; ++i)
        {
          RunCell(cell, i, medium, random, closed, quadrature);
        }
      }
    }
  }
  return AllOk({ &closed, &quadrature });
}

//------------------------------------------------------------------------------
// The quadrature of the shaders, in double precision.
glm::dvec3 InscatterOfBoth(vtkParticipatingMedium* fog, vtkParticipatingMedium* smoke,
  vtkLight* light, const glm::dvec3& origin, const glm::dvec3& direction, double l)
{
  namespace f64 = airlight::f64;
  const f64::AirlightMedia media = airlight::ConvertMedia({ fog, smoke }, glm::dvec3(0.0));
  f64::AirlightLight converted{};
  Check(airlight::ConvertLight(media, light, glm::dvec3(0.0), converted) ==
      airlight::LightSupport::Scatters,
    "the light scatters");
  const f64::AirlightRay ray = f64::airlightRay(media, converted, origin, direction, l);
  return converted.intensity * f64::airlightQuadrature(media, converted, ray, ray.lit.x, ray.lit.y);
}

// A cylinder of smoke in fog, against the midpoint rule: quadrature is cut where the way to a light
// outside touches the wall or passes from the wall to an end.
void TestInFog()
{
  Comparison sums("a cylinder in fog");
  Random random(53);
  vtkNew<vtkParticipatingMedium> fog;
  vtkNew<vtkParticipatingMedium> smoke;
  fog->SetScattering(0.05, 0.08, 0.1);
  smoke->SetScattering(0.4, 0.3, 0.2);
  smoke->SetAbsorption(0.1, 0.2, 0.3);
  for (int i = 0; i < 60; ++i)
  {
    const Cylinder cylinder{ random.Uniform(0.0, 0.5) * RandomUnit(random), RandomUnit(random),
      random.Uniform(0.5, 2.0), random.Uniform(1.0, 4.0) };
    cylinder.Set(smoke);
    const glm::dvec3 source = random.Uniform(0.0, 6.0) * RandomUnit(random);
    const glm::dvec3 origin = random.Uniform(0.0, 6.0) * RandomUnit(random);
    const glm::dvec3 direction =
      glm::normalize(random.Uniform(0.0, 2.0) * RandomUnit(random) - origin);
    const double l = random.Uniform(2.0, 12.0);
    // By the midpoint rule in t = tL + h sinh(v), with lengths inside from above.
    const double tL = glm::dot(source - origin, direction);
    const double h = glm::length(glm::cross(source - origin, direction));
    const double v0 = std::asinh(-tL / h);
    const double v1 = std::asinh((l - tL) / h);
    constexpr int steps = 20000;
    glm::dvec3 expected(0.0);
    for (int k = 0; k < steps; ++k)
    {
      const double v = v0 + (v1 - v0) * (k + 0.5) / steps;
      const double t = tL + h * std::sinh(v);
      const glm::dvec3 point = origin + t * direction;
      const double r = glm::distance(source, point);
      const double inside = LengthInside(cylinder, origin, direction, t) +
        LengthInside(cylinder, point, (source - point) / r, r);
      const glm::dvec3 w = point - cylinder.Centre;
      const double along = glm::dot(w, cylinder.Axis);
      const bool here = std::abs(along) < 0.5 * cylinder.Height &&
        glm::distance(w, along * cylinder.Axis) < cylinder.Radius;
      for (int c = 0; c < 3; ++c)
      {
        const double depth = fog->GetExtinction()[c] * (t + r) + smoke->GetExtinction()[c] * inside;
        const double sigma = fog->GetScattering()[c] + (here ? smoke->GetScattering()[c] : 0.0);
        expected[c] +=
          sigma * 0.25 / Pi * std::exp(-depth) / (r * r) * h * std::cosh(v) * (v1 - v0) / steps;
      }
    }
    vtkNew<vtkLight> light;
    light->SetPositional(true);
    light->SetConeAngle(180.0);
    light->SetPosition(&source.x);
    light->SetAttenuationValues(0.0, 0.0, 1.0);
    const double one[3] = { 1.0, 1.0, 1.0 };
    vtkAirlight::SetRadiantIntensity(light, one);
    const glm::dvec3 got = InscatterOfBoth(fog, smoke, light, origin, direction, l);
    for (int c = 0; c < 3; ++c)
    {
      sums.Add(std::abs(got[c] - expected[c]), 1e-3 * expected[c], [&] {
        return Text("ray ", i, ", channel ", c, ": got ", got[c], ", expected ", expected[c]);
      });
    }
  }
  Check(AllOk({ &sums }), "a cylinder in fog");
}
}

//------------------------------------------------------------------------------
int TestCylinderRegion(int, char*[])
{
  TestKnownLengths();
  TestLengths();
  TestInFog();
  return TestCells() && Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
