// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * Which way the triangles of a closed surface face: neighbours alike, and each patch of them
 * outwards, which is the side that an even number of crossings leads to.
 */

#ifndef AirlightSurfaceOrientation_h
#define AirlightSurfaceOrientation_h

#include "Region/AirlightSurfaceTree.h"

namespace airlight
{
class SurfaceOrientation
{
public:
  // Turns triangles over these points over. The points are relative to `centre`. All have to live
  // as long as this.
  SurfaceOrientation(const std::vector<glm::dvec3>& points, const glm::dvec3& centre,
    std::vector<Triangle>& triangles);

  // Neighbours on an edge of two triangles agree afterwards. Where more than two meet, patches of
  // triangles end. False with a reason in `error` where the surface is open or has only one side.
  bool OrientAlike(std::string& error);

  // Patch by patch, by a tree of the same triangles; those that bound nothing vanish.
  void OrientOutwards(const SurfaceTree& tree);

private:
  int JudgePatch(const SurfaceTree& tree, const std::vector<int>& patch) const;
  bool IsInsideFrom(const SurfaceTree& tree, int triangle, double side) const;
  glm::dvec3 GetAreaVector(int triangle) const;

  const std::vector<glm::dvec3>& Points;
  const glm::dvec3 Centre;
  std::vector<Triangle>& Triangles;
  std::vector<int> Patches; // of triangles that are oriented alike, by triangle
  int PatchCount = 0;
};
}

#endif
