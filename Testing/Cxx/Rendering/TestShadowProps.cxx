// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Shadows of props of all kinds, however they are transformed, against brute force (see
// AirlightTestBruteForce.h).

#include "AirlightTestBodies.h"
#include "AirlightTestCompareScene.h"

#include "Scene/AirlightVTKVersions.h"
#include "vtkAssembly.h"
#include "vtkCellType.h"
#include "vtkCompositeDataDisplayAttributes.h"
#include "vtkCompositePolyDataMapper.h"
#include "vtkConeSource.h"
#include "vtkDataSetMapper.h"
#include "vtkMultiBlockDataSet.h"
#include "vtkUnstructuredGrid.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
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
  vtkNew<airlight::BlocksMapper> mapper;
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
int TestShadowProps(int, char*[])
{
  TestTransformed();
  TestAssembly();
  TestBlocks();
  TestBlocksOneByOne();
  TestUnstructuredGrid();
  return Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
