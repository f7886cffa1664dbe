// SPDX-FileCopyrightText: Copyright (c) Airlight developers
// SPDX-License-Identifier: BSD-3-Clause
//
// Translucent surfaces in fog: each fragment's colour becomes C T(t) + L(0, t) before it is
// blended, with the shadows in the air before it and on it. Against the picture without them and
// brute force (AirlightTestBruteForce.h) up to the surface. VTK's order-independent translucency is
// exact for one layer; its depth peeling keeps 8 bits a layer.

#include "AirlightTestCompareScene.h"
#include "AirlightTestTools.h"

#include "vtkConeSource.h"
#include "vtkPlaneSource.h"

#include <cstdlib>

using namespace airlight_test;

namespace
{
struct Pane
{
  double Z;
  glm::dvec3 Colour;
  double Opacity;
  bool Lit;
};

vtkSmartPointer<vtkPolyData> MakePane(const Pane& pane)
{
  vtkNew<vtkPlaneSource> plane;
  plane->SetOrigin(-30.0, -30.0, pane.Z);
  plane->SetPoint1(30.0, -30.0, pane.Z);
  plane->SetPoint2(-30.0, 30.0, pane.Z);
  return Make(plane);
}

// Adds a pane to the renderer alone; panes cast no shadows here (see TestTranslucentShadowLayers).
vtkSmartPointer<vtkActor> AddPane(Scene& scene, const Pane& pane)
{
  vtkSmartPointer<vtkActor> actor = Scene::MakeActor(MakePane(pane));
  actor->GetProperty()->SetColor(pane.Colour.x, pane.Colour.y, pane.Colour.z);
  actor->GetProperty()->SetOpacity(pane.Opacity);
  actor->GetProperty()->SetLighting(pane.Lit);
  scene.Renderer->AddActor(actor);
  return actor;
}

void AddBodies(Scene& scene)
{
  scene.Add(MakeSphere(1.0), [](vtkActor* actor) { actor->SetPosition(-1.5, 0, 1.3); });
  vtkNew<vtkConeSource> cone;
  cone->SetHeight(2.0);
  scene.Add(cone, [](vtkActor* actor) { actor->SetPosition(1.5, 0.4, 2); });
}

// What the pane's fragment is to be blended as.
glm::dvec3 GetLayer(Scene& scene, const Pane& pane, double px, double py, bool& unstable)
{
  const std::vector<Triangle> bodies = scene.Triangles;
  vtkNew<vtkMatrix4x4> identity;
  for (Triangle t : GetTriangles(MakePane(pane), identity))
  {
    t.Casts = false;
    scene.Triangles.push_back(t);
  }
  const Answer answer = scene.GetAnswer(px, py);
  unstable = unstable || IsUnstable(scene, px, py, answer, 1e-3 * answer.Unshadowed.x);
  const Ray ray = scene.GetRay(px, py);
  const glm::dvec3 end = ray.Origin + answer.Depth * ray.Direction;
  glm::dvec3 passes;
  vtkAirlight::Transmittance(scene.Medium, &ray.Origin.x, &end.x, &passes.x);
  scene.Triangles = bodies;
  return pane.Colour * (pane.Lit ? answer.Surface : passes) + answer.Airlight;
}

//------------------------------------------------------------------------------
// The panes, from the farthest to the nearest, are drawn in this order or the other way round.
// `limit` is absolute, of radiances up to about 1.
enum class DrawOrder
{
  FarFirst,
  NearFirst
};
bool ComparePanes(const std::string& name, Scene& scene, const std::vector<Pane>& panes,
  double limit, DrawOrder order = DrawOrder::FarFirst)
{
  scene.Pass->TranslucentShadowsOff();
  scene.Pass->SetMaximumBoundariesPerPixel(VTK_DOUBLE_MAX); // shadow planes
  scene.Window->Render();
  vtkNew<vtkImageData> before;
  before->DeepCopy(scene.GetBuffer("Radiance"));
  vtkNew<vtkImageData> depth;
  depth->DeepCopy(scene.GetBuffer("Depth"));
  for (size_t i = 0; i < panes.size(); ++i)
  {
    AddPane(scene, panes[order == DrawOrder::FarFirst ? i : panes.size() - 1 - i]);
  }
  scene.Window->Render();
  Comparison radiance(name + ": radiance");
  Random random(11);
  const int rays = 800;
  int excluded = 0;
  int hidden = 0;
  for (int i = 0; i < rays; ++i)
  {
    const int x = random.Index(scene.Width);
    const int y = random.Index(scene.Height);
    glm::dvec3 expected = GetColour(before, x, y);
    const double surface = GetValue(depth, x, y);
    bool unstable = false;
    for (const Pane& pane : panes)
    {
      const Ray ray = scene.GetRay(x + 0.5, y + 0.5);
      const double t = (pane.Z - ray.Origin.z) / ray.Direction.z;
      if (surface >= 0.0 && t > surface)
      {
        ++hidden;
        continue;
      }
      const glm::dvec3 layer = GetLayer(scene, pane, x + 0.5, y + 0.5, unstable);
      expected = glm::mix(expected, layer, pane.Opacity);
    }
    if (unstable)
    {
      ++excluded;
      continue;
    }
    const glm::dvec3 value = GetColour(scene.GetBuffer("Radiance"), x, y);
    const glm::dvec3 error = glm::abs(value - expected);
    radiance.Add(std::max({ error.x, error.y, error.z }), limit, [&] {
      return Text("pixel ", x, " ", y, ": ", value.x, " ", value.y, " ", value.z, ", expected ",
        expected.x, " ", expected.y, " ", expected.z);
    });
  }
  std::cout << name << ": " << excluded << " of " << rays << " rays graze an edge, " << hidden
            << " fragments are behind a body\n";
  Check(excluded < MostExcluded * rays, name + ": too many rays are excluded");
  return AllOk({ &radiance });
}

//------------------------------------------------------------------------------
// A tenth of what closed forms keep, of radiances up to 1.
constexpr double Blended = 1e-5;
// 8 bits a layer, rounded twice.
constexpr double Peeled = 6e-3;

const Pane Front = { 2.5, { 0.9, 0.4, 0.2 }, 0.4, false };
const Pane Back = { -1.0, { 0.2, 0.8, 0.5 }, 0.6, false };
const Pane Lit = { -1.0, { 0.8, 0.9, 1.0 }, 0.5, true };

bool TestOneLayer()
{
  Scene point;
  point.AddPointLight({ 2, 4, 3 }, { 8.0, 6.0, 4.0 });
  AddBodies(point);
  bool ok = ComparePanes("a pane behind two bodies", point, { Back }, Blended);

  Scene lit;
  lit.AddPointLight({ 1, 2, 4 }, { 8.0, 6.0, 4.0 });
  lit.AddPointLight({ -3, 1, 5 }, { 2.0, 3.0, 4.0 });
  AddBodies(lit);
  ok = ComparePanes("a lit pane with shadows on it, two lights", lit, { Lit }, Blended) && ok;

  Scene sun;
  sun.Medium->SetRegionToBox();
  sun.Medium->SetBounds(-4, 4, -3, 3, -2, 4);
  sun.AddDirectionalLight({ 0.3, 1.0, 1.0 }, glm::dvec3(1.0));
  AddBodies(sun);
  sun.Renderer->GetActiveCamera()->ParallelProjectionOn();
  sun.Renderer->GetActiveCamera()->SetParallelScale(3.0);
  ok =
    ComparePanes("sun, box, parallel projection, pane in the middle", sun, { Lit }, Blended) && ok;

  Scene clear;
  clear.Pass->SetShadowTechniqueToNone();
  clear.AddPointLight({ 2, 4, 3 }, { 8.0, 6.0, 4.0 });
  return ComparePanes("without shadows", clear, { Back }, Blended) && ok;
}

// Lists of boundaries that take several draws.
bool TestLongLists()
{
  Scene scene;
  scene.AddPointLight({ 2, 4, 3 }, { 8.0, 6.0, 4.0 });
  Random random(7);
  std::vector<Triangle> leaves;
  for (int i = 0; i < 300; ++i)
  {
    const glm::dvec3 at(
      random.Uniform(0.5, 2.0), random.Uniform(0.0, 2.0), random.Uniform(1.0, 2.0));
    leaves.push_back({ at, at + glm::dvec3(0.4, 0, 0.2), at + glm::dvec3(0, 0.1, 0.4) });
  }
  scene.Add(MakeSoup(leaves));
  const bool ok = ComparePanes("a pane behind leaves", scene, { Back }, Blended);
  double most = 0.0;
  for (int i = 0; i < scene.Width * scene.Height; ++i)
  {
    most =
      std::max(most, GetValue(scene.GetBuffer("BoundaryCount"), i % scene.Width, i / scene.Width));
  }
  Check(most > 130.0, Text("some lists take several draws: ", most));
  return ok;
}

bool TestPeeled(const std::string& name, DrawOrder order)
{
  Scene scene;
  scene.Window->SetAlphaBitPlanes(1);
  scene.Renderer->UseDepthPeelingOn();
  scene.AddPointLight({ 2, 4, 3 }, { 8.0, 6.0, 4.0 });
  AddBodies(scene);
  return ComparePanes(name, scene, { Back, Front }, Peeled, order);
}
}

//------------------------------------------------------------------------------
int TestTranslucentLayers(int, char*[])
{
  const bool one = TestOneLayer();
  const bool longLists = TestLongLists();
  const bool farFirst = TestPeeled("two panes, peeled, the far one first", DrawOrder::FarFirst);
  const bool nearFirst = TestPeeled("two panes, peeled, the near one first", DrawOrder::NearFirst);
  return one && longLists && farFirst && nearFirst && Failures == 0 ? EXIT_SUCCESS : EXIT_FAILURE;
}
