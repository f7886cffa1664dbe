// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "Silhouette/AirlightShadowPieces.h"

#include "Silhouette/AirlightCutPieces.h"
#include "Silhouette/AirlightParallel.h"

#include <utility>

namespace airlight
{
namespace
{
const glm::dvec3 OneVertex(1.0, 0.0, 0.0);

glm::dvec3 MoveAway(const glm::dvec3& point, const HomogeneousPoint& light, double distance)
{
  const glm::dvec3 away =
    light.w != 0.0 ? point - glm::dvec3(light) : -glm::dvec3(light); // of unit length at infinity
  return point + (light.w != 0.0 ? distance / glm::length(away) : distance) * away;
}

// Near and far points of the vertices that the pieces use, shared by all of them.
class FarPieces
{
public:
  FarPieces(const CasterMesh& mesh, const std::vector<SilhouetteEdge>& edges,
    const std::vector<int>& casting, const PieceOptions& options)
    : Mesh(mesh)
    , Near(this->Mark(edges, casting, options.LightCap))
    , Far(this->Mark(edges, casting, options.FarCap))
  {
  }

  std::vector<PiecePoint> MakePoints(const HomogeneousPoint& light, double distance) const
  {
    const size_t nearCount = this->Near.Marked.size();
    std::vector<PiecePoint> points(nearCount + this->Far.Marked.size());
    ForEachChunk(points.size(), [&](size_t, size_t begin, size_t end) {
      for (size_t i = begin; i < end; ++i)
      {
        const bool isFar = i >= nearCount;
        const int vertex = isFar ? this->Far.Marked[i - nearCount] : this->Near.Marked[i];
        const glm::dvec3& p = this->Mesh.Points[vertex];
        points[i] = { isFar ? MoveAway(p, light, distance) : p, { vertex, vertex, vertex },
          OneVertex };
      }
    });
    return points;
  }

  vtkIdType NearId(int vertex) const { return this->Near.Number[vertex]; }
  vtkIdType FarId(int vertex) const
  {
    return static_cast<vtkIdType>(this->Near.Marked.size()) + this->Far.Number[vertex];
  }

private:
  Numbering Mark(
    const std::vector<SilhouetteEdge>& edges, const std::vector<int>& casting, bool capped) const
  {
    std::vector<char> marks(this->Mesh.Points.size());
    for (const SilhouetteEdge& edge : edges)
    {
      marks[edge.A] = marks[edge.B] = 1;
    }
    for (size_t i = 0; capped && i < casting.size(); ++i)
    {
      for (const int vertex : this->Mesh.Triangles[casting[i]])
      {
        marks[vertex] = 1;
      }
    }
    return Numbering(marks);
  }

  const CasterMesh& Mesh;
  const Numbering Near;
  const Numbering Far;
};

// Triangles that the light does not see edge-on.
std::vector<int> FindCasting(const std::vector<signed char>& facings)
{
  std::vector<int> casting;
  for (size_t f = 0; f < facings.size(); ++f)
  {
    if (facings[f] != 0)
    {
      casting.push_back(static_cast<int>(f));
    }
  }
  return casting;
}
}

//------------------------------------------------------------------------------
Numbering::Numbering(const std::vector<char>& marks)
  : Number(marks.size(), -1)
{
  for (size_t i = 0; i < marks.size(); ++i)
  {
    if (marks[i])
    {
      this->Number[i] = static_cast<int>(this->Marked.size());
      this->Marked.push_back(static_cast<int>(i));
    }
  }
}

//------------------------------------------------------------------------------
ShadowPieces MakeShadowPieces(const CasterMesh& mesh, const HomogeneousPoint& light,
  const PieceOptions& options, const CasterMesh::Progress& progress)
{
  if (options.InBounds)
  {
    return CutShadowPieces(mesh, light, options, progress);
  }
  const std::vector<SilhouetteEdge> edges = FindSilhouette(mesh, light);
  const std::vector<signed char> facings =
    options.LightCap || options.FarCap ? FindFacings(mesh, light) : std::vector<signed char>();
  const std::vector<int> casting = FindCasting(facings);
  ShadowPieces pieces;
  if (!progress(0.3))
  {
    return pieces;
  }
  const FarPieces ids(mesh, edges, casting, options);
  pieces.Points = ids.MakePoints(light, options.FarDistance);
  if (!progress(0.7))
  {
    return pieces;
  }
  for (const SilhouetteEdge& e : edges)
  {
    pieces.Ids.insert(
      pieces.Ids.end(), { ids.NearId(e.A), ids.FarId(e.A), ids.FarId(e.B), ids.NearId(e.B) });
    pieces.Sizes.push_back(4);
    pieces.Labels.push_back({ e.A, e.B, e.Weight, SHADOW_PLANE });
  }
  for (const PiecePart part : { LIGHT_CAP, FAR_CAP })
  {
    if (!(part == LIGHT_CAP ? options.LightCap : options.FarCap))
    {
      continue;
    }
    for (const int f : casting)
    {
      std::array<int, 3> t = mesh.Triangles[f];
      // Light caps face the light, far caps look away from it.
      if ((facings[f] > 0) != (part == LIGHT_CAP))
      {
        std::swap(t[1], t[2]);
      }
      for (const int vertex : t)
      {
        pieces.Ids.push_back(part == LIGHT_CAP ? ids.NearId(vertex) : ids.FarId(vertex));
      }
      pieces.Sizes.push_back(3);
      pieces.Labels.push_back({ -1, -1, 1, part });
    }
  }
  progress(1.0);
  return pieces;
}
}
