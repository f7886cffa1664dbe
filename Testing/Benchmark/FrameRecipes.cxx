// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
#include "FrameChanges.h"
#include "FrameContent.h"
#include "FrameQuadrature.h"
#include "FrameScene.h"

#include "vtkActor.h"
#include "vtkAppendPolyData.h"
#include "vtkCamera.h"
#include "vtkCellArray.h"
#include "vtkLight.h"
#include "vtkPlaneSource.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"
#include "vtkPolyDataAlgorithm.h"
#include "vtkSmartPointer.h"
#include "vtkSphereSource.h"

#include <cmath>

namespace benchmarks
{
namespace
{
vtkSmartPointer<vtkPolyData> Make(vtkPolyDataAlgorithm* source)
{
  source->Update();
  return source->GetOutput();
}

// 2 * theta * (phi - 2) triangles.
vtkSmartPointer<vtkPolyData> MakeSphere(
  double x, double y, double z, double radius, int theta, int phi)
{
  vtkNew<vtkSphereSource> sphere;
  sphere->SetCenter(x, y, z);
  sphere->SetRadius(radius);
  sphere->SetThetaResolution(theta);
  sphere->SetPhiResolution(phi);
  return Make(sphere);
}

void AddFloor(FrameScene& scene)
{
  vtkNew<vtkPlaneSource> floor;
  floor->SetOrigin(-20.0, 0.0, 20.0);
  floor->SetPoint1(20.0, 0.0, 20.0);
  floor->SetPoint2(-20.0, 0.0, -20.0);
  scene.Add(Make(floor));
}

void LookAtSquare(FrameScene& scene)
{
  vtkCamera* camera = scene.Renderer->GetActiveCamera();
  camera->SetPosition(0.0, 4.0, 11.0);
  camera->SetFocalPoint(0.0, 1.2, 0.0);
  camera->SetClippingRange(0.1, 60.0);
}

// n by n places in the square of half width 4.
double PlaceOf(int i, int n) { return 8.0 * (i + 0.5) / n - 4.0; }

//------------------------------------------------------------------------------
// 25 actors, 27 600 triangles; no lamp.
void AddBalls(FrameScene& scene)
{
  for (int i = 0; i < 25; ++i)
  {
    scene.Add(
      MakeSphere(PlaceOf(i % 5, 5), 0.7 + 0.4 * ((7 * i) % 5), PlaceOf(i / 5, 5), 0.45, 24, 25));
  }
  AddFloor(scene);
  LookAtSquare(scene);
}

void FillSmall(FrameScene& scene)
{
  AddBalls(scene);
  scene.AddLamp(0.6, 4.5, -0.8);
}

// The nearer the lamp to the spheres, the more of the air is in their shadows.
void FillShade(FrameScene& scene, double x, double y, double z)
{
  AddBalls(scene);
  scene.AddLamp(x, y, z);
}

// n by n spheres in 25 actors, each of 2 * resolution * (resolution - 1) triangles.
void FillCrowd(FrameScene& scene, int n, int resolution)
{
  for (int actor = 0; actor < 25; ++actor)
  {
    vtkNew<vtkAppendPolyData> append;
    for (int i = n * n * actor / 25; i < n * n * (actor + 1) / 25; ++i)
    {
      append->AddInputData(MakeSphere(PlaceOf(i % n, n), 0.3 + 0.45 * ((7 * i) % 5),
        PlaceOf(i / n, n), 3.0 / n, resolution, resolution + 1));
    }
    scene.Add(Make(append));
  }
  AddFloor(scene);
  scene.AddLamp(0.6, 4.5, -0.8);
  LookAtSquare(scene);
}

// 324 spheres: a million triangles, 30 000 silhouette edges.
void FillHeavy(FrameScene& scene) { FillCrowd(scene, 18, 40); }

//------------------------------------------------------------------------------
// A plate with n by n square holes, each half as wide as its cell.
vtkSmartPointer<vtkPolyData> MakeGrid(int n, double half, double height)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> quads;
  const int side = 2 * n + 1;
  for (int i = 0; i < side * side; ++i)
  {
    const int row = i / side;
    const int column = i % side;
    points->InsertNextPoint(
      half * (column / double(n) - 1.0), height, half * (row / double(n) - 1.0));
  }
  for (int j = 0; j + 1 < side; ++j)
  {
    for (int i = 0; i + 1 < side; ++i)
    {
      if (i % 2 == 0 || j % 2 == 0)
      {
        const vtkIdType a = j * side + i;
        const vtkIdType corners[4] = { a, a + 1, a + side + 1, a + side };
        quads->InsertNextCell(4, corners);
      }
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(quads);
  return data;
}

void FillShafts(FrameScene& scene)
{
  scene.Add(MakeGrid(64, 2.0, 3.0));
  AddFloor(scene);
  vtkLight* spot = scene.AddLamp(0.0, 6.0, 0.0);
  spot->SetFocalPoint(0.0, 0.0, 0.0);
  spot->SetPositional(true);
  spot->SetConeAngle(30.0);
  spot->SetExponent(0.0);
  LookAtSquare(scene);
}

void FillLights(FrameScene& scene, int count)
{
  AddBalls(scene);
  for (int k = 0; k < count; ++k)
  {
    const double turn = 2.399963 * k; // the golden angle spreads any number of lamps
    const double r = 0.9 * std::sqrt(static_cast<double>(k));
    scene.AddLamp(0.6 + r * std::cos(turn), 4.5, -0.8 + r * std::sin(turn));
  }
}

// One sphere: silhouettes grow with the square root of the triangles.
void FillMesh(FrameScene& scene, int triangles)
{
  const int n = static_cast<int>(std::lround(std::sqrt(triangles / 2.0)));
  scene.Add(MakeSphere(0.0, 1.6, 0.0, 1.2, n, n + 2));
  AddFloor(scene);
  scene.AddLamp(0.6, 4.5, -0.8);
  LookAtSquare(scene);
}

//------------------------------------------------------------------------------
// A flat disc, its border divided into `edges`, of as many rings as make about that many triangles.
// Its silhouette is its border: edges and triangles can be chosen apart while the shadow stays.
vtkSmartPointer<vtkPolyData> MakeDisc(int edges, int triangles, double radius, double height)
{
  const auto rings = static_cast<int>(std::lround((triangles / double(edges) + 1.0) / 2.0));
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> polys;
  points->InsertNextPoint(0.0, height, 0.0);
  for (int i = 0; i < rings * edges; ++i)
  {
    const double turn = 2.0 * 3.14159265358979324 * (i % edges) / edges;
    const int ring = i / edges + 1;
    const double r = radius * ring / rings;
    points->InsertNextPoint(r * std::cos(turn), height, r * std::sin(turn));
  }
  for (int i = 0; i < rings * edges; ++i)
  {
    const vtkIdType a = 1 + i;
    const vtkIdType b = 1 + i - i % edges + (i + 1) % edges;
    const bool isFirst = i < edges; // around the centre
    const vtkIdType outer[3] = { a, b, isFirst ? 0 : a - edges };
    polys->InsertNextCell(3, outer);
    if (!isFirst)
    {
      const vtkIdType inner[3] = { b, b - edges, a - edges };
      polys->InsertNextCell(3, inner);
    }
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(points);
  data->SetPolys(polys);
  return data;
}

void FillDisc(FrameScene& scene, int edges, int triangles)
{
  scene.Add(MakeDisc(edges, triangles, 1.2, 1.6));
  AddFloor(scene);
  scene.AddLamp(0.6, 4.5, -0.8);
  LookAtSquare(scene);
}

//------------------------------------------------------------------------------
std::vector<Way> AllWays(const std::vector<int>& steps)
{
  std::vector<Way> ways = { MakePlain(), MakeUnshadowed(), MakePlanes(), MakeShadowMap(64) };
  for (int n : steps)
  {
    ways.push_back(MakeRayMarch(n));
  }
  return ways;
}
}

//------------------------------------------------------------------------------
std::vector<SceneRecipe> MakeRecipes()
{
  const std::vector<Way> brief = { MakePlain(), MakeUnshadowed(), MakePlanes() };
  const std::vector<Way> moving = { MakePlain(), MakePlanes(), MakePlanes(true) };
  std::vector<SceneRecipe> recipes;
  const auto add = [&recipes](const std::string& name, const std::function<void(FrameScene&)>& fill,
                     const std::vector<Way>& ways, SceneGroup group = SceneGroup::None) {
    recipes.push_back({ name, fill, nullptr, "", nullptr, 800, 600, ways, group });
  };
  std::vector<Way> ways = AllWays({ 32, 64, 256, 1024, 2048 });
  ways.push_back(MakeRayMarchTo(2e-3));
  add("small", FillSmall, ways);
  add(
    "multiple",
    [](FrameScene& scene) {
      FillSmall(scene);
      scene.Medium->MultipleScatteringOn();
    },
    brief);
  add("antialiasing", FillSmall,
    { MakePlain(), MakeSmooth(MakePlain(), Antialiasing::Window), MakePlanes(),
      MakeSmooth(MakePlanes(), Antialiasing::Window), MakeSmooth(MakePlanes(), Antialiasing::Edges),
      MakeSmooth(MakePlanes(), Antialiasing::Larger) });
  add("heavy", FillHeavy, AllWays({ 64, 256 }));
  add("shafts", FillShafts, AllWays({ 64, 256 }));
  const std::vector<Way> errors = { MakePlain(), MakeUnshadowed(), MakePlanes(), MakeRayMarch(64),
    MakeRayMarchTo(2e-3) };
  const auto addShade = [&](const std::string& name, double x, double y, double z) {
    add(
      "shade/" + name, [x, y, z](FrameScene& scene) { FillShade(scene, x, y, z); }, errors);
  };
  addShade("above", 0.6, 3.0, -0.8);
  addShade("among", 0.8, 1.2, 0.8);
  addShade("close", 0.0, 2.2, -0.8);
  for (int count : { 1, 4, 16 })
  {
    add(
      "lights/" + std::to_string(count), [count](FrameScene& scene) { FillLights(scene, count); },
      brief, SceneGroup::Lights);
  }
  const int sizes[4][2] = { { 400, 300 }, { 800, 600 }, { 1280, 960 }, { 1920, 1080 } };
  for (const auto& size : sizes)
  {
    recipes.push_back({ "sizes/" + std::to_string(size[0]) + "x" + std::to_string(size[1]),
      FillSmall, nullptr, "", nullptr, size[0], size[1], brief, SceneGroup::Sizes });
  }
  for (int triangles : { 10000, 100000, 1000000, 3000000 })
  {
    add(
      "mesh/" + std::to_string(triangles),
      [triangles](FrameScene& scene) { FillMesh(scene, triangles); }, brief);
  }
  for (int triangles : { 10000, 100000, 1000000, 3000000 })
  {
    add(
      "triangles/" + std::to_string(triangles),
      [triangles](FrameScene& scene) { FillDisc(scene, 256, triangles); }, brief);
  }
  for (int edges : { 256, 2048, 16384, 131072 })
  {
    add(
      "edges/" + std::to_string(edges),
      [edges](FrameScene& scene) { FillDisc(scene, edges, 1000000); }, brief);
  }
  add(
    "crowd", [](FrameScene& scene) { FillCrowd(scene, 30, 24); }, brief);
  add("moving", FillHeavy, moving);
  for (const std::vector<SceneRecipe>& more :
    { MakeContentRecipes(), MakeChangeRecipes(FillSmall), MakeQuadratureRecipes(FillSmall) })
  {
    recipes.insert(recipes.end(), more.begin(), more.end());
  }
  return recipes;
}
}
