// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadows of meshes of all kinds, above all of those that are not closed and tidy, against brute
// force (see AirlightTestBruteForce.h).

#include "AirlightTestBodies.h"
#include "AirlightTestCompareScene.h"

#include "vtkCubeSource.h"
#include "vtkCylinderSource.h"
#include "vtkPlaneSource.h"
#include "vtkRegularPolygonSource.h"
#include "vtkSphereSource.h"
#include "vtkStripper.h"
#include "vtkTriangleFilter.h"

#include <cstdlib>
#include <random>

using namespace airlight_test;

namespace
{
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

vtkSmartPointer<vtkPolyData> MakeSphere(const glm::dvec3& centre, double radius, int resolution)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(centre.x, centre.y, centre.z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(resolution);
  sphere->SetPhiResolution(resolution);
  return Make(sphere);
}

// Each triangle alone, with its own points, wound at random on request.
vtkSmartPointer<vtkPolyData> Scatter(vtkPolyData* data, bool flip)
{
  vtkNew<vtkMatrix4x4> identity;
  std::vector<Triangle> triangles = GetTriangles(data, identity);
  std::mt19937 random(7);
  for (Triangle& t : triangles)
  {
    if (flip && random() % 2 == 0)
    {
      std::swap(t.B, t.C);
    }
  }
  return MakeSoup(triangles);
}

//------------------------------------------------------------------------------
void TestOpenCylinder()
{
  Scene scene;
  scene.AddPointLight({ 3, 4, 2 });
  AddFloor(scene);
  vtkNew<vtkCylinderSource> cylinder;
  cylinder->CappingOff();
  cylinder->SetResolution(40);
  cylinder->SetHeight(3.0);
  cylinder->SetRadius(1.2);
  scene.Add(cylinder, [](vtkActor* actor) { actor->RotateWXYZ(35, 1, 0, 1); });
  CompareScene("open cylinder", scene);
}

//------------------------------------------------------------------------------
void TestFlipped()
{
  // The points stay shared: only the windings differ.
  vtkSmartPointer<vtkPolyData> sphere = MakeSphere({ 0, 0, 0 }, 1.6, 16);
  std::mt19937 random(11);
  vtkNew<vtkCellArray> cells;
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (sphere->GetPolys()->InitTraversal(); sphere->GetPolys()->GetNextCell(size, ids);)
  {
    const bool flip = random() % 2 == 0;
    const vtkIdType turned[3] = { ids[0], ids[flip ? 2 : 1], ids[flip ? 1 : 2] };
    cells->InsertNextCell(3, turned);
  }
  sphere->SetPolys(cells);
  Scene scene;
  scene.AddPointLight({ -3, 3, 3 });
  AddFloor(scene);
  scene.Add(sphere);
  CompareScene("randomly flipped triangles", scene);
}

//------------------------------------------------------------------------------
void TestThreeOnOneEdge()
{
  vtkNew<vtkPoints> points;
  const double corners[5][3] = { { 0, -1, 0 }, { 0.2, 1.5, 0.1 }, { 2, 0, 0.3 }, { -1.5, 0, 1 },
    { -0.5, 0.3, -2 } };
  for (const double* corner : corners)
  {
    points->InsertNextPoint(corner);
  }
  vtkNew<vtkCellArray> cells;
  for (vtkIdType tip = 2; tip < 5; ++tip)
  {
    const vtkIdType ids[3] = { 0, 1, tip };
    cells->InsertNextCell(3, ids);
  }
  vtkNew<vtkPolyData> fan;
  fan->SetPoints(points);
  fan->SetPolys(cells);
  Scene scene;
  scene.AddPointLight({ 2, 3, 4 });
  AddFloor(scene);
  scene.Add(fan);
  CompareScene("three triangles on one edge", scene);
}

//------------------------------------------------------------------------------
void TestDuplicatedVertices()
{
  Scene scene;
  scene.AddPointLight({ 3, 3, 1 });
  AddFloor(scene);
  scene.Add(Scatter(MakeSphere({ 0.5, 0, 0 }, 1.4, 14), false));
  scene.Add(Scatter(MakeSphere({ -2.5, 0.5, 0 }, 0.8, 10), true));
  CompareScene("every triangle with its own vertices", scene);
}

//------------------------------------------------------------------------------
void TestInterpenetrating()
{
  Scene scene;
  scene.AddPointLight({ 4, 4, 4 });
  AddFloor(scene);
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-1.5, 1.5);
  for (int i = 0; i < 6; ++i)
  {
    const glm::dvec3 centre(2.0 * uniform(random), uniform(random), uniform(random));
    scene.Add(MakeSphere(centre, 0.9, 9));
    vtkNew<vtkCubeSource> cube;
    cube->SetXLength(1.8);
    scene.Add(cube, [&](vtkActor* actor) {
      actor->SetPosition(centre.x + 0.4, centre.y, centre.z);
      actor->RotateWXYZ(50 * i, 1, 2, 3);
    });
  }
  CompareScene("interpenetrating spheres and boxes", scene);
}

//------------------------------------------------------------------------------
void TestSingleTriangle()
{
  Scene scene;
  scene.AddPointLight({ 1, 4, 0 });
  scene.Add(MakeSoup({ { { -2, 0, -1 }, { 2, 0.5, 0 }, { 0, 0.2, 2 } } }));
  CompareScene("single triangle", scene);
}

//------------------------------------------------------------------------------
void TestPolygonsAndStrips()
{
  Scene scene;
  scene.AddPointLight({ -1, 4, 3 });
  AddFloor(scene);
  vtkNew<vtkPlaneSource> quads;
  quads->SetResolution(5, 3);
  scene.Add(quads, [](vtkActor* actor) {
    actor->SetScale(2.0);
    actor->SetPosition(-2, 0, 0);
    actor->RotateWXYZ(70, 1, 0, 0.4);
  });
  vtkNew<vtkRegularPolygonSource> polygon;
  polygon->SetNumberOfSides(11);
  polygon->GeneratePolylineOff();
  polygon->SetRadius(1.0);
  polygon->SetCenter(0.3, 0.5, 1);
  polygon->SetNormal(0.5, 1, 0.2);
  scene.Add(polygon);
  vtkNew<vtkTriangleFilter> triangulate;
  triangulate->SetInputData(MakeSphere({ 2.5, 0, 0 }, 1.0, 12));
  vtkNew<vtkStripper> stripper;
  stripper->SetInputConnection(triangulate->GetOutputPort());
  vtkSmartPointer<vtkPolyData> strips = Make(stripper);
  Check(strips->GetNumberOfStrips() > 0, "the stripper makes strips");
  scene.Add(strips);
  CompareScene("quads, polygons and strips", scene);
}

//------------------------------------------------------------------------------
void TestBadTriangles()
{
  Scene scene;
  scene.AddPointLight({ 2, 4, 2 });
  AddFloor(scene);
  vtkNew<vtkMatrix4x4> identity;
  std::vector<Triangle> triangles = GetTriangles(MakeSphere({ 0, 0, 0 }, 1.5, 10), identity);
  triangles.push_back({ { 1, 1, 1 }, { 1, 1, 1 }, { 1, 1, 1 } });
  triangles.push_back({ { -2, 1, 1 }, { -3, 1, 1 }, { -2, 1, 1 } });
  triangles.push_back({ { -2, 0, 0 }, { 0, 0, 0 }, { 2, 0, 0 } });
  triangles.push_back({ { nan, 0, 0 }, { 2, 1, 0 }, { 2, 0, 1 } });
  triangles.push_back({ { 3, 0, 0 }, { 2, nan, 0 }, { 2, 0, 1 } });
  triangles.push_back({ { 2, 1.5, 0 }, { 3, 1.8, 0 }, { 2.5, 1.5, 1 } });
  scene.Add(MakeSoup(triangles));
  CompareScene("degenerate and undefined triangles", scene);
}

//------------------------------------------------------------------------------
void TestEdgeOnSheets()
{
  Scene scene;
  scene.AddPointLight({ 2, 1, 1 });
  AddFloor(scene);
  // The plane x = 2 holds the light: it casts nothing. The plane x = 0 holds the camera: it is
  // seen as nothing and casts. The plane y = 1 holds both.
  scene.Add(MakeSoup({ { { 2, -1, -3 }, { 2, 3, -3 }, { 2, 0, -1 } } }));
  scene.Add(MakeSoup({ { { 0, -1, -1 }, { 0, 2, -1 }, { 0, 0, 2 } } }));
  scene.Add(MakeSoup({ { { -3, 1, -1 }, { -2, 1, -1 }, { -3, 1, 2 } } }));
  CompareScene("sheets through the light and the camera", scene);
}

//------------------------------------------------------------------------------
void TestSheetStack()
{
  // Coincident sheets and sheets that touch in an edge: volumes that begin where others end.
  Scene scene;
  scene.AddPointLight({ 0.5, 4, 1 });
  AddFloor(scene);
  const Triangle left = { { -2, 0, -1 }, { 0, 0, -1 }, { 0, 0, 1.5 } };
  const Triangle right = { { 0, 0, -1 }, { 2, 0.4, -1 }, { 0, 0, 1.5 } };
  scene.Add(MakeSoup({ left, left, right }));
  scene.Add(MakeSoup({ left, right }));
  CompareScene("coincident and touching sheets", scene);
}

//------------------------------------------------------------------------------
// Edges of many triangles: a triangle that is there five times, and a single one beside it on a
// common edge. Rays that leave the fivefold shadow through the common edge are still in the single
// one. There shadow planes have to count as many shadows as they did where the rays entered.
void TestHeavyEdges()
{
  const glm::dvec3 a(-3.0, 1.0, 0.0);
  const glm::dvec3 b(3.0, 1.0, 0.0);
  Scene scene;
  std::vector<Triangle> triangles(5, { a, b, { 0.0, 1.0, 3.0 } });
  triangles.push_back({ b, a, { 0.0, 1.0, -3.0 } });
  scene.Add(MakeSoup(triangles));
  scene.AddPointLight({ 0.0, 4.0, 0.0 });
  CompareScene("five triangles in one beside a single one", scene);
}
}

//------------------------------------------------------------------------------
int TestShadowMeshes(int, char*[])
{
  TestOpenCylinder();
  TestFlipped();
  TestThreeOnOneEdge();
  TestDuplicatedVertices();
  TestInterpenetrating();
  TestSingleTriangle();
  TestPolygonsAndStrips();
  TestBadTriangles();
  TestEdgeOnSheets();
  TestSheetStack();
  TestHeavyEdges();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
