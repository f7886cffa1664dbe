// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Silhouette/AirlightCutPieces.h"

#include "Silhouette/AirlightParallel.h"

#include <cmath>
#include <numeric>

namespace airlight
{
namespace
{
// A polygon's corner, at infinity where Position.w is 0. What it takes from up to three vertices
// is a linear function of the homogeneous coordinates, too.
struct Corner
{
  glm::dvec4 Position;
  glm::dvec3 Weights;
};

using Polygon = std::vector<Corner>;

// Keeps what is in front of the plane, by Sutherland and Hodgman's method.
void Clip(Polygon& polygon, const glm::dvec4& plane, Polygon& buffer)
{
  buffer.clear();
  for (size_t i = 0; i < polygon.size(); ++i)
  {
    const Corner& a = polygon[i];
    const Corner& b = polygon[i + 1 < polygon.size() ? i + 1 : 0];
    const double fromA = glm::dot(plane, a.Position);
    const double fromB = glm::dot(plane, b.Position);
    if (fromA >= 0.0)
    {
      buffer.push_back(a);
    }
    if ((fromA >= 0.0) != (fromB >= 0.0))
    {
      const double s = fromA / (fromA - fromB);
      buffer.push_back(
        { a.Position + s * (b.Position - a.Position), a.Weights + s * (b.Weights - a.Weights) });
    }
  }
  polygon.swap(buffer);
}

glm::dvec4 MakePlane(const glm::dvec3& normal, const glm::dvec3& point)
{
  return { normal, -glm::dot(normal, point) };
}

glm::dvec4 ToHomogeneous(const glm::dvec3& point) { return { point, 1.0 }; }

class Cutter
{
public:
  Cutter(const CasterMesh& mesh, const HomogeneousPoint& light, const PieceOptions& options)
    : Mesh(mesh)
    , Light(light)
    , Options(options)
  {
    for (int axis = 0; axis < 3; ++axis)
    {
      glm::dvec3 normal(0.0);
      normal[axis] = 1.0;
      this->Box[2 * axis] = MakePlane(normal, options.BoundsMin);
      this->Box[2 * axis + 1] = MakePlane(-normal, options.BoundsMax);
    }
  }

  ShadowPieces Result;

  void AddPlane(const SilhouetteEdge& edge)
  {
    const glm::dvec4 a = ToHomogeneous(this->Mesh.Points[edge.A]);
    const glm::dvec4 b = ToHomogeneous(this->Mesh.Points[edge.B]);
    const glm::dvec3 isA(1.0, 0.0, 0.0);
    const glm::dvec3 isB(0.0, 1.0, 0.0);
    this->Work = { { a, isA }, { a - this->Light, isA }, { b - this->Light, isB }, { b, isB } };
    if (this->Light.w == 0.0)
    {
      // Away from a light at infinity lies one point, which takes nothing from either end.
      this->Work[1] = this->Work[2] = { -this->Light, glm::dvec3(0.0) };
    }
    this->ClipToBox();
    this->Keep({ edge.A, edge.B, edge.B }, { edge.A, edge.B, edge.Weight, SHADOW_PLANE });
  }

  void AddLightCap(int triangle, bool facing)
  {
    const std::array<int, 3>& t = this->Mesh.Triangles[triangle];
    const std::array<int, 3> oriented{ t[0], t[facing ? 1 : 2], t[facing ? 2 : 1] };
    this->Work.clear();
    for (int k = 0; k < 3; ++k)
    {
      glm::dvec3 weights(0.0);
      weights[k] = 1.0;
      this->Work.push_back({ ToHomogeneous(this->Mesh.Points[oriented[k]]), weights });
    }
    this->ClipToBox();
    this->Keep(oriented, { -1, -1, 1, LIGHT_CAP });
  }

  // The part of the box' faces in the triangle's shadow.
  void AddFarCap(int triangle, bool facing)
  {
    const std::array<int, 3>& t = this->Mesh.Triangles[triangle];
    const glm::dvec4& plane = this->Mesh.Planes[triangle];
    const glm::dvec4 sides[4] = { facing ? -plane : plane, this->MakeSide(t[0], t[1], t[2]),
      this->MakeSide(t[1], t[2], t[0]), this->MakeSide(t[2], t[0], t[1]) };
    const glm::dmat4 toVertices = glm::inverse(glm::dmat4(ToHomogeneous(this->Mesh.Points[t[0]]),
      ToHomogeneous(this->Mesh.Points[t[1]]), ToHomogeneous(this->Mesh.Points[t[2]]), this->Light));
    for (int face = 0; face < 6; ++face)
    {
      this->SetToFace(face);
      for (const glm::dvec4& side : sides)
      {
        Clip(this->Work, side, this->Buffer);
      }
      // A point is a sum of the vertices and the light; its shadow caster has the vertices' parts.
      for (Corner& corner : this->Work)
      {
        const glm::dvec3 weights = glm::max(glm::dvec3(toVertices * corner.Position), 0.0);
        const double sum = weights.x + weights.y + weights.z;
        corner.Weights =
          std::isfinite(sum) && sum > 0.0 ? weights / sum : glm::dvec3(1.0, 0.0, 0.0);
      }
      this->Keep(t, { -1, -1, 1, FAR_CAP });
    }
  }

private:
  void ClipToBox()
  {
    for (const glm::dvec4& plane : this->Box)
    {
      Clip(this->Work, plane, this->Buffer);
    }
  }

  // The plane through the light and an edge, in front of which is the opposite vertex.
  glm::dvec4 MakeSide(int a, int b, int opposite) const
  {
    const glm::dvec3& p = this->Mesh.Points[a];
    const glm::dvec3 normal =
      glm::cross(this->Mesh.Points[b] - p, glm::dvec3(this->Light) - this->Light.w * p);
    const glm::dvec4 plane = MakePlane(normal, p);
    return glm::dot(normal, this->Mesh.Points[opposite] - p) < 0.0 ? -plane : plane;
  }

  // Seen from outside the box anticlockwise.
  void SetToFace(int face)
  {
    const int axis = face / 2;
    const bool high = face % 2 == 1;
    const glm::dvec3& lo = this->Options.BoundsMin;
    const glm::dvec3& hi = this->Options.BoundsMax;
    const int u = (axis + 1) % 3;
    const int v = (axis + 2) % 3;
    this->Work.clear();
    for (int k = 0; k < 4; ++k)
    {
      const int corner = high ? k : 3 - k;
      glm::dvec3 p;
      p[axis] = high ? hi[axis] : lo[axis];
      p[u] = corner == 1 || corner == 2 ? hi[u] : lo[u];
      p[v] = corner >= 2 ? hi[v] : lo[v];
      this->Work.push_back({ ToHomogeneous(p), glm::dvec3(0.0) });
    }
  }

  void Keep(const std::array<int, 3>& vertices, const PieceLabel& label)
  {
    if (this->Work.size() < 3)
    {
      return;
    }
    for (const Corner& corner : this->Work)
    {
      const glm::dvec3& w = corner.Weights;
      this->Result.Points.push_back(
        { glm::dvec3(corner.Position) / corner.Position.w, vertices, w / (w.x + w.y + w.z) });
    }
    this->Result.Sizes.push_back(static_cast<int>(this->Work.size()));
    this->Result.Labels.push_back(label);
  }

  const CasterMesh& Mesh;
  const HomogeneousPoint Light;
  const PieceOptions& Options;
  glm::dvec4 Box[6];
  Polygon Work;
  Polygon Buffer;
};

template <typename Item>
std::vector<Item> Join(std::vector<ShadowPieces>& parts, std::vector<Item> ShadowPieces::*list)
{
  std::vector<std::vector<Item>> lists;
  lists.reserve(parts.size());
  for (ShadowPieces& part : parts)
  {
    lists.push_back(std::move(part.*list));
  }
  return Concatenate(std::move(lists));
}
}

//------------------------------------------------------------------------------
ShadowPieces CutShadowPieces(const CasterMesh& mesh, const HomogeneousPoint& light,
  const PieceOptions& options, const CasterMesh::Progress& progress)
{
  std::vector<ShadowPieces> parts;
  // Appends what add(cutter, i) makes for 0 <= i < count.
  const auto cut = [&](size_t count, const auto& add) {
    const size_t first = parts.size();
    parts.resize(first + CountChunks(count));
    ForEachChunk(count, [&](size_t chunk, size_t begin, size_t end) {
      Cutter cutter(mesh, light, options);
      for (size_t i = begin; i < end; ++i)
      {
        add(cutter, i);
      }
      parts[first + chunk] = std::move(cutter.Result);
    });
  };
  const std::vector<SilhouetteEdge> edges = FindSilhouette(mesh, light);
  const std::vector<signed char> facings = FindFacings(mesh, light);
  cut(edges.size(), [&](Cutter& cutter, size_t i) { cutter.AddPlane(edges[i]); });
  bool goOn = progress(0.3);
  if (goOn && options.LightCap)
  {
    cut(facings.size(), [&](Cutter& cutter, size_t f) {
      if (facings[f] != 0)
      {
        cutter.AddLightCap(static_cast<int>(f), facings[f] > 0);
      }
    });
    goOn = progress(0.5);
  }
  if (goOn && options.FarCap)
  {
    cut(facings.size(), [&](Cutter& cutter, size_t f) {
      if (facings[f] != 0)
      {
        cutter.AddFarCap(static_cast<int>(f), facings[f] > 0);
      }
    });
    goOn = progress(0.9);
  }
  ShadowPieces pieces;
  if (goOn)
  {
    pieces.Points = Join(parts, &ShadowPieces::Points);
    pieces.Sizes = Join(parts, &ShadowPieces::Sizes);
    pieces.Labels = Join(parts, &ShadowPieces::Labels);
    pieces.Ids.resize(pieces.Points.size());
    std::iota(pieces.Ids.begin(), pieces.Ids.end(), 0);
    progress(1.0);
  }
  return pieces;
}
}
