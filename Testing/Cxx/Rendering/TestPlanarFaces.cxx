// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Planar faces of meshes: which outlines are found, and that nothing is taken for a face that
// leaves a place open.

#include "AirlightTestCheck.h"
#include "AirlightTestScene.h"
#include "Casters/AirlightPlanarFaces.h"
#include "Silhouette/AirlightCasterMesh.h"

#include "vtkCubeSource.h"
#include "vtkDiskSource.h"
#include "vtkPlaneSource.h"
#include "vtkTransform.h"
#include "vtkTransformPolyDataFilter.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

using namespace airlight_test;
using airlight::CasterMesh;
using airlight::FindPlanarFaces;
using airlight::PlanarFace;

namespace
{
double GetArea(const PlanarFace& face)
{
  glm::dvec3 twice(0.0);
  for (size_t i = 2; i < face.size(); ++i)
  {
    twice += glm::cross(face[i - 1] - face[0], face[i] - face[0]);
  }
  return 0.5 * glm::length(twice);
}

std::vector<PlanarFace> Find(vtkPolyDataAlgorithm* source)
{
  return FindPlanarFaces(CasterMesh(Make(source)));
}

std::vector<PlanarFace> Find(const std::vector<Triangle>& triangles)
{
  return FindPlanarFaces(CasterMesh(MakeSoup(triangles)));
}

// The rectangle from (x0, y0) to (x1, y1) in the plane z = 0; `turned`: its second half is wound
// the other way.
void AddRectangle(
  std::vector<Triangle>& triangles, double x0, double y0, double x1, double y1, bool turned = false)
{
  const glm::dvec3 a(x0, y0, 0.0);
  const glm::dvec3 b(x1, y0, 0.0);
  const glm::dvec3 c(x1, y1, 0.0);
  const glm::dvec3 d(x0, y1, 0.0);
  triangles.push_back({ a, b, c });
  triangles.push_back(turned ? Triangle{ a, d, c } : Triangle{ a, c, d });
}

//------------------------------------------------------------------------------
// However finely a rectangle is divided, and however it is turned.
void CheckPlanes()
{
  vtkNew<vtkPlaneSource> plane; // 1 x 1
  plane->SetResolution(7, 5);
  vtkNew<vtkTransform> transform;
  transform->RotateWXYZ(37.0, 1.0, 2.0, -0.5);
  transform->Translate(3.0, -2.0, 5.0);
  transform->Scale(8.0, 4.0, 1.0);
  vtkNew<vtkTransformPolyDataFilter> turned;
  turned->SetInputConnection(plane->GetOutputPort());
  turned->SetTransform(transform);
  const std::vector<PlanarFace> faces = Find(turned);
  Check(faces.size() == 1 && faces[0].size() == 4, "a divided rectangle is one face");
  if (faces.size() == 1)
  {
    Check(std::abs(GetArea(faces[0]) - 32.0) < 1e-4, "8 x 4");
    double corners[4] = { 1e9, 1e9, 1e9, 1e9 };
    for (int i = 0; i < 4; ++i)
    {
      const double place[3] = { i % 2 - 0.5, i / 2 - 0.5, 0.0 };
      double expected[3];
      transform->TransformPoint(place, expected);
      for (const glm::dvec3& corner : faces[0])
      {
        corners[i] = std::min(
          corners[i], glm::distance(corner, glm::dvec3(expected[0], expected[1], expected[2])));
      }
    }
    Check(*std::max_element(corners, corners + 4) < 1e-5, "its corners");
  }
  vtkNew<vtkCubeSource> cube;
  cube->SetXLength(2.0);
  double area = 0.0;
  const std::vector<PlanarFace> sides = Find(cube);
  for (const PlanarFace& side : sides)
  {
    area += GetArea(side);
  }
  Check(sides.size() == 6 && std::abs(area - 10.0) < 1e-6, "the six sides of a box, 2 x 1 x 1");

  std::vector<Triangle> triangles;
  AddRectangle(triangles, 0.0, 0.0, 2.0, 1.0, true);
  Check(Find(triangles).size() == 1, "triangles wound either way");
  Check(Find({ triangles[0] }).size() == 1, "one triangle");
}

//------------------------------------------------------------------------------
void CheckOthers()
{
  Check(FindPlanarFaces(CasterMesh(MakeSphere(1.0))).empty(), "a sphere has no face");
  vtkNew<vtkDiskSource> ring;
  Check(Find(ring).empty(), "a ring is no face");

  // Four rectangles around a hole: the hull's outline, but not its area.
  std::vector<Triangle> frame;
  AddRectangle(frame, 0.0, 0.0, 3.0, 1.0);
  AddRectangle(frame, 0.0, 2.0, 3.0, 3.0);
  AddRectangle(frame, 0.0, 1.0, 1.0, 2.0);
  AddRectangle(frame, 2.0, 1.0, 3.0, 2.0);
  Check(Find(frame).empty(), "a frame around a hole is no face");

  // As much as is missing lies elsewhere twice.
  std::vector<Triangle> patched = frame;
  AddRectangle(patched, 0.0, 0.0, 1.0, 1.0);
  Check(Find(patched).empty(), "nor is it where the area is right");

  std::vector<Triangle> corner;
  AddRectangle(corner, 0.0, 0.0, 2.0, 1.0);
  AddRectangle(corner, 0.0, 1.0, 1.0, 2.0);
  Check(Find(corner).empty(), "an L is no face");

  std::vector<Triangle> folded;
  AddRectangle(folded, 0.0, 0.0, 1.0, 1.0);
  AddRectangle(folded, 0.0, 0.0, 1.0, 1.0);
  Check(Find(folded).empty(), "a rectangle that is there twice is left out");

  // The upper half has a point on the seam that the lower one lacks: pixels may fall between them.
  std::vector<Triangle> seam;
  AddRectangle(seam, 0.0, 0.0, 2.0, 1.0);
  AddRectangle(seam, 0.0, 1.0, 1.0, 2.0);
  AddRectangle(seam, 1.0, 1.0, 2.0, 2.0);
  Check(Find(seam).empty(), "triangles that do not meet at a point are no face");

  std::vector<Triangle> hexagon;
  for (int i = 0; i < 6; ++i)
  {
    const auto at = [](int k) {
      return glm::dvec3(std::cos(k * 1.0471975512), std::sin(k * 1.0471975512), 0.0);
    };
    hexagon.push_back({ glm::dvec3(0.0), at(i), at(i + 1) });
  }
  Check(Find(hexagon).empty(), "more than four corners are left out");
  Check(FindPlanarFaces(CasterMesh(vtkNew<vtkPolyData>().Get())).empty(), "nothing");
}
}

//------------------------------------------------------------------------------
int TestPlanarFaces(int, char*[])
{
  CheckPlanes();
  CheckOthers();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
