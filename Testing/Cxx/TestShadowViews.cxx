// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadows for all ways to place camera, lights, medium and props, against brute force (see
// AirlightBruteForce.h).

#include "AirlightCompareScene.h"

#include "vtkAssembly.h"
#include "vtkCellType.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkCompositePolyDataMapper2.h"
#include "vtkConeSource.h"
#include "vtkCubeSource.h"
#include "vtkDataSetMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkPlaneSource.h"
#include "vtkSphereSource.h"
#include "vtkUnstructuredGrid.h"

#include <cstdlib>

using namespace airlighttest;

namespace
{
vtkSmartPointer<vtkPolyData> MakeSphere(const glm::dvec3& centre, double radius)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(centre.x, centre.y, centre.z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(12);
  sphere->SetPhiResolution(12);
  return Make(sphere);
}

// A horizontal rectangle around a point.
vtkSmartPointer<vtkPolyData> MakePlate(const glm::dvec3& centre, double dx, double dz)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(centre.x - dx, centre.y, centre.z + dz);
  plane->SetPoint1(centre.x + dx, centre.y, centre.z + dz);
  plane->SetPoint2(centre.x - dx, centre.y, centre.z - dz);
  return Make(plane);
}

void AddFloor(Scene& scene) { scene.Add(MakePlate({ 0, -2.5, -1 }, 8, 7)); }

void AddThreeBodies(Scene& scene)
{
  AddFloor(scene);
  scene.Add(MakeSphere({ -1.5, 0, 0 }, 1.0));
  scene.Add(MakeSphere({ 1.2, 0.5, 1 }, 0.7));
  vtkNew<vtkConeSource> cone;
  cone->SetCenter(0.5, -1, -2);
  cone->SetHeight(2.0);
  scene.Add(cone);
}

//------------------------------------------------------------------------------
void TestCameraInShadow()
{
  Scene scene;
  // Above the camera, so that the way from the light passes through the middle of each plate:
  // through a diagonal, that is the edge of two triangles.
  scene.AddPointLight({ 0, 9, 10 });
  AddThreeBodies(scene);
  for (int i = 0; i < 4; ++i)
  {
    scene.Add(MakePlate({ 0, 4.0 + i, 10 }, 1.0 + 0.1 * i, 2.0));
  }
  CompareScene("camera four shadows deep", scene);
}

void TestCameraInsideBody()
{
  Scene closed;
  closed.AddPointLight({ 3, 4, 1 });
  closed.Add(MakeSphere({ 0, 1, 10 }, 3.0));
  closed.Window->Render();
  Check(GetColour(closed.GetBuffer("Airlight"), 100, 75) == glm::dvec3(0.0),
    "no light reaches the air inside a closed body");
  Scene open;
  open.AddPointLight({ 3, 4, 1 });
  AddThreeBodies(open);
  vtkNew<vtkSphereSource> shell;
  shell->SetCenter(0, 1, 10);
  shell->SetRadius(2.0);
  shell->SetThetaResolution(24);
  shell->SetPhiResolution(16);
  shell->SetStartPhi(40.0); // around the poles, along z
  shell->SetEndPhi(140.0);
  open.Add(shell);
  CompareScene("camera inside an open shell", open);
}

//------------------------------------------------------------------------------
void TestLightBetween()
{
  Scene scene;
  scene.AddPointLight({ 0.3, 0.4, 4 });
  AddThreeBodies(scene);
  CompareScene("light between camera and objects", scene);
}

void TestLightInsideBody()
{
  Scene scene;
  scene.AddPointLight({ 0, 0.1, 0 });
  AddFloor(scene);
  vtkNew<vtkSphereSource> lantern;
  lantern->SetRadius(1.0);
  lantern->SetThetaResolution(20);
  lantern->SetPhiResolution(20);
  lantern->SetStartTheta(60.0); // a slit all along from pole to pole
  scene.Add(lantern, [](vtkActor* actor) { actor->RotateX(-60); });
  CompareScene("light inside a body with a hole", scene);
}

// The light is singular at the camera, and with it brute force. Only the surfaces are compared: the
// light reaches all that is seen, to the edge of each body.
void TestLightAtCamera()
{
  Scene scene;
  scene.AddPointLight({ 0, 1, 10 });
  scene.AddPointLight({ 3, 3, 2 });
  AddThreeBodies(scene);
  scene.Window->Render();
  int wrong = 0;
  int rays = 0;
  for (int y = 0; y < scene.Height; y += 3)
  {
    for (int x = 0; x < scene.Width; x += 3, ++rays)
    {
      Ray ray = scene.GetRay(x + 0.5, y + 0.5);
      ray.Origin += 1e-6 * ray.Direction;
      const double expected = Trace(scene.Triangles, scene.Lights, scene.Medium, ray).Surface.y;
      const double value = GetColour(scene.GetBuffer("Surface"), x, y).y;
      const bool isFinite = std::isfinite(GetColour(scene.GetBuffer("Airlight"), x, y).y);
      wrong += !isFinite || std::abs(value - expected) > 0.01 * expected + 1e-6;
    }
  }
  std::cout << "light at the camera: " << wrong << " of " << rays << " rays are wrong\n";
  Check(wrong <= rays / 100, "a light at the camera lights what is seen");
}

//------------------------------------------------------------------------------
void TestOutsideTheView()
{
  Scene scene;
  scene.AddPointLight({ 2, 9, 16 });
  AddFloor(scene);
  scene.Add(MakeSphere({ 0.5, 4, 13 }, 0.8)); // behind the camera
  scene.Add(MakePlate({ 3, 4.5, 4 }, 1, 1));  // above the view
  scene.Add(MakeSphere({ -3, 6, 8 }, 0.9));
  CompareScene("casters behind the camera and outside the view", scene);
}

//------------------------------------------------------------------------------
void TestTransformed()
{
  Scene scene;
  scene.AddPointLight({ 3, 5, 3 });
  AddFloor(scene);
  vtkNew<vtkConeSource> cone;
  cone->SetHeight(2.0);
  scene.Add(cone, [](vtkActor* actor) {
    actor->SetScale(-1, 1, 1);
    actor->SetPosition(-3, 0, 0);
    actor->RotateWXYZ(30, 1, 1, 0);
  });
  scene.Add(cone, [](vtkActor* actor) {
    actor->SetScale(0.4, 1.5, 3);
    actor->RotateWXYZ(80, 0, 1, 1);
    actor->SetOrigin(0.3, 0.2, 0.1);
  });
  vtkNew<vtkMatrix4x4> shear;
  const double elements[16] = { 1, 0.7, 0, 2.5, 0, -1.2, 0.3, 0, 0.2, 0, 1, 0, 0, 0, 0, 1 };
  shear->DeepCopy(elements);
  scene.Add(cone, [&](vtkActor* actor) { actor->SetUserMatrix(shear); });
  CompareScene("mirrored, scaled and sheared actors", scene);
}

//------------------------------------------------------------------------------
void TestAssembly()
{
  Scene scene;
  scene.AddPointLight({ 3, 5, 3 });
  AddFloor(scene);
  vtkSmartPointer<vtkPolyData> sphere = MakeSphere({ 0, 0, 0 }, 0.8);
  vtkSmartPointer<vtkActor> first = Scene::MakeActor(sphere);
  vtkSmartPointer<vtkActor> second = Scene::MakeActor(sphere);
  first->SetPosition(-1.5, 0, 0);
  second->SetScale(0.5, 1.5, 1);
  vtkNew<vtkAssembly> inner;
  inner->AddPart(second);
  inner->SetPosition(1.5, 0.5, 0);
  inner->RotateZ(40);
  vtkNew<vtkAssembly> outer;
  outer->AddPart(first);
  outer->AddPart(inner);
  outer->RotateY(25);
  outer->SetScale(1.2);
  scene.Renderer->AddActor(outer);
  vtkNew<vtkMatrix4x4> world;
  vtkMatrix4x4::Multiply4x4(outer->GetMatrix(), first->GetMatrix(), world);
  scene.AddTriangles(sphere, world);
  vtkMatrix4x4::Multiply4x4(outer->GetMatrix(), inner->GetMatrix(), world);
  vtkMatrix4x4::Multiply4x4(world, second->GetMatrix(), world);
  scene.AddTriangles(sphere, world);
  CompareScene("parts of nested assemblies", scene);
}

//------------------------------------------------------------------------------
void TestBlocks()
{
  Scene scene;
  scene.AddPointLight({ 3, 5, 3 });
  AddFloor(scene);
  vtkSmartPointer<vtkPolyData> seen = MakeSphere({ -2, 0, 0 }, 0.9);
  vtkSmartPointer<vtkPolyData> seenInside = MakeSphere({ 2, 0, 0 }, 0.7);
  vtkNew<vtkMultiBlockDataSet> group;
  group->SetBlock(0, seenInside);
  group->SetBlock(1, MakeSphere({ 0, 0, 2 }, 0.6)); // hidden itself
  vtkNew<vtkMultiBlockDataSet> hiddenGroup;
  hiddenGroup->SetBlock(0, MakeSphere({ 0, 1, 0 }, 0.8)); // hidden with its group
  vtkNew<vtkMultiBlockDataSet> root;
  root->SetBlock(0, seen);
  root->SetBlock(1, group);
  root->SetBlock(2, hiddenGroup);
  vtkNew<vtkCompositePolyDataMapper2> mapper;
  mapper->SetInputDataObject(root);
  mapper->ScalarVisibilityOff();
  vtkNew<vtkCompositeDataDisplayAttributes> attributes;
  mapper->SetCompositeDataDisplayAttributes(attributes);
  // Numbered in the order of traversal, groups included: 0 is the root.
  mapper->SetBlockVisibility(4, false);
  mapper->SetBlockVisibility(5, false);
  vtkSmartPointer<vtkActor> actor = Scene::MakeActor(mapper);
  actor->SetPosition(0, 0.3, 0);
  scene.Renderer->AddActor(actor);
  scene.AddTriangles(seen, actor->GetMatrix());
  scene.AddTriangles(seenInside, actor->GetMatrix());
  CompareScene("blocks, one hidden, one in a hidden group", scene);
}

//------------------------------------------------------------------------------
// The mapper that makes a mapper of its own for each block.
void TestBlocksOneByOne()
{
  Scene scene;
  scene.AddPointLight({ 3, 5, 3 });
  AddFloor(scene);
  vtkNew<vtkMultiBlockDataSet> blocks;
  for (unsigned int i = 0; i < 2; ++i)
  {
    blocks->SetBlock(i, MakeSphere({ 3.0 * i - 2.0, 0, 0 }, 0.9 - 0.2 * i));
  }
  vtkNew<vtkCompositePolyDataMapper> mapper;
  mapper->SetInputDataObject(blocks);
  mapper->ScalarVisibilityOff();
  vtkSmartPointer<vtkActor> actor = Scene::MakeActor(mapper);
  scene.Renderer->AddActor(actor);
  for (unsigned int i = 0; i < 2; ++i)
  {
    scene.AddTriangles(vtkPolyData::SafeDownCast(blocks->GetBlock(i)), actor->GetMatrix());
  }
  CompareScene("blocks, each with its mapper", scene);
}

//------------------------------------------------------------------------------
void TestUnstructuredGrid()
{
  vtkNew<vtkUnstructuredGrid> grid;
  vtkNew<vtkPoints> points;
  const double corners[5][3] = { { -1, -1, 0 }, { 1.5, -1, 0.5 }, { 0, 1.5, 0 }, { 0, 0, 2 },
    { 2, 2, 1 } };
  for (const double* corner : corners)
  {
    points->InsertNextPoint(corner);
  }
  grid->SetPoints(points);
  const vtkIdType cells[2][4] = { { 0, 1, 2, 3 }, { 1, 4, 2, 3 } };
  // The reference takes all four sides of each, the one between them twice: the union is the same.
  std::vector<Triangle> sides;
  const auto corner = [&](vtkIdType id) {
    return glm::dvec3(corners[id][0], corners[id][1], corners[id][2]);
  };
  for (const auto& cell : cells)
  {
    grid->InsertNextCell(VTK_TETRA, 4, cell);
    for (int i = 0; i < 4; ++i)
    {
      sides.push_back({ corner(cell[i]), corner(cell[(i + 1) % 4]), corner(cell[(i + 2) % 4]) });
    }
  }
  Scene scene;
  scene.AddPointLight({ 3, 5, 4 });
  AddFloor(scene);
  vtkNew<vtkDataSetMapper> mapper;
  mapper->SetInputData(grid);
  scene.Renderer->AddActor(Scene::MakeActor(mapper));
  scene.Triangles.insert(scene.Triangles.end(), sides.begin(), sides.end());
  CompareScene("unstructured grid", scene);
}
}

//------------------------------------------------------------------------------
int TestShadowViews(int, char*[])
{
  TestCameraInShadow();
  TestCameraInsideBody();
  TestLightBetween();
  TestLightInsideBody();
  TestLightAtCamera();
  TestOutsideTheView();
  TestTransformed();
  TestAssembly();
  TestBlocks();
  TestBlocksOneByOne();
  TestUnstructuredGrid();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
