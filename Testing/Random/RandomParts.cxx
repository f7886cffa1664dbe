// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "RandomParts.h"

#include <algorithm>

namespace airlight_test
{
namespace
{
const double Pi = std::acos(-1.0);

using Triangle = std::array<glm::dvec3, 3>;

// The quad between four points of a surface p(u, v).
template <typename Surface>
void AddQuad(TriangleList& triangles, const Surface& p, double u0, double u1, double v0, double v1)
{
  triangles.push_back({ p(u0, v0), p(u1, v0), p(u1, v1) });
  triangles.push_back({ p(u0, v0), p(u1, v1), p(u0, v1) });
}

template <typename Surface>
TriangleList Tessellate(const Surface& p, int columns, int rows)
{
  TriangleList triangles;
  for (int i = 0; i < columns; ++i)
  {
    for (int j = 0; j < rows; ++j)
    {
      AddQuad(
        triangles, p, 1.0 * i / columns, (i + 1.0) / columns, 1.0 * j / rows, (j + 1.0) / rows);
    }
  }
  return triangles;
}

TriangleList MakeSphere(Random& random)
{
  const auto point = [](double u, double v) {
    // The seam and the poles close to the last bit.
    const double a = 2.0 * Pi * (u == 1.0 ? 0.0 : u);
    const double s = v == 0.0 || v == 1.0 ? 0.0 : std::sin(Pi * v);
    return glm::dvec3(s * std::cos(a), s * std::sin(a), -std::cos(Pi * v));
  };
  const int rows = 3 + random.Index(10);
  return Tessellate(point, 4 + random.Index(13), rows);
}

TriangleList MakeBox(Random& random)
{
  const double depth = random.Uniform(0.2, 1.0);
  const glm::dvec3 size(random.Uniform(0.2, 1.0), depth, 1.0);
  TriangleList triangles;
  for (int axis = 0; axis < 3; ++axis)
  {
    for (double side : { -1.0, 1.0 })
    {
      const auto point = [&](double u, double v) {
        glm::dvec3 p;
        p[axis] = side;
        p[(axis + 1) % 3] = side * (2.0 * u - 1.0);
        p[(axis + 2) % 3] = 2.0 * v - 1.0;
        return size * p;
      };
      AddQuad(triangles, point, 0.0, 1.0, 0.0, 1.0);
    }
  }
  return triangles;
}

TriangleList MakeSheet(Random& random)
{
  const double bend = random.Index(2) ? random.Uniform(0.0, 0.5) : 0.0;
  const auto point = [bend](double u, double v) {
    return glm::dvec3(2.0 * u - 1.0, bend * std::sin(3.0 * u + 2.0 * v), 2.0 * v - 1.0);
  };
  const int rows = 1 + random.Index(6);
  return Tessellate(point, 1 + random.Index(6), rows);
}

TriangleList MakeOpenCylinder(Random& random)
{
  const double radius = random.Uniform(0.2, 1.0);
  const auto point = [radius](double u, double v) {
    const double a = 2.0 * Pi * (u == 1.0 ? 0.0 : u);
    return glm::dvec3(radius * std::cos(a), 2.0 * v - 1.0, radius * std::sin(a));
  };
  const int rows = 1 + random.Index(3);
  return Tessellate(point, 3 + random.Index(18), rows);
}

Triangle RandomTriangle(Random& random, double size)
{
  const glm::dvec3 centre = RandomPoint(random, 1.0);
  Triangle t;
  for (glm::dvec3& corner : t)
  {
    corner = centre + RandomPoint(random, size);
  }
  return t;
}

TriangleList MakeSlivers(Random& random)
{
  TriangleList triangles;
  const int count = 3 + random.Index(20);
  for (int i = 0; i < count; ++i)
  {
    const glm::dvec3 a = RandomPoint(random, 1.0);
    const glm::dvec3 b = RandomPoint(random, 1.0);
    const double width = random.LogUniform(1e-6, 3e-2);
    const glm::dvec3 beside = width * RandomUnit(random);
    triangles.push_back({ a, b, glm::mix(a, b, random.Uniform(0.0, 1.0)) + beside });
  }
  return triangles;
}

TriangleList MakeCoplanar(Random& random)
{
  TriangleList triangles;
  const int count = 2 + random.Index(8);
  for (int i = 0; i < count; ++i)
  {
    Triangle t = RandomTriangle(random, random.LogUniform(0.05, 1.0));
    for (glm::dvec3& corner : t)
    {
      corner.z = 0.0;
    }
    triangles.push_back(t);
  }
  return triangles;
}

TriangleList MakeCoincident(Random& random)
{
  TriangleList triangles;
  const int count = 1 + random.Index(5);
  for (int i = 0; i < count; ++i)
  {
    Triangle t = RandomTriangle(random, random.Uniform(0.2, 1.0));
    const int copies = 2 + random.Index(3);
    for (int copy = 0; copy < copies; ++copy)
    {
      triangles.push_back(t);
      std::rotate(t.begin(), t.begin() + random.Index(3), t.end());
      if (random.Index(2))
      {
        std::swap(t[0], t[1]);
      }
    }
  }
  return triangles;
}

TriangleList MakeDegenerate(Random& random)
{
  TriangleList triangles;
  for (int i = 0; i < 12; ++i)
  {
    Triangle t = RandomTriangle(random, random.LogUniform(0.1, 1.0));
    switch (random.Index(4))
    {
      case 0:
        t[2] = t[random.Index(2)];
        break;
      case 1:
        t[1] = t[2] = t[0];
        break;
      case 2:
        t[2] = glm::mix(t[0], t[1], random.Uniform(-1.0, 2.0)); // but for rounding
        break;
      default:
        break;
    }
    triangles.push_back(t);
  }
  return triangles;
}

TriangleList MakeFan(Random& random)
{
  TriangleList triangles;
  const int edges = 1 + random.Index(3);
  for (int i = 0; i < edges; ++i)
  {
    const glm::dvec3 a = RandomPoint(random, 1.0);
    const glm::dvec3 b = RandomPoint(random, 1.0);
    const int wings = 3 + random.Index(4);
    for (int wing = 0; wing < wings; ++wing)
    {
      triangles.push_back({ a, b, RandomPoint(random, 1.0) });
      if (random.Index(2))
      {
        std::swap(triangles.back()[0], triangles.back()[1]);
      }
    }
  }
  return triangles;
}

TriangleList MakeSoupPart(Random& random)
{
  TriangleList triangles;
  const int count = 5 + random.Index(60);
  for (int i = 0; i < count; ++i)
  {
    triangles.push_back(RandomTriangle(random, random.LogUniform(1e-3, 0.6)));
  }
  return triangles;
}

TriangleList MakeStack(Random& random)
{
  TriangleList triangles;
  const int layers = 2 + random.Index(4);
  for (int layer = 0; layer < layers; ++layer)
  {
    const double height = random.Index(2) ? 0.25 * layer : 0.0;
    const double shift = 0.5 * random.Index(3);
    const auto point = [&](double u, double v) {
      return glm::dvec3(u - 1.0 + shift, height, 2.0 * v - 1.0);
    };
    AddQuad(triangles, point, 0.0, 1.0, 0.0, 1.0);
  }
  return triangles;
}

TriangleList MakeFloor(Random& random)
{
  const double reach = random.Index(4) ? 4.0 : 40.0;
  const auto point = [reach](double u, double v) {
    return glm::dvec3(reach * (2.0 * u - 1.0), -1.0, reach * (2.0 * v - 1.0));
  };
  return Tessellate(point, 1, 1);
}
}

//------------------------------------------------------------------------------
const char* GetPartName(int kind)
{
  static const char* const names[] = { "sphere", "box", "sheet", "open cylinder", "slivers",
    "coplanar", "coincident", "degenerate", "fan", "lattice", "soup", "stack", "floor" };
  return names[kind];
}

//------------------------------------------------------------------------------
TriangleList MakePart(int kind, Random& random)
{
  switch (kind)
  {
    case PART_SPHERE:
      return MakeSphere(random);
    case PART_BOX:
      return MakeBox(random);
    case PART_SHEET:
      return MakeSheet(random);
    case PART_OPEN_CYLINDER:
      return MakeOpenCylinder(random);
    case PART_SLIVERS:
      return MakeSlivers(random);
    case PART_COPLANAR:
      return MakeCoplanar(random);
    case PART_COINCIDENT:
      return MakeCoincident(random);
    case PART_DEGENERATE:
      return MakeDegenerate(random);
    case PART_FAN:
      return MakeFan(random);
    case PART_LATTICE:
      return MakeLatticeSoup(random, 4 + random.Index(30));
    case PART_SOUP:
      return MakeSoupPart(random);
    case PART_STACK:
      return MakeStack(random);
    default:
      return MakeFloor(random);
  }
}
}
