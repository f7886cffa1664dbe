// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Flat pieces of the surfaces that bound shadows.
 */

#ifndef AirlightShadowPieces_h
#define AirlightShadowPieces_h

#include "Silhouette/AirlightSilhouette.h"

#include "vtkType.h"

#include <glm/glm.hpp>

#include <array>
#include <functional>
#include <vector>

namespace airlight
{
// A point whose data are those of up to three of the mesh's vertices.
struct PiecePoint
{
  glm::dvec3 Position;
  std::array<int, 3> Vertices;
  glm::dvec3 Weights; // their sum is 1
};

enum PiecePart
{
  SHADOW_PLANE = 0,
  LIGHT_CAP = 1,
  FAR_CAP = 2
};

struct PieceLabel
{
  int A; // the edge's vertices; -1 for caps
  int B;
  int Weight;
  int Part;
};

// Polygons that a ray crosses from front to back where it enters `Weight` shadow volumes.
struct ShadowPieces
{
  std::vector<PiecePoint> Points;
  std::vector<vtkIdType> Ids; // the polygons' points, one polygon after the other
  std::vector<int> Sizes;     // how many points each has
  std::vector<PieceLabel> Labels;
};

// Where the pieces end.
struct PieceOptions
{
  bool InBounds = false;
  double FarDistance = 0.0; // beyond the edges; not used in bounds
  glm::dvec3 BoundsMin{ 0.0 };
  glm::dvec3 BoundsMax{ 0.0 };
  bool LightCap = false;
  bool FarCap = false;
};

// The pieces of all triangles' shadow volumes: planes, then light caps, then far caps. Stops early
// and returns what there is where progress returns false.
ShadowPieces MakeShadowPieces(const CasterMesh& mesh, const HomogeneousPoint& light,
  const PieceOptions& options, const CasterMesh::Progress& progress);

// The numbers of those that are marked, in their order; -1 for the others.
struct Numbering
{
  explicit Numbering(const std::vector<char>& marks);
  std::vector<int> Number;
  std::vector<int> Marked;
};
}

#endif
