// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
/**
 * A closed surface as glsl/AirlightClosedSurface.glsl reads it: triangles oriented outwards in a
 * tree of boxes.
 */

#ifndef AirlightSurfaceTree_h
#define AirlightSurfaceTree_h

#include <glm/glm.hpp>

#include <array>
#include <memory>
#include <string>
#include <vector>

class vtkPolyData;

namespace airlight
{
using Triangle = std::array<int, 3>;

class SurfaceTree
{
public:
  // Of the polygons of a mesh, of any orientation. Inside is what a way from infinity reaches after
  // an odd number of crossings, so that a surface within another one bounds a hole. Null with a
  // reason in `error` where the mesh is empty or not closed.
  static std::shared_ptr<const SurfaceTree> Build(vtkPolyData* mesh, std::string& error);

  const glm::dvec3& GetLeast() const { return this->Least; }
  const glm::dvec3& GetGreatest() const { return this->Greatest; }
  glm::dvec3 GetCentre() const { return 0.5 * (this->Least + this->Greatest); }
  int GetNodeCount() const { return this->NodeCount; }
  const std::vector<glm::dvec4>& GetTexels() const { return this->Texels; }

private:
  bool ReadMesh(vtkPolyData* mesh, std::string& error);
  void DropPairs();
  void Pack();
  void PackNodes(
    std::vector<int>& order, int begin, int end, const std::vector<glm::dvec3>& centres);

  std::vector<glm::dvec3> Points; // from the centre
  std::vector<Triangle> Triangles;
  glm::dvec3 Least{ 0.0 };
  glm::dvec3 Greatest{ 0.0 };
  int NodeCount = 0;
  std::vector<glm::dvec4> Texels;
};
}

#endif
